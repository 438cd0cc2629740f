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
#include <string>

#include "node/convert.hpp"

namespace stetro_driver
{
namespace
{

TEST(Convert, ReadsACommand)
{
  stetro_msgs::msg::Command message;
  message.header().stamp().sec(1000);
  message.header().stamp().nanosec(250'000'000);
  message.sequence_number(12);
  message.issuer("supervisor");
  message.issuer_instance(99);
  message.valid_for().nanosec(150'000'000);
  message.kind(stetro_msgs::msg::Command_Constants::KIND_LOWER);
  message.block(2);
  const CommandRequest request = to_request(message);
  EXPECT_EQ(request.issuer, "supervisor");
  EXPECT_EQ(request.issuer_instance, 99u);
  EXPECT_EQ(request.sequence_number, 12u);
  EXPECT_EQ(request.stamp, std::chrono::milliseconds{1'000'250});
  EXPECT_EQ(request.valid_for, std::chrono::milliseconds{150});
  EXPECT_EQ(request.motion.kind, MotionKind::kLower);
  EXPECT_EQ(request.motion.block, 2);
}

TEST(Convert, AnIssuerThatFillsItsFieldMayBeAStump)
{
  stetro_msgs::msg::Command message;
  message.issuer(std::string(63, 'a'));
  EXPECT_FALSE(to_request(message).issuer_cut);
  message.issuer(std::string(70, 'a'));
  EXPECT_TRUE(to_request(message).issuer_cut);
}

TEST(Convert, ARangeSaysHowSureItIs)
{
  SensorFrame frame;
  frame.ranges[0].std_dev_m = 0.02;
  const stetro_site::RangeSensor sensor;
  EXPECT_NEAR(to_range(frame, RangePlace::kSideLeft, sensor).variance(), 4e-4, 1e-9);
  frame.ranges[0].std_dev_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(to_range(frame, RangePlace::kSideLeft, sensor).variance(), 0.0F) << "unknown";
}

TEST(Convert, OdometryGetsLessSureWithTheWay)
{
  OdometryReading odometry;
  const auto at_rest = to_odometry(odometry).pose().covariance();
  EXPECT_EQ(at_rest[0], 0.0) << "it starts where it says";
  odometry.turned_rad = 2.0;
  const auto turned = to_odometry(odometry).pose().covariance();
  EXPECT_EQ(turned[0], 0.0);
  EXPECT_NEAR(turned[35], 0.01, 1e-12) << "(5 % of 2 rad)^2";
  odometry.turned_rad = 0.0;
  odometry.rolled_m = 1.0;
  const auto rolled = to_odometry(odometry).pose().covariance();
  EXPECT_NEAR(rolled[0], 0.0125, 1e-12) << "5 % of a metre, and 0.1 rad over it";
  EXPECT_NEAR(rolled[35], 0.01, 1e-12);
  odometry.rolled_m = 2.0;
  EXPECT_GT(to_odometry(odometry).pose().covariance()[7], rolled[7]);
}

TEST(Convert, AKindThatNobodyKnowsIsNotGuessed)
{
  stetro_msgs::msg::Command message;
  for (const int kind : {0, 7, 200}) {
    message.kind(static_cast<std::uint8_t>(kind));
    EXPECT_EQ(to_request(message).motion.kind, MotionKind::kUnknown) << kind;
  }
}

TEST(Convert, NamesRangesByPlaceWithTheirOwnStamps)
{
  SensorFrame frame;
  frame.time = std::chrono::seconds{1001};
  frame.ranges[0].stamp = std::chrono::milliseconds{1'000'980};
  frame.ranges[0].range_m = 0.5;
  frame.ranges[0].status = RangeStatus::kValid;
  frame.ranges[4].range_m = std::numeric_limits<double>::infinity();
  frame.ranges[4].status = RangeStatus::kNoTarget;
  const auto message = to_ranges(frame);
  ASSERT_EQ(message.readings().size(), kRangePlaces);
  EXPECT_EQ(std::string(message.readings()[0].sensor().c_str()), "side_left");
  EXPECT_EQ(message.readings()[0].stamp().nanosec(), 980'000'000u);
  EXPECT_EQ(message.readings()[0].range(), 0.5);
  EXPECT_EQ(std::string(message.readings()[4].sensor().c_str()), "stair_front");
  EXPECT_TRUE(std::isinf(message.readings()[4].range()));
  EXPECT_EQ(
    message.readings()[4].status(), stetro_msgs::msg::RangeReading_Constants::STATUS_NO_TARGET);
}

TEST(Convert, AClosedBumperIsClosedOnTheWire)
{
  SensorFrame frame;
  auto & bumper = frame.contacts[static_cast<std::size_t>(ContactPlace::kRightRear)];
  bumper.closed = true;
  bumper.last_change = std::chrono::seconds{1000};
  const auto message = to_contacts(frame);
  EXPECT_EQ(message.right_rear().state(), stetro_msgs::msg::ContactState_Constants::STATE_CLOSED);
  EXPECT_EQ(message.right_rear().last_change().sec(), 1000);
  EXPECT_EQ(message.left_rear().state(), stetro_msgs::msg::ContactState_Constants::STATE_OPEN);
}

/// The image of the unit vector x under a quaternion.
Vector3 rotated_x(const geometry_msgs::msg::Quaternion & q)
{
  return {
    1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()), 2.0 * (q.x() * q.y() + q.z() * q.w()),
    2.0 * (q.x() * q.z() - q.y() * q.w())};
}

TEST(Convert, SensorFramesLookAlongTheirBeams)
{
  const BodyShape body;
  const auto message = to_static_transforms(Time{1}, body, false);
  ASSERT_EQ(message.transforms().size(), kRangePlaces);
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    const Vector3 looks = rotated_x(message.transforms()[i].transform().rotation());
    EXPECT_NEAR(looks.x, body.tof[i].direction.x, 1e-9) << kRangeNames[i];
    EXPECT_NEAR(looks.y, body.tof[i].direction.y, 1e-9) << kRangeNames[i];
    EXPECT_NEAR(looks.z, body.tof[i].direction.z, 1e-9) << kRangeNames[i];
  }
  EXPECT_EQ(message.transforms()[2].header().frame_id(), "block1");
  EXPECT_NEAR(message.transforms()[2].transform().translation().x(), 0.04, 1e-12);
}

TEST(Convert, TheLidarIsWhereTheRobotFileSays)
{
  BodyShape body;
  body.lidar.x_m = 0.02;
  body.lidar.yaw_rad = 1.5707963;
  const auto message = to_static_transforms(Time{1}, body, true);
  ASSERT_EQ(message.transforms().size(), kRangePlaces + 1);
  const auto & lidar = message.transforms().back();
  EXPECT_EQ(lidar.header().frame_id(), "base_link");
  EXPECT_EQ(lidar.child_frame_id(), "lidar");
  EXPECT_NEAR(lidar.transform().translation().x(), 0.02, 1e-12);
  EXPECT_NEAR(lidar.transform().translation().z(), 0.45, 1e-12);
  EXPECT_NEAR(rotated_x(lidar.transform().rotation()).y, 1.0, 1e-6);
}

TEST(Convert, AScanIsAFullTurnFromItsFirstBeam)
{
  LidarScan scan;
  scan.stamp = std::chrono::milliseconds{1'000'100};
  scan.angle_min_rad = -3.0;
  scan.angle_increment_rad = 0.5;
  scan.min_range_m = 0.15;
  scan.max_range_m = 12.0;
  scan.period_s = 0.1;
  scan.ranges_m = {1.0F, std::numeric_limits<float>::infinity(), 2.5F};
  const auto message = to_scan(scan);
  EXPECT_EQ(message.header().frame_id(), "lidar");
  EXPECT_EQ(time_of(message.header().stamp()), scan.stamp);
  EXPECT_FLOAT_EQ(message.angle_min(), -3.0F);
  EXPECT_FLOAT_EQ(message.angle_max(), -2.0F);
  EXPECT_FLOAT_EQ(message.angle_increment(), 0.5F);
  EXPECT_EQ(message.time_increment(), 0.0F);
  EXPECT_FLOAT_EQ(message.scan_time(), 0.1F);
  EXPECT_FLOAT_EQ(message.range_min(), 0.15F);
  EXPECT_FLOAT_EQ(message.range_max(), 12.0F);
  EXPECT_EQ(message.ranges(), scan.ranges_m);
  EXPECT_TRUE(message.intensities().empty());
}

TEST(Convert, TruthSaysWhichSegmentItIsOn)
{
  namespace stair_pose = stetro_msgs::msg::StairPose_Constants;
  GroundTruth truth;
  truth.segment = "stairs";
  truth.step = 3;
  truth.y_m = 1.0;
  const auto on_flight = to_ground_truth(truth, 16);
  EXPECT_EQ(on_flight.segment_id(), "stairs");
  EXPECT_EQ(on_flight.header().frame_id(), "stairs");
  EXPECT_EQ(on_flight.segment_kind(), stair_pose::SEGMENT_FLIGHT);
  EXPECT_EQ(on_flight.step_index(), 3);
  EXPECT_EQ(on_flight.step_count(), 16);
  EXPECT_EQ(on_flight.tread_y(), 1.0);
  truth.segment = "ground";
  truth.on_floor = true;
  truth.step = 0;
  const auto on_floor = to_ground_truth(truth, 0);
  EXPECT_EQ(on_floor.segment_id(), "ground");
  EXPECT_EQ(on_floor.header().frame_id(), "ground");
  EXPECT_EQ(on_floor.segment_kind(), stair_pose::SEGMENT_FLOOR);
  EXPECT_EQ(on_floor.step_count(), 0);
  EXPECT_EQ(on_floor.pose().pose().position().y(), 1.0);
  EXPECT_TRUE(std::isnan(on_floor.tread_y()));
}

TEST(Convert, BlocksHangWhereTheyAre)
{
  SensorFrame frame;
  frame.blocks[0].height_m = 0.14;
  frame.blocks[1].height_m = 0.18;  // lifted off the tread that block 3 stands on
  const auto lifted = to_transforms(frame, BodyShape{});
  EXPECT_NEAR(lifted.transforms()[2].transform().translation().z(), 0.18, 1e-12);
  frame.blocks[1].height_m = 0.14;
  frame.blocks[1].at_lower_lock = true;
  const auto standing = to_transforms(frame, BodyShape{});
  EXPECT_NEAR(standing.transforms()[2].transform().translation().z(), 0.0, 1e-12);
  EXPECT_NEAR(standing.transforms()[3].transform().translation().z(), -0.14, 1e-12);
}

TEST(Convert, WhatTheGyroDoesNotMeasureIsSaidSo)
{
  GyroReading gyro;
  gyro.rate_rad_s = {0.0, 0.0, 0.25};
  const auto message = to_imu(gyro);
  EXPECT_EQ(message.orientation_covariance()[0], -1.0);
  EXPECT_EQ(message.linear_acceleration_covariance()[0], -1.0);
  EXPECT_EQ(message.angular_velocity().z(), 0.25);
}

TEST(Convert, AnAttitudeAndAnAccelerationArePublishedWhenKnown)
{
  GyroReading gyro;
  gyro.attitude = AttitudeReading{{0.1, -0.3, 0.5, 0.8}, 0.01, 0.04};
  gyro.acceleration_m_s2 = {0.5, -0.25, 9.75};
  gyro.acceleration_std_dev_m_s2 = 0.02;
  const auto message = to_imu(gyro);
  EXPECT_EQ(message.orientation().x(), 0.1);
  EXPECT_EQ(message.orientation().y(), -0.3);
  EXPECT_EQ(message.orientation().z(), 0.5);
  EXPECT_EQ(message.orientation().w(), 0.8);
  EXPECT_NEAR(message.orientation_covariance()[0], 1e-4, 1e-12);
  EXPECT_NEAR(message.orientation_covariance()[8], 1.6e-3, 1e-12);
  EXPECT_EQ(message.linear_acceleration().y(), -0.25);
  EXPECT_EQ(message.linear_acceleration().z(), 9.75);
  EXPECT_NEAR(message.linear_acceleration_covariance()[4], 4e-4, 1e-12);
}

}  // namespace
}  // namespace stetro_driver
