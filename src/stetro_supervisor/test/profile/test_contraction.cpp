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

#include "stetro_supervisor/profile/contraction.hpp"
#include "support/wall_caster.hpp"

namespace stetro_supervisor
{
namespace
{

TEST(Contraction, EmptyRoomComesHomeInOneStep)
{
  const WallCaster room(rectangle({0.0, 0.0}, {10.0, 10.0}));
  const auto found = contraction(room, {3.0, 7.0}, {720, 30.0, 0.1});
  ASSERT_TRUE(found);
  EXPECT_LT(found->spectral_radius, 0.02) << "the centroid of a convex room stays where it is";
}

TEST(Contraction, CorridorBeyondReachKnowsNothingLengthwise)
{
  const WallCaster corridor(rectangle({-100.0, 0.0}, {100.0, 2.0}));
  const auto found = contraction(corridor, {0.0, 1.2}, {720, 12.0, 0.1});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->jacobian(0, 0), 1.0, 0.02) << "the profile moves along with the scanner";
  EXPECT_LT(found->jacobian(1, 1), 0.5) << "and not across";
}

}  // namespace
}  // namespace stetro_supervisor
