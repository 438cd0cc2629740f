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
#include <stdexcept>

#include "buildings.hpp"
#include "pilot.hpp"
#include "sim/building.hpp"

namespace stetro_driver::sim
{
namespace
{

using Eigen::Vector3d;
using test::two_floors;

constexpr std::size_t kLanding = 1;

double rise_of(const StairWorld & world) { return world.height_m(world.steps()); }

/// How far a level ray at a height goes among walls.
double reach_m(const std::vector<Wall> & walls, const Vector3 & origin, double dx, double dy)
{
  double nearest_m = 100.0;
  for (const Wall & wall : walls) {
    if (const auto hit = cast(wall, origin, {dx, dy, 0.0})) {
      nearest_m = std::min(nearest_m, hit->distance_m);
    }
  }
  return nearest_m;
}

TEST(Building, IsOneFlightAloneWithoutADrawnFloor)
{
  const Building building{building_of(test::paper_stairs()), nullptr, 1};
  EXPECT_FALSE(building.has_floors());
  EXPECT_EQ(building.flights().size(), 1u);
  EXPECT_TRUE(building.flight(0).around.at_stairs.empty());
}

TEST(Building, IsAsHighAsItsRisersWereBuilt)
{
  const SimErrors errors;
  const Building building{two_floors(), &errors, 3};
  const double lower_m = rise_of(building.flight(0).world);
  const double upper_m = rise_of(building.flight(1).world);
  EXPECT_NE(lower_m, 2.24);
  EXPECT_EQ(building.floor(0).pose_in_map.z_m, 0.0);
  EXPECT_EQ(building.floor(1).pose_in_map.z_m, lower_m);
  EXPECT_EQ(building.flight(1).pose_in_map.z_m, lower_m);
  EXPECT_EQ(building.floor(2).pose_in_map.z_m, lower_m + upper_m);
  EXPECT_EQ(building.flight(1).pose_in_map.x_m, 10.12) << "x and y are the site's";
}

TEST(Building, DrawsTheFirstFlightAsOneAloneAndTheOthersApart)
{
  const SimErrors errors;
  const Building building{two_floors("upper"), &errors, 3};
  const StairWorld alone{two_floors().flights[0].shape, errors, 3};
  const StairWorld same_stream{two_floors().flights[1].shape, errors, 3};
  for (int k = 1; k <= 8; ++k) {
    EXPECT_EQ(building.flight(0).world.height_m(k), alone.height_m(k));
    EXPECT_EQ(building.flight(0).world.riser_slope(k), alone.riser_slope(k));
    EXPECT_NE(building.flight(1).world.height_m(k), same_stream.height_m(k));
  }
}

TEST(Building, KnowsAtWhoseStairsABodyIs)
{
  const Building building{two_floors(), nullptr, 1};
  const auto at = [&](double x, double y, std::size_t present) {
    return building.stairs_at(kLanding, Vector3d{x, y, 2.24}, present);
  };
  EXPECT_EQ(at(10.5, 1.0, 1), 0u) << "beyond the end of lower";
  EXPECT_EQ(at(9.0, 1.0, 1), 0u) << "on it";
  EXPECT_EQ(at(10.5, 3.5, 0), 1u) << "before the foot of upper";
  EXPECT_FALSE(at(10.8, 1.0, 0)) << "the open floor";
  EXPECT_FALSE(at(10.5, 2.3, 0)) << "between the two";
  EXPECT_FALSE(building.stairs_at(0, Vector3d{10.5, 1.0, 0.0}, 0)) << "of another floor";
}

TEST(Building, MeasuresToTheNearestStairs)
{
  const Building building{two_floors(), nullptr, 1};
  EXPECT_NEAR(building.stairs_distance_m(0, Vector3d{3.0, 1.0, 0.0}), 2.0, 1e-9);
  EXPECT_NEAR(building.stairs_distance_m(0, Vector3d{2.0, 6.05, 0.0}), 5.0, 1e-9);  // 3, 4, 5
  EXPECT_NEAR(building.stairs_distance_m(kLanding, Vector3d{11.12, 3.0, 2.24}), 1.0, 1e-9);
  EXPECT_NEAR(building.stairs_distance_m(kLanding, Vector3d{9.0, 1.0, 2.24}), 0.0, 1e-9);
}

// The drawing's walls over and on the stairs are what a scanner sees, not what a body meets.
TEST(Building, LeavesAFlightsMouthOpen)
{
  const Building building{two_floors(), nullptr, 1};
  const Surroundings & around = building.flight(0).around;
  const double low = 0.2;
  EXPECT_NEAR(reach_m(around.at_stairs, {-1.0, 1.0, low}, 1.0, 0.0), 100.0, 1e-9)
    << "the risers are the flight's own, and the next floor's walls begin above it";
  EXPECT_NEAR(reach_m(around.open_below, {-1.0, 1.0, 0.1}, 1.0, 0.0), 1.0, 1e-9) << "riser 1";
  EXPECT_NEAR(reach_m(around.at_stairs, {-1.0, 1.0, low}, -1.0, 0.0), 4.0, 1e-9);
  EXPECT_NEAR(reach_m(around.at_stairs, {-1.0, 1.0, low}, 0.0, -1.0), 1.0, 1e-9);
  EXPECT_NEAR(reach_m(around.at_stairs, {2.0, 1.0, low}, 0.0, -1.0), 100.0, 1e-9)
    << "beside the steps stand the flight's own sides";
}

TEST(Building, ShowsOtherFlightsOnTheSameFloor)
{
  const Building building{two_floors(), nullptr, 1};
  const std::vector<Wall> & walls = building.flight(0).around.open_above;
  const Vector3 landing{6.12, 3.5, 2.24 + 0.1};  // 1 m before the foot of upper
  EXPECT_NEAR(reach_m(walls, landing, -1.0, 0.0), 1.0, 1e-9) << "its first riser";
  EXPECT_NEAR(reach_m(walls, {landing.x, landing.y, 2.24 + 0.2}, -1.0, 0.0), 1.32, 1e-9)
    << "its second";
  EXPECT_NEAR(reach_m(walls, {landing.x, 2.3, landing.z}, -1.0, 0.0), 1.0, 1e-9)
    << "the wall between";
}

TEST(Building, RefusesFlightsThatJoinNothing)
{
  BuildingShape shape = two_floors();
  shape.flights[1].upper = 7;
  EXPECT_THROW((Building{shape, nullptr, 1}), std::invalid_argument);
  shape = two_floors();
  shape.start = 2;
  EXPECT_THROW((Building{shape, nullptr, 1}), std::invalid_argument);
}

TEST(PartsOutside, CutsAWallAtARectangle)
{
  const Wall wall{0.0, 1.0, 10.0, 1.0};
  const auto through = parts_outside(wall, 2.0, 5.0, 0.0, 2.0);
  ASSERT_EQ(through.size(), 2u);
  EXPECT_NEAR(through[0].to_x_m, 2.0, 1e-12);
  EXPECT_NEAR(through[1].from_x_m, 5.0, 1e-12);
  EXPECT_EQ(parts_outside(wall, 2.0, 5.0, 1.5, 2.0).size(), 1u) << "beside it";
  EXPECT_TRUE(parts_outside(wall, -1.0, 11.0, 0.0, 2.0).empty());
  EXPECT_EQ(parts_outside({3.0, 1.0, 3.0, 9.0}, 2.0, 5.0, 0.0, 2.0).at(0).from_y_m, 2.0);
}

}  // namespace
}  // namespace stetro_driver::sim
