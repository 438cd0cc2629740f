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
#include <cstddef>
#include <memory>
#include <string>

#include "stetro_site/free_space.hpp"
#include "stetro_site/map_file.hpp"

namespace stetro_site
{
namespace
{

/// A map that others made, and what a few lines of Python count and place in its raw pixels.
struct Expected
{
  std::string yaml;
  int columns;
  int rows;
  std::ptrdiff_t occupied;      ///< pixels of level 0
  std::ptrdiff_t free;          ///< of level 254
  std::ptrdiff_t unknown;       ///< of level 205
  bool is_noted;                ///< free_thresh is 0.25 and would make unknown free
  Eigen::Vector2d top_wall_m;   ///< centre of the leftmost black pixel of the uppermost row of any
  Eigen::Vector2d left_wall_m;  ///< of the uppermost black pixel of the leftmost column of any
};

class RecordedMap : public testing::TestWithParam<Expected>
{
protected:
  GridMap map_ = load_map(STETRO_RECORDED "/maps/" + GetParam().yaml);
};

TEST_P(RecordedMap, HasTheCellsOfItsPixels)
{
  const OccupancyGrid & grid = map_.grid;
  EXPECT_EQ(grid.columns(), GetParam().columns);
  EXPECT_EQ(grid.rows(), GetParam().rows);
  const auto count = [&](Cell cell) {
    return std::count(grid.cells().begin(), grid.cells().end(), cell);
  };
  EXPECT_EQ(count(Cell::kOccupied), GetParam().occupied);
  EXPECT_EQ(count(Cell::kFree), GetParam().free);
  EXPECT_EQ(count(Cell::kUnknown), GetParam().unknown);
  ASSERT_EQ(map_.notes.size(), GetParam().is_noted ? 1U : 0U);
  if (GetParam().is_noted) {
    const std::string cells = std::to_string(GetParam().unknown) + " cells of level 205";
    EXPECT_NE(map_.notes[0].find(cells), std::string::npos) << map_.notes[0];
  }
}

TEST_P(RecordedMap, LiesWhereItsOriginSays)
{
  const OccupancyGrid & grid = map_.grid;
  EXPECT_EQ(grid.at(grid.cell_at(GetParam().top_wall_m)), Cell::kOccupied);
  const CellIndex wall = grid.cell_at(GetParam().left_wall_m);
  EXPECT_EQ(grid.at(wall), Cell::kOccupied);
  EXPECT_TRUE(grid.centre_m(wall).isApprox(GetParam().left_wall_m, 1e-9));
  const CellIndex in_x{grid.columns() - 1 - wall.column, wall.row};
  const CellIndex in_y{wall.column, grid.rows() - 1 - wall.row};
  EXPECT_NE(grid.at(in_x), Cell::kOccupied) << "the map is mirrored, or the test no test";
  EXPECT_NE(grid.at(in_y), Cell::kOccupied) << "the map is mirrored, or the test no test";
}

// Property: on a map of walls as real ones are, free space is what is free, and no distance from
// its cells passes a wall or an unknown cell.
TEST_P(RecordedMap, HasRoomOnlyWhereItIsKnown)
{
  const auto grid = std::make_shared<const OccupancyGrid>(map_.grid);
  const GridFreeSpace space{grid};
  for (int row = 0; row < grid->rows(); ++row) {
    for (int column = 0; column < grid->columns(); ++column) {
      const CellIndex cell{column, row};
      const bool is_free = grid->at(cell) == Cell::kFree;
      ASSERT_EQ(space.is_free(grid->centre_m(cell)), is_free) << column << ", " << row;
      ASSERT_EQ(space.distances().distance_m(cell) > 0.0, is_free) << column << ", " << row;
    }
  }
}

// Recounted from the files by splitting off the header and counting bytes (numbers for the ASCII
// one); places are origin + 0.05 (column + 0.5, height - 1 - row + 0.5), rows from the top.
INSTANTIATE_TEST_SUITE_P(
  All, RecordedMap,
  testing::Values(
    Expected{
      "tau_fl4/my_map.yaml",
      457,
      958,
      16741,
      182569,
      238496,
      true,
      {4.125, -1.325},
      {-16.675, -14.375}},
    Expected{
      "tau_lab446/my_map.yaml", 113, 87, 902, 6673, 2256, true, {-1.865, 1.925}, {-2.015, -0.975}},
    Expected{
      "uw_hallway/map.yaml",
      715,
      723,
      19239,
      117936,
      379770,
      true,
      {13.075, 24.475},
      {-18.875, 15.175}},
    Expected{
      "tb3_world/map.yaml", 384, 384, 795, 7939, 138722, false, {-0.775, 2.575}, {-2.925, 0.075}}),
  [](const auto & test) { return test.param.yaml.substr(0, test.param.yaml.find('/')); });

}  // namespace
}  // namespace stetro_site
