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
#include <stdexcept>

#include "pilot.hpp"
#include "sim/stair_world.hpp"

namespace stetro_driver::sim
{
namespace
{

using test::paper_stairs;

TEST(StairWorld, StandsWhereTheSiteFileSays)
{
  const StairWorld world{paper_stairs()};
  EXPECT_EQ(world.steps(), 16);
  EXPECT_NEAR(world.riser_x_m(1, 1.0), 0.0, 1e-12);
  EXPECT_NEAR(world.riser_x_m(16, 1.0), 4.80, 1e-12);  // 15 * 0.32
  EXPECT_NEAR(world.height_m(16), 2.24, 1e-12);        // 16 * 0.14, D1-10
  EXPECT_NEAR(world.length_m(), 5.12, 1e-12);          // 16 * 0.32
  EXPECT_EQ(world.terrain_m(-0.2, 1.0), 0.0);
  EXPECT_NEAR(world.terrain_m(0.33, 1.0), 0.28, 1e-12);
}

TEST(StairWorld, TheTopTreadGoesOnIntoTheLanding)
{
  const StairWorld world{paper_stairs()};
  EXPECT_EQ(world.step_at(4.9, 1.0), 16);
  EXPECT_EQ(world.step_at(7.0, 1.0), 16);
  EXPECT_FALSE(world.cast({4.9, 1.0, 2.31}, {1.0, 0.0, 0.0}, 3.0)) << "no riser N+1";
}

TEST(StairWorld, RaysEndWhereTheyShould)
{
  const StairWorld world{paper_stairs()};
  const auto riser = world.cast({-0.3, 1.0, 0.07}, {1.0, 0.0, 0.0}, 3.0);
  ASSERT_TRUE(riser);
  EXPECT_NEAR(riser->distance_m, 0.3, 1e-12);
  EXPECT_NEAR(riser->cos_incidence, 1.0, 1e-12);
  const auto over = world.cast({-0.3, 1.0, 0.15}, {1.0, 0.0, 0.0}, 3.0);
  ASSERT_TRUE(over);
  EXPECT_NEAR(over->distance_m, 0.62, 1e-12) << "over riser 1, onto riser 2";
  const auto left = world.cast({0.1, 1.0, 0.5}, {0.0, 1.0, 0.0}, 3.0);
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->distance_m, 1.05, 1e-12);
  const auto down = world.cast({0.4, 1.0, 0.315}, {0.0, 0.0, -1.0}, 3.0);
  ASSERT_TRUE(down);
  EXPECT_NEAR(down->distance_m, 0.035, 1e-12);
  const auto slanted = world.cast({0.1, 0.5, 0.5}, {0.6, -0.8, 0.0}, 3.0);
  ASSERT_TRUE(slanted);
  EXPECT_NEAR(slanted->distance_m, 0.625, 1e-12);  // 0.5 / 0.8, the right wall at x 0.475
  EXPECT_NEAR(slanted->cos_incidence, 0.8, 1e-12);
}

TEST(StairWorld, SideWallsGoOnForAMetreOnly)
{
  const StairWorld world{paper_stairs()};
  EXPECT_TRUE(world.cast({-0.99, 1.0, 0.3}, {0.0, -1.0, 0.0}, 3.0));
  EXPECT_FALSE(world.cast({-1.01, 1.0, 0.3}, {0.0, -1.0, 0.0}, 3.0));
  EXPECT_TRUE(world.left_walled(6.1));
  EXPECT_FALSE(world.left_walled(6.13));
}

TEST(StairWorld, RisersEndAtTheSidesOnlyInABuilding)
{
  StairWorld world{paper_stairs()};
  const Vector3 beside{-0.5, 3.0, 0.07};
  EXPECT_TRUE(world.cast(beside, {1.0, 0.0, 0.0}, 3.0));
  EXPECT_TRUE(world.riser_spans(0.0, 3.0));
  world.end_at_sides();
  EXPECT_FALSE(world.cast(beside, {1.0, 0.0, 0.0}, 3.0));
  EXPECT_FALSE(world.riser_spans(0.0, 3.0));
  EXPECT_TRUE(world.cast({-0.5, 1.0, 0.07}, {1.0, 0.0, 0.0}, 3.0));
}

// As built: each riser +-3 mm, each tread +-5 mm, one sigma half of that, over many seeds.
TEST(StairWorld, IsBuiltWithinTolerance)
{
  const SimErrors errors;
  double squares = 0.0;
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const StairWorld world{paper_stairs(), errors, seed};
    for (int k = 1; k <= 16; ++k) {
      const double error_m = world.height_m(k) - world.height_m(k - 1) - 0.14;
      ASSERT_LE(std::abs(error_m), 0.003 + 1e-12);
      ASSERT_LE(std::abs(std::atan(world.riser_slope(k))), 0.2 * 0.01745330);
      sum += error_m;
      squares += error_m * error_m;
      ++count;
    }
    for (int k = 2; k <= 16; ++k) {
      ASSERT_LE(
        std::abs(world.riser_x_m(k, 1.025) - world.riser_x_m(k - 1, 1.025) - 0.32), 0.005 + 1e-9);
    }
    ASSERT_LE(std::abs(world.width_m(0.0) - 2.05), 0.005 + 1e-12);
    ASSERT_LE(std::abs(world.width_m(world.length_m()) - 2.05), 0.005 + 1e-12);
  }
  EXPECT_NEAR(sum / count, 0.0, 1e-4);
  // A normal cut off at two sigma keeps 0.88 of its deviation: 1.32 mm.
  EXPECT_NEAR(std::sqrt(squares / count), 0.00132, 0.00005);
}

TEST(StairWorld, DrawsTheSameStairsFromTheSameSeed)
{
  const StairWorld a{paper_stairs(), SimErrors{}, 7};
  const StairWorld b{paper_stairs(), SimErrors{}, 7};
  const StairWorld c{paper_stairs(), SimErrors{}, 8};
  EXPECT_EQ(a.riser_x_m(9, 0.3), b.riser_x_m(9, 0.3));
  EXPECT_NE(a.riser_x_m(9, 0.3), c.riser_x_m(9, 0.3));
}

TEST(StairWorld, RefusesStairsThatAreNone)
{
  StairShape stairs = paper_stairs();
  stairs.tread_m[3] = -0.32;
  EXPECT_THROW(StairWorld{stairs}, std::invalid_argument);
  EXPECT_THROW(StairWorld{StairShape{}}, std::invalid_argument);
}

}  // namespace
}  // namespace stetro_driver::sim
