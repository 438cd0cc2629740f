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
#include <limits>
#include <stdexcept>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"

namespace stetro_site
{
namespace
{

constexpr double kHalfPi = 1.5707963267948966;

// Two rows of three, the wall at column 2 of row 0, an unknown cell at column 0 of row 1.
OccupancyGrid six_cells(double yaw_rad)
{
  GridFrame frame;
  frame.columns = 3;
  frame.rows = 2;
  frame.resolution_m = 0.5;
  frame.origin_m = {10.0, 20.0};
  frame.yaw_rad = yaw_rad;
  return OccupancyGrid(
    frame, {Cell::kFree, Cell::kFree, Cell::kOccupied, Cell::kUnknown, Cell::kFree, Cell::kFree});
}

TEST(OccupancyGrid, RowsRunUpFromTheOrigin)
{
  const OccupancyGrid grid = six_cells(0.0);
  EXPECT_EQ(grid.at({2, 0}), Cell::kOccupied);
  EXPECT_EQ(grid.at({0, 1}), Cell::kUnknown);
  EXPECT_EQ(grid.at({0, 0}), Cell::kFree);
  EXPECT_TRUE(grid.centre_m({2, 0}).isApprox(Eigen::Vector2d(11.25, 20.25)));
  EXPECT_EQ(grid.cell_at({11.25, 20.25}), (CellIndex{2, 0}));
}

TEST(OccupancyGrid, NothingIsKnownOutside)
{
  const OccupancyGrid grid = six_cells(0.0);
  EXPECT_EQ(grid.at({-1, 0}), Cell::kUnknown);
  EXPECT_EQ(grid.at({3, 0}), Cell::kUnknown);
  EXPECT_EQ(grid.at({0, 2}), Cell::kUnknown);
  EXPECT_EQ(grid.cell_at({9.9, 19.9}), (CellIndex{-1, -1}));
}

// A quarter turn takes the grid's x to the floor's y and its y to the floor's -x.
TEST(OccupancyGrid, ATurnedGridLiesAboutItsOrigin)
{
  const OccupancyGrid grid = six_cells(kHalfPi);
  EXPECT_TRUE(grid.centre_m({2, 0}).isApprox(Eigen::Vector2d(10.0 - 0.25, 20.0 + 1.25)));
  EXPECT_EQ(grid.cell_at({9.75, 21.25}), (CellIndex{2, 0}));
}

TEST(OccupancyGrid, CellsAndFloorAreOneAnothersWayBack)
{
  const OccupancyGrid grid = six_cells(0.7);
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      EXPECT_EQ(grid.cell_at(grid.centre_m({column, row})), (CellIndex{column, row}));
    }
  }
  const Eigen::Vector2d point(10.3, 20.9);
  EXPECT_TRUE(grid.to_floor_m(grid.to_cells(point)).isApprox(point));
}

TEST(OccupancyGrid, RefusesWhatIsNoGrid)
{
  GridFrame frame = six_cells(0.0).frame();
  const std::vector<Cell> cells(6, Cell::kFree);
  EXPECT_NO_THROW(OccupancyGrid(frame, cells));
  EXPECT_THROW(OccupancyGrid(frame, std::vector<Cell>(5, Cell::kFree)), std::invalid_argument);
  frame.resolution_m = 0.0;
  EXPECT_THROW(OccupancyGrid(frame, cells), std::invalid_argument);
  frame.resolution_m = 0.5;
  frame.yaw_rad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(OccupancyGrid(frame, cells), std::invalid_argument);
  frame.yaw_rad = 0.0;
  frame.rows = 0;
  EXPECT_THROW(OccupancyGrid(frame, {}), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_site
