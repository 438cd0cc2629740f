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
#include <random>
#include <string>
#include <vector>

#include "random_scenes.hpp"
#include "stetro_site/grid_caster.hpp"
#include "stetro_tests/counted_allocations.hpp"

namespace stetro_site
{
namespace
{

using Eigen::Vector2d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFar = 1e9;

/// A grid drawn with '#' for occupied, '?' for unknown, anything else free; the top row first.
OccupancyGrid drawn(const std::vector<std::string> & rows, GridFrame frame = {})
{
  frame.columns = static_cast<int>(rows.front().size());
  frame.rows = static_cast<int>(rows.size());
  frame.resolution_m = frame.resolution_m > 0.0 ? frame.resolution_m : 1.0;
  std::vector<Cell> cells;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char drawing : *row) {
      cells.push_back(
        drawing == '#'   ? Cell::kOccupied
        : drawing == '?' ? Cell::kUnknown
                         : Cell::kFree);
    }
  }
  return OccupancyGrid(frame, cells);
}

std::vector<double> cast(
  const OccupancyGrid & grid, const Vector2d & from_m, const BeamFan & fan,
  Unknown unknown = Unknown::kWall, double reach_m = kFar)
{
  std::vector<double> ranges_m;
  GridCaster(grid, unknown).cast(from_m, fan, reach_m, ranges_m);
  return ranges_m;
}

/// Walks a beam cell by cell (Amanatides and Woo) until one stops it or all the grid is behind it.
double walked(
  const OccupancyGrid & grid, const Vector2d & from_m, double angle_rad, Unknown unknown)
{
  const Vector2d at = grid.to_cells(from_m);
  const double angle = angle_rad - grid.frame().yaw_rad;
  const Vector2d beam(std::cos(angle), std::sin(angle));
  CellIndex cell = grid.cell_at(from_m);
  const auto next_border = [](double position, int index, double slope) {
    return slope > 0.0   ? (index + 1 - position) / slope
           : slope < 0.0 ? (index - position) / slope
                         : kInfinity;
  };
  const double end = at.norm() + std::hypot(grid.columns(), grid.rows()) + 2.0;
  double range = 0.0;
  while (range <= end) {
    const Cell here = grid.at(cell);
    if (here == Cell::kOccupied || (here == Cell::kUnknown && unknown == Unknown::kWall)) {
      return range * grid.resolution_m();
    }
    const double x = next_border(at.x(), cell.column, beam.x());
    const double y = next_border(at.y(), cell.row, beam.y());
    range = std::min(x, y);
    (x < y ? cell.column : cell.row) += (x < y ? beam.x() : beam.y()) > 0.0 ? 1 : -1;
  }
  return kInfinity;
}

void expect_as_walked(
  const OccupancyGrid & grid, const Vector2d & from_m, const BeamFan & fan, Unknown unknown)
{
  const std::vector<double> ranges_m = cast(grid, from_m, fan, unknown);
  ASSERT_EQ(ranges_m.size(), fan.count);
  for (std::size_t i = 0; i < fan.count; ++i) {
    const double angle = fan.first_rad + static_cast<double>(i) * fan.step_rad;
    const double wanted_m = walked(grid, from_m, angle, unknown);
    if (std::isinf(wanted_m)) {
      ASSERT_TRUE(std::isinf(ranges_m[i])) << "beam " << i << " from " << from_m.transpose();
    } else {
      ASSERT_NEAR(ranges_m[i], wanted_m, 1e-9 * wanted_m)
        << "beam " << i << " from " << from_m.transpose();
    }
  }
}

OccupancyGrid random_cells(std::mt19937 & random, double share_occupied, double share_unknown)
{
  std::uniform_int_distribution<int> side{1, 70};
  std::uniform_real_distribution<double> at{-20.0, 20.0};
  std::uniform_real_distribution<double> one{0.0, 1.0};
  GridFrame frame;
  frame.columns = side(random);
  frame.rows = side(random);
  frame.resolution_m = 0.02 + one(random);
  frame.origin_m = {at(random), at(random)};
  frame.yaw_rad = at(random);
  std::vector<Cell> cells;
  for (int i = 0; i < frame.columns * frame.rows; ++i) {
    const double drawn_share = one(random);
    cells.push_back(
      drawn_share < share_occupied                   ? Cell::kOccupied
      : drawn_share < share_occupied + share_unknown ? Cell::kUnknown
                                                     : Cell::kFree);
  }
  return OccupancyGrid(frame, cells);
}

// Speckled grids are the hardest: nearly every cell has borders of its own, with gaps at corners.
TEST(GridCaster, ReadsWhatAWalkFromCellToCellReads)
{
  std::mt19937 random{8};
  std::uniform_real_distribution<double> angle{-4.0, 4.0};
  std::uniform_real_distribution<double> share{-0.2, 1.2};
  for (const double occupied : {0.0, 0.002, 0.02, 0.1, 0.3, 0.6, 1.0}) {
    for (int i = 0; i < 40; ++i) {
      const OccupancyGrid grid = random_cells(random, occupied, i % 4 == 0 ? 0.1 : 0.0);
      const Unknown unknown = i % 2 == 0 ? Unknown::kWall : Unknown::kFree;
      const Vector2d place =
        grid.to_floor_m({share(random) * grid.columns(), share(random) * grid.rows()});
      const BeamFan fan =
        i % 3 == 0 ? BeamFan{angle(random), -0.009, 500} : full_turn(720, angle(random));
      ASSERT_NO_FATAL_FAILURE(expect_as_walked(grid, place, fan, unknown)) << "sample " << i;
    }
  }
}

TEST(GridCaster, ReadsRoomsAsAWalkDoes)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    const OccupancyGrid grid = random_grid_room(500, 40, seed, 0.05);
    for (const Vector2d & place : free_places(grid, 5, seed)) {
      ASSERT_NO_FATAL_FAILURE(expect_as_walked(grid, place, full_turn(1440, 0.3), Unknown::kWall));
    }
  }
}

// From where four cells meet it reads as from within the one that the grid names.
TEST(GridCaster, ReadsWhatAWalkReadsFromTheCornersOfCells)
{
  std::mt19937 random{10};
  std::uniform_int_distribution<int> at{0, 39};
  const OccupancyGrid grid = random_grid_room(40, 12, 10);
  for (int i = 0; i < 100; ++i) {
    const Vector2d place(at(random), at(random));
    const BeamFan fan = full_turn(360, 0.001 * i);
    const std::vector<double> ranges_m =
      cast(grid, place, {fan.first_rad + 0.0005, fan.step_rad, 360});
    for (std::size_t beam = 0; beam < fan.count; ++beam) {
      const double angle = fan.first_rad + 0.0005 + static_cast<double>(beam) * fan.step_rad;
      const double wanted_m = walked(grid, place, angle, Unknown::kWall);
      ASSERT_NEAR(ranges_m[beam], wanted_m, 1e-9 * wanted_m + 1e-7) << place.transpose();
    }
  }
}

// From the middle of the lower left cell: 1.5 m to the wall's border, as the cells are 0.5 m.
TEST(GridCaster, StopsAtTheBorderOfTheFirstCellThatStops)
{
  GridFrame frame;
  frame.resolution_m = 0.5;
  frame.origin_m = {10.0, 20.0};
  const OccupancyGrid grid = drawn({"    ", "   #"}, frame);
  const std::vector<double> ranges_m = cast(grid, {10.25, 20.25}, full_turn(4));
  EXPECT_NEAR(ranges_m[0], 1.25, 1e-12);
  EXPECT_NEAR(ranges_m[1], 0.75, 1e-12) << "the edge of the grid: beyond, nothing is known";
  EXPECT_NEAR(ranges_m[2], 0.25, 1e-12);
}

TEST(GridCaster, UnknownCellsStopOrPassAsAsked)
{
  const OccupancyGrid grid = drawn({"  ? #"});
  const BeamFan ahead_and_back = full_turn(2);
  const std::vector<double> stopped = cast(grid, {0.5, 0.5}, ahead_and_back, Unknown::kWall);
  EXPECT_NEAR(stopped[0], 1.5, 1e-12);
  EXPECT_NEAR(stopped[1], 0.5, 1e-12);
  const std::vector<double> passed = cast(grid, {0.5, 0.5}, ahead_and_back, Unknown::kFree);
  EXPECT_NEAR(passed[0], 3.5, 1e-12);
  EXPECT_EQ(passed[1], kInfinity);
  // From outside, before the grid.
  EXPECT_EQ(cast(grid, {-1.5, 0.5}, ahead_and_back, Unknown::kWall)[0], 0.0);
  EXPECT_NEAR(cast(grid, {-1.5, 0.5}, ahead_and_back, Unknown::kFree)[0], 5.5, 1e-12);
}

TEST(GridCaster, InACellThatStopsEveryBeamReadsNothing)
{
  const OccupancyGrid grid = drawn({"   ", " # ", "   "});
  EXPECT_EQ(cast(grid, {1.3, 1.6}, full_turn(16)), std::vector<double>(16, 0.0));
}

// Two cells that share but the corner (1, 2); it lies half a diagonal from the middles of the cells
// between them.
TEST(GridCaster, NoBeamPassesBetweenCellsThatShareACorner)
{
  const double half_diagonal = 0.5 * std::sqrt(2.0);
  const OccupancyGrid gap = drawn({"#   ", " #  ", "    "});
  const double up_right = 0.125 * kTurn;
  for (int i = -50; i <= 50; ++i) {
    const double hair = i * 1e-15;
    EXPECT_NEAR(cast(gap, {0.5, 1.5}, {up_right + hair, 1.0, 1})[0], half_diagonal, 1e-9) << i;
    EXPECT_NEAR(
      cast(gap, {1.5, 2.5}, {up_right + hair - kTurn / 2, 1.0, 1})[0], half_diagonal, 1e-9)
      << i;
  }
}

// A beam along the diagonal touches the corner (1, 2) of the one cell beside it.
TEST(GridCaster, TheCornerOfACellBelongsToIt)
{
  const OccupancyGrid beside = drawn({"    ", " #  ", "    "});
  EXPECT_NEAR(cast(beside, {0.5, 1.5}, {0.125 * kTurn, 1.0, 1})[0], 0.5 * std::sqrt(2.0), 1e-12);
  const double aside = 0.125 * kTurn + 1e-11;  // passes the corner, meets the grid's upper edge
  EXPECT_NEAR(cast(beside, {0.5, 1.5}, {aside, 1.0, 1})[0], 1.5 * std::sqrt(2.0), 1e-9);
}

// On the border between a free cell and a wall it stands in the cell that the grid names.
TEST(GridCaster, OnABorderItStandsInTheCellBehindIt)
{
  const OccupancyGrid grid = drawn({"#   #"});
  const std::vector<double> left = cast(grid, {1.0, 0.5}, full_turn(2));
  EXPECT_NEAR(left[0], 3.0, 1e-9);
  EXPECT_NEAR(left[1], 0.0, 1e-9);
  EXPECT_EQ(cast(grid, {4.0, 0.5}, full_turn(2)), std::vector<double>(2, 0.0));
}

TEST(GridCaster, WhatIsOutOfReachIsInfinitelyFar)
{
  GridFrame frame;
  frame.resolution_m = 0.1;
  const OccupancyGrid grid = drawn({"#    #"}, frame);
  const auto range = [&](double reach_m) {
    return cast(grid, {0.25, 0.05}, {0.0, 1.0, 1}, Unknown::kWall, reach_m)[0];
  };
  EXPECT_NEAR(range(0.26), 0.25, 1e-12);
  EXPECT_EQ(range(0.24), kInfinity);
}

TEST(GridCaster, WhatIsNoNumberReadsNoNumber)
{
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const OccupancyGrid grid = drawn({"   #"});
  EXPECT_TRUE(std::isnan(cast(grid, {kNan, 0.5}, full_turn(3))[2]));
  EXPECT_TRUE(std::isnan(cast(grid, {0.5, 0.5}, {kNan, 0.1, 3})[2]));
}

TEST(GridCaster, AllocatesNothingTheSecondTime)
{
  const OccupancyGrid grid = random_grid_room(200, 20, 9);
  const GridCaster caster(grid, Unknown::kWall);
  std::vector<double> ranges_m;
  caster.cast(free_places(grid, 1, 1)[0], full_turn(1440), kFar, ranges_m);
  const std::vector<Vector2d> places = free_places(grid, 20, 2);
  const std::size_t before = allocations;
  for (const Vector2d & place : places) {
    caster.cast(place, full_turn(1440), kFar, ranges_m);
  }
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace stetro_site
