// Copyright 2026 The sTetro Authors
//
// Licensed under the Apache License, Version 2.0 (the "License");
// you may not use this file except in compliance with the License.
// You may obtain a copy of the License at
//
//     http://www.apache.org/licenses/LICENSE-2.0
//
// Unless required by applicable law or agreed to in writing, software
// distributed under the License is distributed on an "AS IS" BASIS,
// WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
// See the License for the specific language governing permissions and
// limitations under the License.

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

#include "stetro_site/free_space.hpp"
#include "stetro_supervisor/profile/usability_layer.hpp"
#include "support/cell_room.hpp"

namespace stetro_supervisor
{
namespace
{

TEST(UsabilityLayer, AsksWhereTheBodyFits)
{
  const CellRoom room;
  const stetro_site::GridFreeSpace free(room.grid());
  const UsabilityLayer layer(room.caster(), free, {0.0, 0.0}, {4.0, 3.0}, {});
  EXPECT_EQ(layer.columns(), 17);
  EXPECT_EQ(layer.rows(), 13);
  const Usability * middle = layer.at({2.1, 1.4});
  ASSERT_NE(middle, nullptr);
  EXPECT_LT(middle->worst_sigma_m, 0.02) << "four walls about it";
  EXPECT_LT(middle->spectral_radius, 1.0);
  EXPECT_EQ(layer.at({0.4, 2.6}), nullptr) << "in the cupboard's corner nobody fits";
  EXPECT_EQ(layer.at({9.0, 1.0}), nullptr) << "outside";
}

TEST(UsabilityLayer, TellsTheWorstOfThePlacesAbout)
{
  const CellRoom room;
  const stetro_site::GridFreeSpace free(room.grid());
  const UsabilityLayer layer(room.caster(), free, {0.0, 0.0}, {4.0, 3.0}, {});
  const Usability * told = layer.at({2.1, 1.4});
  for (int corner = 0; corner < 4; ++corner) {
    EXPECT_GE(told->spectral_radius, layer.of(8 + (corner & 1), 5 + (corner >> 1)).spectral_radius);
  }
}

TEST(UsabilityLayer, RefusesCornersOutOfOrderAndNoSpacing)
{
  const CellRoom room;
  const stetro_site::GridFreeSpace free(room.grid());
  const auto caster = room.caster();
  EXPECT_THROW(UsabilityLayer(caster, free, {1.0, 0.0}, {0.0, 1.0}, {}), std::invalid_argument);
  UsabilityParams params;
  params.spacing_m = 0.0;
  EXPECT_THROW(UsabilityLayer(caster, free, {0.0, 0.0}, {1.0, 1.0}, params), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_supervisor
