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
#include <random>
#include <stdexcept>

#include "stetro_supervisor/four_beams/cell_reach.hpp"
#include "stetro_supervisor/four_beams/reach_table.hpp"
#include "support/random_room.hpp"

namespace stetro_supervisor
{
namespace
{

TEST(CellReach, ReadsByHand)
{
  const auto grid = drawn({"#...#.?.#"});
  const Reach wall = CellReach(grid, 0.0).from({1, 0});
  EXPECT_EQ(wall.first, 3);
  EXPECT_EQ(wall.last, 3);
  const Reach unknown = CellReach(grid, 0.0).from({5, 0});
  EXPECT_EQ(unknown.first, 1) << "the unknown cell, or";
  EXPECT_EQ(unknown.last, 3) << "the wall behind it";
  EXPECT_FALSE(CellReach(grid, 0.0).from({4, 0}).allows(0, kNoReturn))
    << "nothing stands in a wall";
  EXPECT_FALSE(CellReach(grid, 0.0).from({-3, 9}).allows(0, kNoReturn)) << "nor off the map";
}

class AnyBeam : public testing::TestWithParam<int>
{
};

// Twelve directions, rows and columns among them, half of the sensors off the robot's centre.
TEST_P(AnyBeam, IsWhatTheTableHolds)
{
  std::mt19937 random{static_cast<unsigned>(GetParam())};
  stetro_site::GridFrame frame;
  frame.columns = 45;
  frame.rows = 35;
  frame.resolution_m = 0.1;
  RoomContents contents;
  contents.unknown_patches = 3;
  contents.loose_cells = 15;
  const auto grid = random_room(frame, contents, random);
  std::uniform_real_distribution<double> any(-2.5, 2.5);
  const double heading_rad = GetParam() % 3 == 0 ? GetParam() * 1.5707963267948966 : any(random);
  const Eigen::Vector2d shift =
    GetParam() % 2 == 0 ? Eigen::Vector2d(any(random), any(random)) : Eigen::Vector2d(0.0, 0.0);
  const ReachTable table(grid, heading_rad, shift);
  const CellReach reach(grid, heading_rad, shift);
  for (std::size_t offset = 0; offset < table.cells(); ++offset) {
    const Reach here = reach.from(grid.cell(offset));
    ASSERT_EQ(here.first, table.at(offset).first) << "cell " << offset;
    ASSERT_EQ(here.last, table.at(offset).last) << "cell " << offset;
  }
}

INSTANTIATE_TEST_SUITE_P(Beams, AnyBeam, testing::Range(0, 12));

TEST(CellReach, RefusesABeamFromNowhere)
{
  const auto grid = drawn({"#.#"});
  EXPECT_THROW(CellReach(grid, NAN), std::invalid_argument);
  EXPECT_THROW(CellReach(grid, 0.0, {NAN, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_supervisor
