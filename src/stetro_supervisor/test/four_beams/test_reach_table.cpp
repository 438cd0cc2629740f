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
#include <random>
#include <stdexcept>

#include "stetro_supervisor/four_beams/reach_table.hpp"
#include "support/random_room.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::Cell;
using stetro_site::CellIndex;
using stetro_site::GridFrame;
using stetro_site::OccupancyGrid;

constexpr double kPi = 3.14159265358979323846;

Reach reach(const ReachTable & table, const OccupancyGrid & grid, CellIndex cell)
{
  return table.at(grid.offset(cell));
}

void expect_reach(const Reach & reach, int first, int last)
{
  EXPECT_EQ(reach.first, first);
  EXPECT_EQ(reach.last, last);
}

TEST(ReachTable, CountsIndexDifferencesAlongARow)
{
  const auto grid = drawn({"#...#.?.#?."});
  const ReachTable east(grid, 0.0);
  expect_reach(reach(east, grid, {1, 0}), 3, 3);
  expect_reach(reach(east, grid, {3, 0}), 1, 1);
  expect_reach(reach(east, grid, {5, 0}), 1, 3);           // the unknown cell, or the wall behind
  expect_reach(reach(east, grid, {10, 0}), 1, kNoReturn);  // beyond the grid
  const ReachTable west(grid, -kPi);
  expect_reach(reach(west, grid, {3, 0}), 3, 3);
  expect_reach(reach(west, grid, {7, 0}), 1, 3);
  EXPECT_FALSE(reach(west, grid, {4, 0}).allows(0, kNoReturn)) << "nothing stands in a wall";
  EXPECT_FALSE(reach(west, grid, {6, 0}).allows(0, kNoReturn)) << "nor where nobody looked";
}

TEST(ReachTable, CountsUpAndDownColumns)
{
  const auto grid = drawn({"#", ".", ".", "#"});
  expect_reach(reach(ReachTable(grid, kPi / 2), grid, {0, 1}), 2, 2);
  expect_reach(reach(ReachTable(grid, -kPi / 2), grid, {0, 1}), 1, 1);
  expect_reach(reach(ReachTable(grid, 5 * kPi / 2), grid, {0, 2}), 1, 1);
}

TEST(ReachTable, IsTheSameBuiltInParts)
{
  std::mt19937 random{20260311};
  const OccupancyGrid grid = random_room({31, 22, 0.05, {0.0, 0.0}, 0.0}, {}, random);
  for (const double heading_rad : {0.0, 0.3, 2.2, -kPi / 2}) {
    const ReachTable whole(grid, heading_rad);
    ReachTableBuilder builder(grid, heading_rad);
    while (!builder.is_done()) {
      ASSERT_GT(builder.work(50), 0u);
    }
    const ReachTable parts = builder.take();
    EXPECT_EQ(parts.first(), whole.first()) << heading_rad;
    EXPECT_EQ(parts.last(), whole.last()) << heading_rad;
  }
}

/// The length of a ray to the first cell that `is_wall`, by the grid lines it crosses [cells].
/** \return nothing if it leaves the grid */
template <class IsWall>
std::optional<double> ray_length(
  const OccupancyGrid & grid, const Eigen::Vector2d & from, double heading_rad, IsWall && is_wall)
{
  const Eigen::Vector2d along(std::cos(heading_rad), std::sin(heading_rad));
  CellIndex cell{static_cast<int>(std::floor(from.x())), static_cast<int>(std::floor(from.y()))};
  const auto to_line = [](double start, int index, double direction) {
    if (direction == 0.0) {
      return std::numeric_limits<double>::infinity();
    }
    return ((direction > 0.0 ? index + 1 : index) - start) / direction;
  };
  for (;;) {
    const double to_column = to_line(from.x(), cell.column, along.x());
    const double to_row = to_line(from.y(), cell.row, along.y());
    if (to_column < to_row) {
      cell.column += along.x() > 0.0 ? 1 : -1;
    } else {
      cell.row += along.y() > 0.0 ? 1 : -1;
    }
    if (!grid.contains(cell)) {
      return std::nullopt;
    }
    if (is_wall(cell)) {
      return std::min(to_column, to_row);
    }
  }
}

class AnyHeading : public testing::TestWithParam<int>
{
};

// The promise of the table: in any world that agrees with the map, from anywhere in a cell.
TEST_P(AnyHeading, HoldsTheLengthFromAnywhereInTheCell)
{
  std::mt19937 random{static_cast<unsigned>(GetParam())};
  GridFrame frame;
  frame.columns = 45;
  frame.rows = 35;
  frame.resolution_m = 0.1;
  RoomContents contents;
  contents.boxes = 4;
  contents.unknown_patches = 3;
  contents.loose_cells = 15;
  const OccupancyGrid grid = random_room(frame, contents, random);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const bool on_axis = GetParam() % 5 == 0;
  const double heading_rad = on_axis ? GetParam() * kPi / 10 : 2 * kPi * share(random);
  const ReachTable table(grid, heading_rad);
  std::vector<bool> is_wall;
  for (const Cell cell : grid.cells()) {
    is_wall.push_back(cell == Cell::kOccupied || (cell == Cell::kUnknown && share(random) < 0.3));
  }
  for (const CellIndex & cell : free_cells(grid)) {
    const Reach held = reach(table, grid, cell);
    for (int i = 0; i < 5; ++i) {
      const Eigen::Vector2d from(cell.column + share(random), cell.row + share(random));
      const auto length = ray_length(
        grid, from, heading_rad, [&](CellIndex met) { return is_wall[grid.offset(met)]; });
      if (length) {
        ASSERT_GE(*length, held.first - 1 - 1e-9) << cell.column << ", " << cell.row;
        ASSERT_LE(*length, held.last + 1e-9) << cell.column << ", " << cell.row;
      } else {
        ASSERT_EQ(held.last, kNoReturn) << cell.column << ", " << cell.row;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, AnyHeading, testing::Range(1, 41));

// Towards a straight wall the bounds are no wider than the corners of its cells make them.
TEST(ReachTable, IsTightBeforeAWall)
{
  GridFrame frame;
  frame.columns = 60;
  frame.rows = 60;
  frame.resolution_m = 0.1;
  std::mt19937 random{1};
  const OccupancyGrid grid = random_room(frame, {0, 0, 1, 0}, random);
  for (const double heading_rad : {0.05, 0.3, 0.7, 2.0, -2.5}) {
    const ReachTable table(grid, heading_rad);
    const double from = 30.5;
    const double to_wall = 28.5;  // to either wall's inner face
    const double length =
      to_wall / std::max(std::abs(std::cos(heading_rad)), std::abs(std::sin(heading_rad)));
    const Reach held = reach(table, grid, {static_cast<int>(from), static_cast<int>(from)});
    EXPECT_NEAR(held.first, length, 4.0) << heading_rad;
    EXPECT_NEAR(held.last, length, 4.0) << heading_rad;
  }
}

// A sensor 2.5 cells ahead of its robot has its wall 2.5 cells nearer: 4.5 +- 0.5 from (1, 0).
TEST(ReachTable, StartsWhereTheSensorIs)
{
  const auto grid = drawn({"#........#"});
  const ReachTable table(grid, 0.0, {2.5, 0.0});
  expect_reach(reach(table, grid, {1, 0}), 5, 6);
  expect_reach(reach(table, grid, {6, 0}), 1, 1);
  const ReachTable whole(grid, 0.0, {3.0, 0.0});
  EXPECT_FALSE(reach(whole, grid, {6, 0}).allows(0, kNoReturn)) << "it would be in the wall";
  const ReachTable back(grid, 0.0, {-1.0, 0.0});
  expect_reach(reach(back, grid, {2, 0}), 8, 8);
}

TEST(ReachTable, RefusesWhatHasNoTable)
{
  const auto grid = drawn({"."});
  EXPECT_THROW(ReachTable(grid, std::nan("")), std::invalid_argument);
  EXPECT_THROW(ReachTable(grid, 0.0, {std::nan(""), 0.0}), std::invalid_argument);
  EXPECT_THROW(ReachTable(drawn({std::string(16001, '.')}), 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_supervisor
