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

#include <limits>
#include <string>
#include <vector>

#include "stetro_supervisor/told_pose.hpp"
#include "support/toy_robot.hpp"
#include "support/two_floors.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

// The papers' steps: tread 2 spans x from 0.32 to 0.64 at z 0.28. The flight stands at map x 10.
const stetro_site::Flight kFlight = flight_of(stairs(3));

ToldPose on_tread_2()
{
  ToldPose told;
  told.frame_id = "flight";
  told.pose = {0.5, 1.0, 0.28, 0.0};
  told.step = 2;
  return told;
}

std::string refusal(const ToldPose & told, const std::string & segment = "flight")
{
  return refusal_of(told, segment, kFlight);
}

/// The refusal holds each of the words.
void expect_told(const std::string & reason, const std::vector<std::string> & words)
{
  for (const std::string & word : words) {
    EXPECT_NE(reason.find(word), std::string::npos) << "'" << word << "' in: " << reason;
  }
}

TEST(ToldPose, IsAcceptedInTheFlightOrInTheMapWithAStepOrWithout)
{
  ToldPose told = on_tread_2();
  EXPECT_EQ(refusal(told), "");
  told.step = -1;
  EXPECT_EQ(refusal(told), "");
  told.frame_id = "map";
  told.pose.x_m = 10.5;
  EXPECT_EQ(refusal(told), "");
  EXPECT_DOUBLE_EQ(in_flight(told, kFlight).x_m, 0.5);
  told.pose = {9.4, 1.0, 0.0, 0.0};
  told.step = 0;
  EXPECT_EQ(refusal(told, "ground"), "") << "0.6 m before the first riser";
  EXPECT_EQ(refusal(told, "flight"), "") << "which the flight's frame covers too";
}

TEST(ToldPose, MustBeOnTheFlightOrTheFloorAtItsFoot)
{
  expect_told(refusal(on_tread_2(), "attic"), {"segment_id 'attic'", "'flight'", "'ground'"});
  expect_told(refusal(on_tread_2(), ""), {"segment_id ''"});
  expect_told(refusal(on_tread_2(), "ground"), {"segment_id 'ground'", "step 2", "'flight'"});
}

TEST(ToldPose, MustNameTheStepThatItsXLiesOn)
{
  ToldPose told = on_tread_2();
  told.step = 3;
  expect_told(refusal(told), {"step 3", "x 0.500 m", "step 2", "0.320 m to 0.640 m", "-1"});
  told.step = -2;
  expect_told(refusal(told), {"step -2", "accepted: 2, or -1"});
  told.step = 0;
  expect_told(refusal(told), {"step 0"});
  told = on_tread_2();
  told.frame_id = "map";  // x 0.5 in the map is 9.5 m before the flight
  expect_told(refusal(told), {"step 2", "x -9.500 m", "step 0"});
}

TEST(ToldPose, MustBeAPlaceToStandIn)
{
  ToldPose told = on_tread_2();
  told.pose.z_m = 0.0;
  expect_told(refusal(told), {"z 0.000 m", "step 2"});
  told = on_tread_2();
  told.pose.y_m = 3.0;
  expect_told(refusal(told), {"y 3.000 m", "walls"});
}

TEST(ToldPose, MustBeNumbersInAKnownFrame)
{
  ToldPose told = on_tread_2();
  told.frame_id = "odom";
  expect_told(refusal(told), {"frame_id 'odom'", "'map'", "'flight'"});
  told = on_tread_2();
  told.pose.y_m = kNotANumber;
  expect_told(refusal(told), {"pose.position", "nan"});
  told = on_tread_2();
  told.pose.yaw_rad = kNotANumber;
  expect_told(refusal(told), {"pose.orientation"});
}

TEST(ToldPose, MustHaveACovarianceThatIsOne)
{
  ToldPose told = on_tread_2();
  told.covariance(0, 0) = 0.04;
  told.covariance(0, 1) = told.covariance(1, 0) = 0.001;
  EXPECT_EQ(refusal(told), "");
  told.covariance(0, 1) = 0.002;
  expect_told(refusal(told), {"covariance[1]", "0.002", "0.001", "symmetric"});
  told.covariance = stetro_site::Covariance::Zero();
  told.covariance(5, 5) = -0.1;
  expect_told(refusal(told), {"covariance[35]", "-0.1"});
  told.covariance(5, 5) = kNotANumber;
  expect_told(refusal(told), {"covariance[35]", "finite"});
}

TEST(ToldPose, IsTheSameOnlyWithEveryNumberTheSame)
{
  ToldPose told = on_tread_2();
  told.pose.yaw_rad = kNotANumber;
  EXPECT_TRUE(same(told, told));
  ToldPose other = told;
  other.pose.x_m += 1e-9;
  EXPECT_FALSE(same(told, other));
  other = told;
  other.covariance(3, 4) = 1.0;
  EXPECT_FALSE(same(told, other));
  other = told;
  other.step = -1;
  EXPECT_FALSE(same(told, other));
}

// The frame of `first` is moved and turned against map; (1.0, 1.0) of `ground` is free in both.
TEST(ToldPose, OnAFloorIsAcceptedWhereTheRobotCanStand)
{
  const DrawnFloor ground{two_floors(3, 2), "ground", 0.05};
  ToldPose told;
  told.frame_id = "ground";
  told.pose = {1.0, 1.0, 0.0, 0.4};
  EXPECT_EQ(refusal_on_floor(told, ground), "");
  told.step = 0;
  told.frame_id = "map";
  EXPECT_EQ(refusal_on_floor(told, ground), "");

  told.frame_id = "landing";
  expect_told(refusal_on_floor(told, ground), {"frame_id 'landing'", "'map' or 'ground'"});
  told.frame_id = "ground";
  told.step = 2;
  expect_told(refusal_on_floor(told, ground), {"step 2", "'ground'", "accepted: 0"});
  told.step = 0;
  told.pose.x_m = -0.5;
  expect_told(refusal_on_floor(told, ground), {"(-0.500, 1.000)", "in a wall or outside"});
  told.pose.x_m = 1.0;
  told.pose.z_m = 0.42;
  expect_told(refusal_on_floor(told, ground), {"z 0.420", "-0.100 to 0.100"});
  told.pose.z_m = 0.0;
  told.covariance(0, 0) = -1.0;
  expect_told(refusal_on_floor(told, ground), {"covariance[0]"});
}

}  // namespace
}  // namespace stetro_supervisor
