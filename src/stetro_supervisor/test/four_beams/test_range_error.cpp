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

#include <cmath>
#include <optional>

#include "stetro_supervisor/four_beams/cell_reach.hpp"
#include "stetro_supervisor/four_beams/range_error.hpp"

namespace stetro_supervisor
{
namespace
{

void expect_bounds(const std::optional<DistanceBounds> & bounds, int shortest, int longest)
{
  ASSERT_TRUE(bounds);
  EXPECT_EQ(bounds->shortest, shortest);
  EXPECT_EQ(bounds->longest, longest);
}

TEST(RangeError, BoundsARangeInCells)
{
  const RangeError error{0.03, 0.02, 0.2, 0.25, 1.2, 0.05};
  // D from (1.02 - 0.02) / 1.25 = 0.8 m to (1.02 + 0.03) / 0.8 = 1.3125 m, in cells of 5 cm
  expect_bounds(distance_bounds(1.02, error, 0.05), 16, 27);
}

TEST(RangeError, NoReturnIsAnInequality)
{
  const RangeError error{0.0, 0.0, 0.0, 0.0, 1.2, 0.05};
  expect_bounds(distance_bounds(INFINITY, error, 0.05), 24, kNoReturn);
  expect_bounds(distance_bounds(-INFINITY, error, 0.05), 0, 2);
  EXPECT_FALSE(distance_bounds(NAN, error, 0.05));
}

}  // namespace
}  // namespace stetro_supervisor
