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

#include <cstring>
#include <vector>

#include "cast_walls.hpp"
#include "random_scenes.hpp"

namespace stetro_site
{
namespace
{

void expect_same_bits(const std::vector<double> & a, const std::vector<double> & b)
{
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0);
}

// A robot's computer reads what a server reads.
TEST(CastWalls, AllInstructionsGiveTheSameBits)
{
  ASSERT_TRUE(available(Instructions::kPlain));
  const std::vector<BeamFan> fans{full_turn(1440, -3.0), {1.0, -0.004, 777}, {0.1, 0.02, 13}};
  for (const std::size_t count : {4U, 100U, 2000U}) {
    const RandomRoom room(count, 20, 21);
    const WallTree walls(room.walls, WallSides::kBoth);
    for (const Eigen::Vector2d & place : room.places) {
      for (const BeamFan & fan : fans) {
        const Scanner scanner{place, fan, 80.0, 0.05};
        std::vector<double> plain;
        cast_walls(walls, scanner, Instructions::kPlain, plain);
        for (const Instructions instructions : {Instructions::kAvx2, Instructions::kAvx512}) {
          if (available(instructions)) {
            std::vector<double> wide;
            cast_walls(walls, scanner, instructions, wide);
            ASSERT_NO_FATAL_FAILURE(expect_same_bits(plain, wide));
          }
        }
      }
    }
  }
}

// Of a wall up the y axis the left is where x is negative.
TEST(CastWalls, AOneSidedWallStopsBeamsFromItsLeft)
{
  const std::vector<Segment> wall{{{0.0, -1.0}, {0.0, 1.0}}};
  for (const double step : {1.0, -1.0}) {
    const auto range = [&](const Eigen::Vector2d & from, double angle_rad) {
      std::vector<double> ranges;
      cast_walls(
        WallTree(wall, WallSides::kLeft), {from, {angle_rad, step, 2}, 10.0, 1.0},
        best_instructions(), ranges);
      return ranges[0];
    };
    EXPECT_NEAR(range({-2.0, 0.5}, 0.0), 2.0, 1e-12);
    EXPECT_GT(range({2.0, 0.5}, 0.5 * kTurn), 10.0);
    EXPECT_GT(range({0.0, -3.0}, 0.25 * kTurn), 10.0) << "in line with it";
  }
}

TEST(CastWalls, RangesAreInMetres)
{
  const WallTree walls({{{4.0, -1.0}, {4.0, 1.0}}}, WallSides::kBoth);
  std::vector<double> ranges_m;
  cast_walls(walls, {{0.0, 0.0}, full_turn(4), 5.0, 0.05}, best_instructions(), ranges_m);
  EXPECT_NEAR(ranges_m[0], 0.2, 1e-15);
}

}  // namespace
}  // namespace stetro_site
