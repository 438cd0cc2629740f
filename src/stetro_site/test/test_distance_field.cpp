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
#include <cstdlib>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "stetro_site/distance_field.hpp"

namespace stetro_site
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::shared_ptr<const OccupancyGrid> grid_of(int columns, int rows, std::vector<Cell> cells)
{
  const GridFrame frame{columns, rows, 0.5, {1.0, -2.0}, 0.3};
  return std::make_shared<const OccupancyGrid>(frame, std::move(cells));
}

std::shared_ptr<const OccupancyGrid> random_grid(std::mt19937 & random)
{
  std::uniform_int_distribution<int> side{1, 24};
  std::uniform_real_distribution<double> share{0.0, 1.0};
  const int columns = side(random);
  const int rows = side(random);
  const double walls = 0.3 * share(random) * share(random);
  std::vector<Cell> cells(static_cast<std::size_t>(columns * rows), Cell::kFree);
  for (Cell & cell : cells) {
    const double drawn = share(random);
    cell = drawn < walls ? Cell::kOccupied : drawn < 1.5 * walls ? Cell::kUnknown : Cell::kFree;
  }
  return grid_of(columns, rows, std::move(cells));
}

/// From a point in cells to a square cell, straight from the geometry [m].
double to_square_m(const Eigen::Vector2d & at, int column, int row)
{
  const double x = std::max({column - at.x(), at.x() - column - 1.0, 0.0});
  const double y = std::max({row - at.y(), at.y() - row - 1.0, 0.0});
  return 0.5 * std::hypot(x, y);
}

/// Every wall in turn, and a rim of unknown cells about the grid.
double brute_force_m(const DistanceField & field, const Eigen::Vector2d & at)
{
  double least_m = kInfinity;
  for (int row = -1; row <= field.grid().rows(); ++row) {
    for (int column = -1; column <= field.grid().columns(); ++column) {
      if (field.is_wall({column, row})) {
        least_m = std::min(least_m, to_square_m(at, column, row));
      }
    }
  }
  return least_m;
}

// One wall in the corner of 3 x 4 cells of half a metre, and nothing else that is known of.
TEST(DistanceField, GoesToTheNearestEdgeOrCorner)
{
  std::vector<Cell> cells(12, Cell::kFree);
  cells[0] = Cell::kOccupied;
  const DistanceField field{grid_of(3, 4, cells), Unknown::kFree};
  EXPECT_EQ(field.distance_m(CellIndex{0, 0}), 0.0);
  EXPECT_NEAR(field.distance_m(CellIndex{1, 0}), 0.25, 1e-6);                   // to its edge
  EXPECT_NEAR(field.distance_m(CellIndex{0, 3}), 1.25, 1e-6);                   // 2.5 cells up
  EXPECT_NEAR(field.distance_m(CellIndex{1, 1}), 0.25 * std::sqrt(2.0), 1e-6);  // to its corner
  EXPECT_NEAR(field.distance_m(CellIndex{2, 3}), 0.5 * std::hypot(1.5, 2.5), 1e-6);
}

TEST(DistanceField, TakesUnknownForAWallOnlyToDrive)
{
  std::vector<Cell> cells(15, Cell::kFree);
  cells[7] = Cell::kUnknown;  // the middle of 5 x 3
  const auto grid = grid_of(5, 3, cells);
  const DistanceField to_drive{grid, Unknown::kWall};
  EXPECT_EQ(to_drive.distance_m(CellIndex{2, 1}), 0.0);
  EXPECT_NEAR(to_drive.distance_m(CellIndex{1, 1}), 0.25, 1e-6);
  EXPECT_NEAR(to_drive.distance_m(CellIndex{0, 1}), 0.25, 1e-6) << "the grid's rim";
  const DistanceField to_compare{grid, Unknown::kFree};
  EXPECT_EQ(to_compare.distance_m(CellIndex{2, 1}), kInfinity) << "no wall at all";
  EXPECT_EQ(to_compare.clearance_m(grid->centre_m({2, 1})), kInfinity);
}

TEST(DistanceField, OutsideIsAWallOrTheWayBack)
{
  std::vector<Cell> cells(4, Cell::kFree);
  const auto grid = grid_of(2, 2, cells);
  const Eigen::Vector2d outside = grid->to_floor_m({5.0, 6.0});  // 3 and 4 cells off
  EXPECT_EQ((DistanceField{grid, Unknown::kWall}.clearance_m(outside)), 0.0);
  EXPECT_NEAR((DistanceField{grid, Unknown::kFree}.clearance_m(outside)), 2.5, 1e-12);
  EXPECT_EQ((DistanceField{grid, Unknown::kWall}.clearance_m({1e300, 0.0})), 0.0);
}

TEST(DistanceField, NeedsAGrid)
{
  EXPECT_THROW((DistanceField{nullptr, Unknown::kWall}), std::invalid_argument);
}

// Property: at every cell's centre it is the least of the distances to all walls.
TEST(DistanceField, EqualsBruteForceAtCentres)
{
  std::mt19937 random{20250401};
  for (int i = 0; i < 300; ++i) {
    const auto grid = random_grid(random);
    for (const Unknown unknown : {Unknown::kWall, Unknown::kFree}) {
      const DistanceField field{grid, unknown};
      for (int row = 0; row < grid->rows(); ++row) {
        for (int column = 0; column < grid->columns(); ++column) {
          const double expected_m = brute_force_m(field, {column + 0.5, row + 0.5});
          if (std::isinf(expected_m)) {
            ASSERT_EQ(field.distance_m(CellIndex{column, row}), kInfinity);
          } else {
            ASSERT_NEAR(field.distance_m(CellIndex{column, row}), expected_m, 1e-6)
              << "grid " << i << ", cell " << column << ", " << row;
          }
        }
      }
    }
  }
}

// Property: at any point it is never more than that, and less by no more than 1.5 cells.
TEST(DistanceField, NeverPromisesTooMuchBetweenCentres)
{
  std::mt19937 random{20250402};
  std::uniform_real_distribution<double> share{0.0, 1.0};
  double worst_m = 0.0;
  for (int i = 0; i < 300; ++i) {
    const DistanceField field{random_grid(random), Unknown::kWall};
    for (int k = 0; k < 50; ++k) {
      const Eigen::Vector2d at(
        share(random) * field.grid().columns(), share(random) * field.grid().rows());
      const double expected_m = brute_force_m(field, at);
      const double found_m = field.clearance_m(field.grid().to_floor_m(at));
      ASSERT_LE(found_m, expected_m + 1e-6) << "grid " << i << ", at " << at.transpose();
      worst_m = std::max(worst_m, expected_m - found_m);
    }
  }
  EXPECT_LT(worst_m, 1.5 * 0.5);
}

// A long empty grid, where a distance squared leaves 32 bits: 60 000 cells are 1.4e10 quarters.
TEST(DistanceField, ReachesFar)
{
  std::vector<Cell> cells(120000, Cell::kFree);
  cells[0] = Cell::kOccupied;
  const DistanceField across{grid_of(60000, 2, cells), Unknown::kFree};
  EXPECT_NEAR(across.distance_m(CellIndex{59999, 0}), 0.5 * 59998.5, 1e-2);
  const DistanceField up{grid_of(2, 60000, cells), Unknown::kFree};
  EXPECT_NEAR(up.distance_m(CellIndex{1, 59999}), 0.5 * std::hypot(0.5, 59998.5), 1e-2);
}

}  // namespace
}  // namespace stetro_site
