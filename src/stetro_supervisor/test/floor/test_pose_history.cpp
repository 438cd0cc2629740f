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

#include "stetro_supervisor/floor/pose_history.hpp"
#include "stetro_supervisor/observation.hpp"
#include "support/two_floors.hpp"

namespace stetro_supervisor
{
namespace
{

PoseHistory::Told told(double t_s, double x_m, double yaw_rad, std::uint32_t resets = 0)
{
  const Time time{static_cast<std::int64_t>(t_s * 1e9)};
  return {time, {"ground", {x_m, 0.0}, yaw_rad, Eigen::Matrix3d::Zero()}, resets};
}

Time at(double t_s) { return Time{static_cast<std::int64_t>(t_s * 1e9)}; }

}  // namespace

TEST(PoseHistory, LiesBetweenThePosesBeforeAndAfter)
{
  PoseHistory history;
  history.take(told(10.0, 1.0, 3.1));
  history.take(told(10.1, 2.0, -3.1));  // on across pi, by 0.0832 rad
  const auto between = history.at(at(10.025));
  ASSERT_TRUE(between);
  EXPECT_NEAR(between->place.position_m.x(), 1.25, 1e-9);
  EXPECT_NEAR(between->place.yaw_rad, 3.1 + 0.25 * (2.0 * 3.14159265358979 - 6.2), 1e-9);
  EXPECT_FALSE(history.at(at(9.9))) << "before the first";
  EXPECT_FALSE(history.at(at(10.2))) << "well after the last";
}

TEST(PoseHistory, StartsAnewAfterAJump)
{
  PoseHistory history;
  history.take(told(10.0, 1.0, 0.0));
  history.take(told(10.1, 5.0, 0.0, 1));
  EXPECT_FALSE(history.at(at(10.05)));
  EXPECT_TRUE(history.at(at(10.1)));
}

TEST(TurnWatch, TellsTheGreatestRateAboutATime)
{
  TurnWatch watch;
  for (int i = 0; i <= 20; ++i) {
    watch.take(at(10.0 + 0.05 * i), i < 10 ? 0.0 : 0.02 * (i - 9));  // turns 0.4 rad/s from 10.45 s
  }
  EXPECT_NEAR(watch.greatest_rate(at(10.2), 0.0).value(), 0.0, 1e-9);
  EXPECT_NEAR(watch.greatest_rate(at(10.4), 0.0).value(), 0.4, 1e-6);
  EXPECT_FALSE(watch.greatest_rate(at(11.5), 0.0)) << "the odometry is not there yet";
}

// The frames of the same place: before the first riser, on the last tread, and between.
TEST(PlaceOnFloor, IsOnTheFloorsThatAFlightJoins)
{
  const auto site = two_floors(3, 2);
  StairPose pose;
  pose.segment_id = "lower";
  pose.on_flight = true;
  pose.step = 0;
  pose.x_m = -0.5;
  pose.y_m = 1.0;
  pose.heading_rad = 0.1;
  const auto below = place_on_floor(pose, site);
  ASSERT_TRUE(below);
  EXPECT_EQ(below->floor_id, "ground");
  EXPECT_NEAR(below->position_m.x(), 4.5, 1e-12);  // the flight begins at 5 m
  pose.step = 1;
  EXPECT_FALSE(place_on_floor(pose, site));
  pose.step = 3;
  pose.x_m = 1.0;
  const auto above = place_on_floor(pose, site);
  ASSERT_TRUE(above);
  EXPECT_EQ(above->floor_id, "landing");
  EXPECT_NEAR(above->position_m.x(), 6.0, 1e-12);
  const auto back = in_flight(*above, site.floor("landing"), site.flight("lower"));
  EXPECT_NEAR(back.x_m, 1.0, 1e-12);
  EXPECT_NEAR(back.yaw_rad, 0.1, 1e-12);
}

}  // namespace stetro_supervisor
