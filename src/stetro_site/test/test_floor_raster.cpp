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

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stetro_site/floor_raster.hpp"
#include "stetro_site/wall_segments.hpp"

namespace stetro_site
{
namespace
{

OccupancyGrid blank(int columns, int rows)
{
  return OccupancyGrid{
    GridFrame{columns, rows, 1.0, {0.0, 0.0}, 0.0},
    std::vector<Cell>(static_cast<std::size_t>(columns * rows), Cell::kUnknown)};
}

std::set<std::pair<int, int>> touched(const OccupancyGrid & grid, const Segment & wall)
{
  std::set<std::pair<int, int>> cells;
  for (const CellIndex cell : touched_cells(grid, wall)) {
    EXPECT_TRUE(grid.contains(cell));
    EXPECT_TRUE(cells.emplace(cell.column, cell.row).second) << "a cell comes once";
  }
  return cells;
}

/// The drawing for people, the highest row first: # wall, . free, space unknown.
std::string picture(const OccupancyGrid & grid)
{
  std::string text;
  for (int row = grid.rows() - 1; row >= 0; --row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const Cell cell = grid.at({column, row});
      text += cell == Cell::kFree ? '.' : cell == Cell::kOccupied ? '#' : ' ';
    }
    text += '\n';
  }
  return text;
}

/// Whether a segment meets a square that is grown by a hair, by another road: it is clipped to the
/// square (Liang and Barsky, A new concept and method for line clipping, 1984).
bool does_touch(const Segment & wall, int column, int row, double hair)
{
  double enter = 0.0;
  double leave = 1.0;
  const Eigen::Vector2d along = wall.to_m - wall.from_m;
  const Eigen::Vector2d low(column - hair, row - hair);
  const Eigen::Vector2d high(column + 1.0 + hair, row + 1.0 + hair);
  for (int axis = 0; axis < 2; ++axis) {
    if (along(axis) == 0.0) {
      if (wall.from_m(axis) < low(axis) || wall.from_m(axis) > high(axis)) {
        return false;
      }
      continue;
    }
    const double a = (low(axis) - wall.from_m(axis)) / along(axis);
    const double b = (high(axis) - wall.from_m(axis)) / along(axis);
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

TEST(TouchedCells, AreBothSidesOfAnEdge)
{
  using Cells = std::set<std::pair<int, int>>;
  const OccupancyGrid grid = blank(4, 4);
  EXPECT_EQ(touched(grid, {{0.5, 0.5}, {2.5, 0.5}}), (Cells{{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_EQ(touched(grid, {{0.5, 1.0}, {0.7, 1.0}}), (Cells{{0, 0}, {0, 1}}));
  EXPECT_EQ(touched(grid, {{2.0, 3.2}, {2.0, 3.4}}), (Cells{{1, 3}, {2, 3}}));
  EXPECT_EQ(touched(grid, {{1.0, 1.0}, {1.0, 1.0}}), (Cells{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
  EXPECT_EQ(touched(grid, {{-2.0, 3.5}, {9.0, 3.5}}).size(), 4U) << "clipped to the grid";
  EXPECT_TRUE(touched(grid, {{-2.0, 5.5}, {9.0, 5.5}}).empty());
}

// Property: every cell that the wall meets is there, and none that it misses by a hair.
TEST(TouchedCells, AreThoseTheWallMeets)
{
  std::mt19937 random{20250404};
  std::uniform_real_distribution<double> place{-3.0, 15.0};
  std::uniform_int_distribution<int> kind{0, 3};
  const OccupancyGrid grid = blank(12, 11);
  for (int i = 0; i < 3000; ++i) {
    Segment wall{{place(random), place(random)}, {place(random), place(random)}};
    switch (kind(random)) {
      case 0:  // corner to corner
        wall = {wall.from_m.array().round().matrix(), wall.to_m.array().round().matrix()};
        break;
      case 1:  // upright
        wall.to_m.x() = wall.from_m.x();
        break;
      case 2:  // level
        wall.to_m.y() = wall.from_m.y();
        break;
      default:
        break;
    }
    const auto cells = touched(grid, wall);
    for (int row = 0; row < grid.rows(); ++row) {
      for (int column = 0; column < grid.columns(); ++column) {
        const bool is_in = cells.count({column, row}) > 0;
        ASSERT_TRUE(is_in || !does_touch(wall, column, row, 0.0)) << i;
        ASSERT_TRUE(!is_in || does_touch(wall, column, row, 1e-3)) << i;
      }
    }
  }
}

// Walls halfway through cells of 1 m, but for the right one, which runs along an edge.
TEST(FloorRaster, DrawsWallsRoomAndObstacles)
{
  const PolygonWalls walls{
    {{0.5, 0.5}, {7.0, 0.5}, {7.0, 3.5}, {4.5, 3.5}, {4.5, 5.5}, {0.5, 5.5}},
    {{{1.9, 2.1}, {4.1, 2.1}, {4.1, 4.9}, {1.9, 4.9}}}};
  const OccupancyGrid grid = rasterise(walls, 1.0);
  EXPECT_EQ(
    picture(grid),
    "#####   \n"
    "#####   \n"
    "########\n"
    "#####.##\n"
    "#.....##\n"
    "########\n");
  EXPECT_EQ(grid.frame().origin_m, Eigen::Vector2d(0.0, 0.0));
}

TEST(FloorRaster, LaysItsCellsOnWholeMultiples)
{
  const PolygonWalls walls{{{-1.03, 2.01}, {0.98, 2.01}, {0.98, 3.02}, {-1.03, 3.02}}, {}};
  const OccupancyGrid grid = rasterise(walls, 0.05);
  EXPECT_TRUE(grid.frame().origin_m.isApprox(Eigen::Vector2d(-1.05, 2.0), 1e-12));
  EXPECT_EQ(grid.columns(), 41);  // -1.05 to 1.00
  EXPECT_EQ(grid.rows(), 21);     // 2.00 to 3.05
  EXPECT_EQ(grid.at(grid.cell_at({0.0, 2.5})), Cell::kFree);
  EXPECT_EQ(grid.at(grid.cell_at({0.0, 2.02})), Cell::kOccupied);
}

// Walls on edges: 6.0 / 0.05 is no whole number of doubles, and both sides must still be drawn.
TEST(FloorRaster, DrawsBothSidesOfAWallOnAnEdge)
{
  const PolygonWalls walls{{{0.3, 0.3}, {6.0, 0.3}, {6.0, 5.1}, {0.3, 5.1}}, {}};
  const OccupancyGrid grid = rasterise(walls, 0.05);
  EXPECT_TRUE(grid.frame().origin_m.isApprox(Eigen::Vector2d(0.25, 0.25), 1e-12));
  EXPECT_EQ(grid.columns(), 116);
  EXPECT_EQ(grid.rows(), 98);
  for (const double x_m : {0.275, 0.325, 5.975, 6.025}) {
    EXPECT_EQ(grid.at(grid.cell_at({x_m, 2.025})), Cell::kOccupied) << x_m;
  }
  EXPECT_EQ(grid.at(grid.cell_at({0.375, 2.025})), Cell::kFree);
}

// Property: of a free cell every corner is free of walls, and of what is not free or wall, none.
TEST(FloorRaster, FreesOnlyWhatIsWhollyFree)
{
  const PolygonWalls walls{
    {{0, 0}, {7.3, 1.1}, {6.0, 6.2}, {3.1, 4.0}, {-1.2, 5.5}},
    {{{2, 2}, {3.5, 1.8}, {2.7, 3.1}}, {{5, 3}, {5.02, 3}, {5.02, 3.02}}}};
  const OccupancyGrid grid = rasterise(walls, 0.1);
  const auto segments = wall_segments(walls);
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const Eigen::Vector2d centre_m = grid.centre_m({column, row});
      const bool is_inside = encloses(walls.outline, centre_m);
      const bool is_solid = encloses(walls.obstacles[0], centre_m);
      switch (grid.at({column, row})) {
        case Cell::kFree:
          ASSERT_TRUE(is_inside && !is_solid);
          ASSERT_GT(distance_m(segments, centre_m), 0.05);
          break;
        case Cell::kUnknown:
          ASSERT_FALSE(is_inside);
          break;
        case Cell::kOccupied:
          ASSERT_TRUE(is_solid || distance_m(segments, centre_m) < 0.0708);
          break;
      }
    }
  }
}

TEST(FloorRaster, RefusesWhatIsNoResolution)
{
  const PolygonWalls walls{{{0, 0}, {10, 0}, {10, 10}}, {}};
  EXPECT_THROW(rasterise(walls, 0.0), std::invalid_argument);
  EXPECT_THROW(rasterise(walls, std::nan("")), std::invalid_argument);
  EXPECT_THROW(rasterise(walls, 1e-4), std::invalid_argument) << "10^10 cells";
  EXPECT_THROW(rasterise({}, 0.1), std::invalid_argument);
}

TEST(FloorRaster, TakesAMapAsItIs)
{
  const auto grid = std::make_shared<const OccupancyGrid>(blank(2, 2));
  EXPECT_EQ(grid_of(GridMapFile{"a.yaml", grid}, 0.3), grid);
  EXPECT_EQ(grid_of(FloorDrawing{}, 0.3), nullptr);
  EXPECT_EQ(grid_of(PolygonWalls{{{0, 0}, {1, 0}, {1, 1}}, {}}, 0.3)->resolution_m(), 0.3);
}

}  // namespace
}  // namespace stetro_site
