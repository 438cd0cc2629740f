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

#include "stetro_site/robot_geometry.hpp"

namespace stetro_site
{
namespace
{

std::string faults_of(const RobotGeometry & robot)
{
  stetro_config::Faults faults;
  check(robot, faults);
  std::string text;
  for (const auto & fault : faults) {
    text += to_string(fault) + "\n";
  }
  return text;
}

TEST(SensorPlace, HasANameABlockAndADirection)
{
  for (const Place place : kPlaces) {
    EXPECT_EQ(place_named(name_of(place)), place);
    EXPECT_EQ(kPlaces[index_of(place)], place);
    EXPECT_EQ(beam_direction(place).norm(), 1.0);
  }
  EXPECT_FALSE(place_named("tof1"));
  EXPECT_EQ(name_of(Place::kSideRight), "side_right");
  EXPECT_EQ(beam_direction(Place::kSideRight), Eigen::Vector3d(0, -1, 0));
  EXPECT_EQ(block_of(Place::kBlock3Front), 3);
}

TEST(RobotGeometry, DerivesWhatFollowsFromTheBody)
{
  const RobotGeometry robot;
  EXPECT_NEAR(robot.length_m(), 0.45, 1e-12);  // the papers' length
  EXPECT_NEAR(robot.front_baseline_m(), 0.20, 1e-12);
  EXPECT_NEAR(robot.side_separation_m(), 0.10, 1e-12);
  EXPECT_NEAR(robot.bumper_lever_m(), 0.225, 1e-12);
  EXPECT_NEAR(robot.block_x_m(1), 0.15, 1e-12);
  EXPECT_NEAR(robot.block_x_m(3), -0.15, 1e-12);
  EXPECT_NEAR(robot.contact_reading_m(Place::kSideLeft), 0.065, 1e-12);
  EXPECT_NEAR(robot.contact_reading_m(Place::kSideRight), 0.065, 1e-12);
  EXPECT_NEAR(robot.contact_reading_m(Place::kFrontLeft), 0.035, 1e-12);
  EXPECT_NEAR(robot.contact_reading_m(Place::kBlock3Front), 0.035, 1e-12);
  EXPECT_NEAR(robot.contact_reading_m(Place::kBlock2Down), 0.035, 1e-12);
  EXPECT_NEAR(robot.range_sensor.sigma_at_m(0.0), 0.0021, 1e-12);
  EXPECT_NEAR(robot.range_sensor.sigma_at_m(0.186667), 0.0035, 1e-7);  // 2.1, 2.8 and 3.5 mm
}

TEST(RobotGeometry, OfThePapersContradictsNothing) { EXPECT_EQ(faults_of(RobotGeometry{}), ""); }

TEST(RobotGeometry, RefusesABaselineWiderThanTheBody)
{
  RobotGeometry robot;
  robot.at(Place::kFrontLeft).y_m = 0.13;
  EXPECT_EQ(
    faults_of(robot),
    "sensors.front_left.y_m: value 'front baseline of 0.23' refused, accepted: a baseline of at "
    "most body.width_m, 0.2\n");
}

TEST(RobotGeometry, RefusesContactNarrowerThanTheBody)
{
  RobotGeometry robot;
  robot.contact_width_m = 0.19;
  EXPECT_EQ(
    faults_of(robot),
    "body.contact_width_m: value '0.19' refused, accepted: at least body.width_m, 0.2\n");
}

TEST(RobotGeometry, RefusesALidarThatSeesNothingOrItself)
{
  RobotGeometry robot;
  robot.lidar.max_range_m = 0.15;
  robot.lidar.height_m = 0.40;
  EXPECT_EQ(
    faults_of(robot),
    "lidar.min_range_m: value '0.15' refused, accepted: less than lidar.max_range_m, 0.15\n"
    "lidar.height_m: value '0.4' refused, accepted: more than body.height_m, 0.4, or it looks at "
    "its own blocks\n");
}

TEST(RobotGeometry, RefusesARecessTheSensorCannotResolve)
{
  RobotGeometry robot;
  robot.at(Place::kBlock2Down).height_m = 0.02;
  EXPECT_EQ(
    faults_of(robot),
    "sensors.block2_down.height_m: value 'recess of 0.02' refused, accepted: a recess of at least "
    "range_sensor.min_range_m, 0.03, or contact cannot be read\n");
}

TEST(RobotGeometry, RefusesPairsThatAreNone)
{
  RobotGeometry robot;
  robot.at(Place::kSideLeft).y_m = -0.05;
  robot.at(Place::kSideRight).y_m = 0.05;
  robot.at(Place::kFrontLeft).x_m = 0.18;
  robot.range_sensor.reliable_range_m = robot.range_sensor.min_range_m;
  EXPECT_EQ(
    faults_of(robot),
    "range_sensor.min_range_m: value '0.03' refused, accepted: less than "
    "range_sensor.reliable_range_m, 0.03\n"
    "sensors.front_left.x_m: value '0.18' refused, accepted: 0.19, as sensors.front_right.x_m\n"
    "sensors.side_left.y_m: value '-0.05' refused, accepted: more than 0.05, "
    "sensors.side_right.y_m: left is +y\n");
}

}  // namespace
}  // namespace stetro_site
