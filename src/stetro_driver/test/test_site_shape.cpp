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

#include "buildings.hpp"
#include "stetro_driver/site_shape.hpp"

namespace stetro_driver
{
namespace
{

// What the simulator is made of by itself is what the robot file ships: nothing to keep in step.
TEST(SiteShape, TheDefaultRobotIsTheSimulatorsOwn)
{
  const BodyShape own;
  const BodyShape read = shape_of(stetro_site::Robot{});
  EXPECT_EQ(read.block_length_m, own.block_length_m);
  EXPECT_EQ(read.body_width_m, own.body_width_m);
  EXPECT_EQ(read.contact_width_m, own.contact_width_m);
  EXPECT_EQ(read.stroke_m, own.stroke_m);
  EXPECT_EQ(read.lift_speed_m_s, own.lift_speed_m_s);
  EXPECT_EQ(read.steer_speed_rad_s, own.steer_speed_rad_s);
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    EXPECT_EQ(read.tof[i].block, own.tof[i].block) << kRangeNames[i];
    EXPECT_EQ(read.tof[i].position_m.x, own.tof[i].position_m.x) << kRangeNames[i];
    EXPECT_EQ(read.tof[i].position_m.y, own.tof[i].position_m.y) << kRangeNames[i];
    EXPECT_EQ(read.tof[i].position_m.z, own.tof[i].position_m.z) << kRangeNames[i];
    EXPECT_EQ(read.tof[i].direction.x, own.tof[i].direction.x) << kRangeNames[i];
    EXPECT_EQ(read.tof[i].direction.y, own.tof[i].direction.y) << kRangeNames[i];
    EXPECT_EQ(read.tof[i].direction.z, own.tof[i].direction.z) << kRangeNames[i];
  }
  EXPECT_EQ(read.lidar.x_m, own.lidar.x_m);
  EXPECT_EQ(read.lidar.y_m, own.lidar.y_m);
  EXPECT_EQ(read.lidar.height_m, own.lidar.height_m);
  EXPECT_EQ(read.lidar.yaw_rad, own.lidar.yaw_rad);
  EXPECT_EQ(read.lidar.min_range_m, own.lidar.min_range_m);
  EXPECT_EQ(read.lidar.max_range_m, own.lidar.max_range_m);
  EXPECT_EQ(read.lidar.beams, own.lidar.beams);
  EXPECT_EQ(read.lidar.rate_hz, own.lidar.rate_hz);
}

TEST(SiteShape, TakesTheFlightStepByStep)
{
  stetro_site::FlightSpec spec;
  spec.id = "stairs";
  spec.steps = stetro_site::equal_steps(3, 0.14, 0.32);
  spec.steps[1].riser_m = 0.15;
  spec.width_foot_m = 2.05;
  spec.width_top_m = 2.0;
  spec.left = stetro_site::Side::kOpen;
  spec.lower_floor = "ground";
  spec.upper_floor = "first";
  const StairShape shape = shape_of(stetro_site::Flight{spec});
  ASSERT_EQ(shape.riser_m.size(), 3u);
  EXPECT_EQ(shape.riser_m[1], 0.15);
  EXPECT_EQ(shape.tread_m[2], 0.32);
  EXPECT_EQ(shape.width_top_m, 2.0);
  EXPECT_TRUE(shape.right_walled);
  EXPECT_FALSE(shape.left_walled);
}

TEST(SiteShape, TakesTheWholeBuildingIfAFloorIsDrawn)
{
  const BuildingShape building = test::two_floors("upper");
  ASSERT_EQ(building.flights.size(), 2u);
  EXPECT_EQ(building.start, 1u);
  EXPECT_EQ(building.flights[1].id, "upper");
  EXPECT_EQ(building.flights[1].pose_in_map.z_m, 2.24);
  ASSERT_EQ(building.floors.size(), 3u);
  EXPECT_EQ(building.floors[building.flights[1].lower].id, "landing");
  EXPECT_EQ(building.floors[building.flights[1].upper].id, "first");
  EXPECT_TRUE(building.floors[0].drawn);
  EXPECT_EQ(building.floors[0].walls.size(), 2u) << "the outline and the column";
}

TEST(SiteShape, TakesOneFlightAloneIfNoFloorIsDrawn)
{
  const BuildingShape building = shape_of(test::site_of(test::paper_flight()), "stairs");
  EXPECT_EQ(building.flights.size(), 1u);
  EXPECT_TRUE(building.floors.empty());
  EXPECT_EQ(building.flights[0].lower, kNoFloor);
}

}  // namespace
}  // namespace stetro_driver
