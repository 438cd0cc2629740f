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
#include <vector>

#include "cell_borders.hpp"

namespace stetro_site
{
namespace
{

OccupancyGrid grid_of(int columns, int rows, const std::vector<Cell> & cells)
{
  GridFrame frame;
  frame.columns = columns;
  frame.rows = rows;
  frame.resolution_m = 1.0;
  return OccupancyGrid(frame, cells);
}

/// Of the cells beside a unit piece of a border, the one on its left or on its right.
Cell beside(
  const OccupancyGrid & grid, const Eigen::Vector2d & middle, const Eigen::Vector2d & side)
{
  const Eigen::Vector2d at = middle + 0.5 * side;
  return grid.at({static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))});
}

// An occupied cell in the middle of nine.
TEST(CellBorders, OneCellHasFourSides)
{
  std::vector<Cell> cells(9, Cell::kFree);
  cells[4] = Cell::kOccupied;
  const OccupancyGrid grid = grid_of(3, 3, cells);
  EXPECT_EQ(cell_borders(grid, Unknown::kFree).size(), 4U);
  EXPECT_EQ(cell_borders(grid, Unknown::kWall).size(), 8U) << "and the edge of the grid";
}

TEST(CellBorders, StraightBordersAreOnePiece)
{
  const OccupancyGrid grid = grid_of(
    2, 3,
    {Cell::kOccupied, Cell::kFree, Cell::kOccupied, Cell::kFree, Cell::kOccupied, Cell::kFree});
  const std::vector<Segment> borders = cell_borders(grid, Unknown::kFree);
  ASSERT_EQ(borders.size(), 4U);  // a column of three: two long sides, two short
  double length = 0.0;
  for (const Segment & border : borders) {
    length += (border.to_m - border.from_m).norm();
  }
  EXPECT_EQ(length, 8.0);
}

// Property: every unit piece has a cell that stops on its right and one that does not on its left,
// and there are as many as pairs of such neighbours.
TEST(CellBorders, PartWhatStopsFromWhatDoesNot)
{
  std::mt19937 random{17};
  std::uniform_int_distribution<int> kind{0, 2};
  for (const Unknown unknown : {Unknown::kWall, Unknown::kFree}) {
    std::vector<Cell> cells;
    for (int i = 0; i < 20 * 30; ++i) {
      cells.push_back(static_cast<Cell>(kind(random)));
    }
    const OccupancyGrid grid = grid_of(20, 30, cells);
    int pieces = 0;
    for (const Segment & border : cell_borders(grid, unknown)) {
      const Eigen::Vector2d along = (border.to_m - border.from_m).normalized();
      const Eigen::Vector2d left(-along.y(), along.x());
      const int length = static_cast<int>(std::lround((border.to_m - border.from_m).norm()));
      for (int i = 0; i < length; ++i, ++pieces) {
        const Eigen::Vector2d middle = border.from_m + (i + 0.5) * along;
        EXPECT_FALSE(is_wall(beside(grid, middle, left), unknown));
        EXPECT_TRUE(is_wall(beside(grid, middle, -left), unknown));
      }
    }
    int pairs = 0;
    for (int row = -1; row < 30; ++row) {
      for (int column = -1; column < 20; ++column) {
        const bool here = is_wall(grid.at({column, row}), unknown);
        pairs += here != is_wall(grid.at({column + 1, row}), unknown) ? 1 : 0;
        pairs += here != is_wall(grid.at({column, row + 1}), unknown) ? 1 : 0;
      }
    }
    EXPECT_EQ(pieces, pairs);
  }
}

}  // namespace
}  // namespace stetro_site
