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

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "stetro_supervisor/four_beams/heading_search.hpp"
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
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSilent = std::numeric_limits<double>::quiet_NaN();

RangeError within(double bound_m) { return {bound_m, bound_m, 0.0, 0.0, 1.2, 0.05}; }

/// Front, left, back and right of the robot's centre.
std::vector<RangeBeam> four_beams(const RangeError & error)
{
  std::vector<RangeBeam> beams;
  for (int i = 0; i < 4; ++i) {
    beams.push_back({{0.0, 0.0}, i * kPi / 2, error});
  }
  return beams;
}

/// A room of 2.0 x 3.6 m in cells of 10 cm, walls a cell thick around it; x and y from its corner.
OccupancyGrid paper_room(double grid_yaw_rad)
{
  GridFrame frame;
  frame.columns = 22;
  frame.rows = 38;
  frame.resolution_m = 0.1;
  frame.yaw_rad = grid_yaw_rad;
  frame.origin_m = {
    -0.1 * (std::cos(grid_yaw_rad) - std::sin(grid_yaw_rad)),
    -0.1 * (std::sin(grid_yaw_rad) + std::cos(grid_yaw_rad))};
  std::mt19937 random{1};
  return random_room(frame, {0, 0, 1, 0}, random);
}

bool holds(const OccupancyGrid & grid, const PlaceAnswer & answer, const Eigen::Vector2d & at_m)
{
  const auto & cells = answer.cells.cells;
  return std::find(cells.begin(), cells.end(), grid.cell_at(at_m)) != cells.end();
}

// At (0.52, 1.13) with exact ranges: column 6 (with the wall's), row 12, whose centres' index
// differences fit ranges from (d - 1) r to d r; next to it (5, 12) would need 1.5 to 1.6 ahead.
TEST(HeadingSearch, FindsTheCellOfExactRanges)
{
  const OccupancyGrid grid = paper_room(0.0);
  const HeadingSearch search(grid, four_beams(within(0.0)), 0.0);
  const PlaceAnswer answer = search.find({1.48, 2.47, 0.52, 1.13});
  EXPECT_EQ(answer.cells.cells, (std::vector<CellIndex>{{6, 12}}));
  EXPECT_NEAR(answer.area_m2, 0.01, 1e-12);
  ASSERT_EQ(answer.clusters.size(), 1U);
  EXPECT_TRUE(answer.clusters[0].centroid_m.isApprox(Eigen::Vector2d(0.55, 1.15)));
}

// Bounds of 3 cm reach into the next column (0.52 - 0.03 < 0.5) and not into the next row.
TEST(HeadingSearch, WidensByTheRangesError)
{
  const OccupancyGrid grid = paper_room(0.0);
  const HeadingSearch search(grid, four_beams(within(0.03)), 0.0);
  const PlaceAnswer answer = search.find({1.48, 2.45, 0.52, 1.15});
  EXPECT_EQ(answer.cells.cells, (std::vector<CellIndex>{{5, 12}, {6, 12}}));
}

// D4-11: in the middle of 3.6 m neither of two sensors of 1.25 m returns: y is in 1.25 .. 2.35.
TEST(HeadingSearch, NoReturnMeansFar)
{
  const OccupancyGrid grid = paper_room(0.0);
  RangeError error = within(0.0);
  error.dependable_m = 1.25;
  const HeadingSearch search(grid, four_beams(error), 0.0);
  const PlaceAnswer answer = search.find({kSilent, kInfinity, 0.52, kInfinity});
  ASSERT_EQ(answer.clusters.size(), 1U);
  EXPECT_EQ(answer.clusters[0].lowest, (CellIndex{6, 13}));
  EXPECT_EQ(answer.clusters[0].highest, (CellIndex{6, 24}));
  EXPECT_EQ(answer.cells.beams, 3U) << "what says nothing is not asked";
}

TEST(HeadingSearch, TooNearMeansNear)
{
  const OccupancyGrid grid = paper_room(0.0);
  const HeadingSearch search(grid, four_beams(within(0.0)), 0.0);
  const PlaceAnswer answer = search.find({kSilent, kSilent, -kInfinity, 1.13});
  EXPECT_EQ(answer.cells.cells, (std::vector<CellIndex>{{1, 12}}));
}

TEST(HeadingSearch, SaysNothingWhenNothingIsSaid)
{
  const OccupancyGrid grid = paper_room(0.0);
  const HeadingSearch search(grid, four_beams(within(0.0)), 0.0);
  EXPECT_TRUE(search.find({kSilent, kSilent, kSilent, kSilent}).cells.cells.empty());
  EXPECT_TRUE(search.find_best({kSilent, kSilent, kSilent, kSilent}).best.empty());
  EXPECT_TRUE(search.find({1.48, kSilent, kSilent, kSilent}, 1).cells.cells.empty());
}

// The front reads a person at 40 cm: no place fits four, the right one fits three.
TEST(HeadingSearch, DoesWithoutAWrongBeam)
{
  const OccupancyGrid grid = paper_room(0.0);
  const HeadingSearch search(grid, four_beams(within(0.0)), 0.0);
  EXPECT_TRUE(search.find({0.40, 2.47, 0.52, 1.13}).cells.cells.empty());
  const PlaceAnswer answer = search.find_best({0.40, 2.47, 0.52, 1.13});
  EXPECT_EQ(answer.cells.least_agreeing, 3U);
  EXPECT_TRUE(holds(grid, answer, {0.52, 1.13}));
  EXPECT_TRUE(holds(grid, search.find({0.40, 2.47, 0.52, 1.13}, 1), {0.52, 1.13}));
}

/// The length of a beam from inside an empty rectangle to its walls.
double to_walls(const Eigen::Vector2d & from, double heading_rad, const Eigen::Vector2d & size)
{
  const Eigen::Vector2d along(std::cos(heading_rad), std::sin(heading_rad));
  double length = kInfinity;
  for (int i = 0; i < 2; ++i) {
    const double ahead = along[i] > 0.0 ? size[i] - from[i] : from[i];
    if (along[i] != 0.0) {
      length = std::min(length, ahead / std::abs(along[i]));
    }
  }
  return length;
}

// Property: wherever the robot stands and however it is turned, with sensors away from its centre
// and a turned map, the answer holds the truth.
TEST(HeadingSearch, HoldsTheTruthForAnyPoseAndMounting)
{
  std::mt19937 random{20240602};
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const Eigen::Vector2d size(2.0, 3.6);
  const RangeError error{0.02, 0.05, 0.01, 0.03, 1.2, 0.05};
  std::size_t beams_out_of_reach = 0;
  for (int i = 0; i < 200; ++i) {
    const double grid_yaw_rad = i % 2 == 0 ? 0.0 : 6.0 * share(random);
    const OccupancyGrid grid = paper_room(grid_yaw_rad);
    const double in_room_rad = 6.0 * share(random);  // heading in the room's own axes
    const Eigen::Vector2d at(0.3 + 1.4 * share(random), 0.3 + 3.0 * share(random));
    std::vector<RangeBeam> beams = four_beams(error);
    beams[0].origin_m = {0.19, 0.10};
    beams[1].origin_m = {0.0, 0.05};
    beams.push_back({{0.19, -0.10}, 0.1, error});
    std::vector<double> ranges_m;
    for (const RangeBeam & beam : beams) {
      const Eigen::Rotation2Dd turn(in_room_rad);
      const double length = to_walls(at + turn * beam.origin_m, in_room_rad + beam.yaw_rad, size);
      const double least = length * 0.99 - 0.02;
      const double most = length * 1.03 + 0.05;
      const bool lost = length > 1.2 && share(random) < 0.5;
      beams_out_of_reach += lost ? 1 : 0;
      ranges_m.push_back(lost ? kInfinity : least + (most - least) * share(random));
    }
    const HeadingSearch search(grid, beams, in_room_rad + grid_yaw_rad);
    const PlaceAnswer answer = search.find(ranges_m);
    const Eigen::Vector2d on_floor = Eigen::Rotation2Dd(grid_yaw_rad) * at;
    ASSERT_TRUE(holds(grid, answer, on_floor)) << "pose " << i;
  }
  EXPECT_GT(beams_out_of_reach, 100U);
}

TEST(HeadingSearch, RefusesBeamsItCannotUse)
{
  const OccupancyGrid grid = paper_room(0.0);
  const auto refused = [&](const RangeBeam & beam) {
    EXPECT_THROW(HeadingSearch(grid, {beam}, 0.0), std::invalid_argument);
  };
  RangeBeam beam;
  beam.error.short_m = -0.01;
  refused(beam);
  beam = {};
  beam.error.short_share = 1.0;
  refused(beam);
  beam = {};
  beam.yaw_rad = kSilent;
  refused(beam);
  beam = {};
  beam.error.dependable_m = kInfinity;
  refused(beam);
  EXPECT_THROW(HeadingSearch(grid, {RangeBeam{}}, kInfinity), std::invalid_argument);
  EXPECT_THROW(HeadingSearch(grid, {RangeBeam{}}, 0.0).find({1.0, 1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_supervisor
