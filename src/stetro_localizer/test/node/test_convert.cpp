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
#include "support/stair_robot.hpp"

namespace stetro_localizer
{
namespace
{

namespace reading = stetro_msgs::msg::RangeReading_Constants;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr Nanoseconds kStale = std::chrono::milliseconds(300);
constexpr Nanoseconds kTime{1'234'567'890'123};

stetro_msgs::msg::RangeArray ranges_with(double range, std::uint8_t status)
{
  stetro_msgs::msg::RangeArray message;
  message.header().stamp(stamp_of(kTime));
  stetro_msgs::msg::RangeReading one;
  one.stamp(stamp_of(kTime));
  one.sensor(std::string("side_left"));
  one.range(range);
  one.standard_deviation(0.003);
  one.status(status);
  message.readings().push_back(one);
  return message;
}

std::string reason(const stetro_msgs::msg::RangeArray & message)
{
  RangeSample sample;
  const auto refusal = take(message, kStale, sample);
  return refusal ? refusal->reason : "";
}

geometry_msgs::msg::Quaternion turned(double yaw_rad)
{
  geometry_msgs::msg::Quaternion q;
  q.x(0.0);
  q.y(0.0);
  q.z(std::sin(yaw_rad / 2));
  q.w(std::cos(yaw_rad / 2));
  return q;
}

TEST(Convert, TakesAValidRange)
{
  RangeSample sample;
  ASSERT_FALSE(take(ranges_with(0.7, reading::STATUS_VALID), kStale, sample));
  EXPECT_EQ(sample[Place::kSideLeft].range_m, 0.7);
  EXPECT_EQ(sample[Place::kSideLeft].status, RangeStatus::kValid);
  EXPECT_EQ(sample[Place::kSideRight].status, RangeStatus::kAbsent);
}

// REP 117: infinities mean something, but never with the status "valid".
TEST(Convert, TakesTheInfinitiesOfRep117WithTheirStatusOnly)
{
  EXPECT_EQ(reason(ranges_with(-kInf, reading::STATUS_TOO_NEAR)), "");
  EXPECT_EQ(reason(ranges_with(kInf, reading::STATUS_NO_TARGET)), "");
  EXPECT_EQ(reason(ranges_with(kNan, reading::STATUS_FAULT)), "");
  for (const double bad : {kNan, kInf, -kInf}) {
    EXPECT_EQ(reason(ranges_with(bad, reading::STATUS_VALID)), "not_finite") << bad;
  }
}

TEST(Convert, RefusesRangesThatCannotBe)
{
  EXPECT_EQ(reason(ranges_with(-0.1, reading::STATUS_VALID)), "negative");
  EXPECT_EQ(reason(ranges_with(0.5, 99)), "bad_status");
  auto unknown = ranges_with(0.5, reading::STATUS_VALID);
  unknown.readings()[0].sensor(std::string("tof3"));
  EXPECT_EQ(reason(unknown), "unknown_sensor");
  auto twice = ranges_with(0.5, reading::STATUS_VALID);
  twice.readings().push_back(twice.readings()[0]);
  EXPECT_EQ(reason(twice), "unknown_sensor");
  auto ahead = ranges_with(0.5, reading::STATUS_VALID);
  ahead.readings()[0].stamp(stamp_of(kTime + std::chrono::seconds(1)));
  EXPECT_EQ(reason(ahead), "reading_stamp");
}

TEST(Convert, MarksALateReadingStale)
{
  auto late = ranges_with(0.5, reading::STATUS_VALID);
  late.readings()[0].stamp(stamp_of(kTime - std::chrono::milliseconds(500)));
  RangeSample sample;
  ASSERT_FALSE(take(late, kStale, sample));
  EXPECT_EQ(sample[Place::kSideLeft].status, RangeStatus::kStale);
}

TEST(Convert, RefusesBlocksOutOfBounds)
{
  stetro_msgs::msg::BlockStates message;
  BlockSample sample;
  message.block2().height(0.18);
  message.block2().load(0.4);
  ASSERT_FALSE(take(message, sample));
  EXPECT_EQ(sample.blocks[1].height_m, 0.18);
  message.block2().load(kNan);
  ASSERT_FALSE(take(message, sample));
  EXPECT_FALSE(sample.blocks[1].load_known) << "unknown is a value";
  message.block2().load(1.2);
  EXPECT_EQ(take(message, sample)->reason, "out_of_bounds");
  message.block2().load(0.4);
  message.block2().height(-0.1);
  EXPECT_EQ(take(message, sample)->reason, "out_of_bounds");
  message.block2().height(kInf);
  EXPECT_EQ(take(message, sample)->reason, "not_finite");
}

TEST(Convert, DoesNotKnowASwitchThatIsBroken)
{
  namespace contact = stetro_msgs::msg::ContactState_Constants;
  stetro_msgs::msg::Contacts message;
  message.left_rear().state(contact::STATE_CLOSED);
  message.right_front().state(contact::STATE_CLOSED);
  message.right_front().fault(true);
  ContactSample sample;
  ASSERT_FALSE(take(message, sample));
  EXPECT_TRUE(sample.left[2].is_closed());
  EXPECT_FALSE(sample.right[0].is_closed());
  EXPECT_FALSE(sample.riser_left.known);
  message.riser_left().state(7);
  EXPECT_EQ(take(message, sample)->reason, "bad_state");
}

TEST(Convert, RefusesNumbersThatAreNone)
{
  sensor_msgs::msg::Imu imu;
  imu.angular_velocity().z(kNan);
  GyroSample gyro;
  EXPECT_EQ(take(imu, gyro)->reason, "not_finite");
  nav_msgs::msg::Odometry odometry;
  odometry.pose().pose().orientation(turned(0.3));
  OdometrySample wheels;
  stetro_site::Pose odom;
  ASSERT_FALSE(take(odometry, wheels, odom));
  EXPECT_NEAR(odom.yaw_rad, 0.3, 1e-12);
  odometry.twist().twist().linear().y(kInf);
  EXPECT_EQ(take(odometry, wheels, odom)->reason, "not_finite");
}

// Turned by 0.5 about z, then by 0.1 about its own y axis: the product of both, by hand.
TEST(Convert, TakesThePitchOfAnImuThatKnowsIt)
{
  const double cz = std::cos(0.25);
  const double sz = std::sin(0.25);
  const double cy = std::cos(0.05);
  const double sy = std::sin(0.05);
  sensor_msgs::msg::Imu imu;
  imu.orientation().w(cz * cy);
  imu.orientation().x(-sz * sy);
  imu.orientation().y(cz * sy);
  imu.orientation().z(sz * cy);
  GyroSample gyro;
  ASSERT_FALSE(take(imu, gyro));
  ASSERT_TRUE(gyro.pitch_rad);
  EXPECT_NEAR(*gyro.pitch_rad, 0.1, 1e-12) << "nose down is positive";
  imu.orientation_covariance()[0] = -1.0;
  ASSERT_FALSE(take(imu, gyro));
  EXPECT_FALSE(gyro.pitch_rad) << "it says that it does not know";
  imu.orientation_covariance()[0] = 0.0;
  imu.orientation().w(kNan);
  ASSERT_FALSE(take(imu, gyro));
  EXPECT_FALSE(gyro.pitch_rad);
}

stetro_site::Flight turned_flight()
{
  stetro_site::FlightSpec spec = papers_flight().spec();
  spec.pose_in_map = {3.0, -2.0, 1.5, 2.0};
  return stetro_site::Flight(spec);
}

StairEstimate some_estimate()
{
  StairEstimate estimate;
  estimate.stamp = kTime;
  estimate.step = 3;
  estimate.pose = {0.8, 1.1, 0.42, 0.1};
  estimate.covariance.diagonal() << 0.01, 0.0004, 1e-6, 1e-4, 1e-4, 0.001;
  return estimate;
}

// Round trip: what is published in map, told back as initialpose, is the estimate.
TEST(Convert, MapAndFlightThereAndBackIsTheIdentity)
{
  const auto flight = turned_flight();
  const StairEstimate estimate = some_estimate();
  geometry_msgs::msg::PoseWithCovarianceStamped message;
  fill(message, estimate, segment_of(flight));
  EXPECT_EQ(std::string(message.header().frame_id().c_str()), "map");
  stetro_site::Pose pose;
  stetro_site::Covariance covariance;
  ASSERT_FALSE(take(message, pose, covariance));
  pose = flight.T_map_flight().to_frame(pose);
  covariance = flight.T_map_flight().to_frame(covariance);
  EXPECT_NEAR(pose.x_m, 0.8, 1e-12);
  EXPECT_NEAR(pose.y_m, 1.1, 1e-12);
  EXPECT_NEAR(pose.z_m, 0.42, 1e-12);
  EXPECT_NEAR(pose.yaw_rad, 0.1, 1e-12);
  EXPECT_NEAR((covariance - estimate.covariance).norm(), 0.0, 1e-12);
}

// map -> odom -> base_link is map -> base_link.
TEST(Convert, TransformClosesTheChain)
{
  const auto flight = turned_flight();
  const StairEstimate estimate = some_estimate();
  const stetro_site::Pose odom{0.4, -0.7, 0.0, 0.6};
  tf2_msgs::msg::TFMessage message;
  fill(message, estimate, segment_of(flight), odom);
  ASSERT_EQ(message.transforms().size(), 1u);
  const auto & tf = message.transforms()[0].transform();
  const double yaw = 2.0 * std::atan2(tf.rotation().z(), tf.rotation().w());
  const stetro_site::FrameTransform T_map_odom(
    {tf.translation().x(), tf.translation().y(), tf.translation().z(), yaw});
  const stetro_site::Pose base = T_map_odom.to_map(odom);
  const stetro_site::Pose expected = flight.T_map_flight().to_map(estimate.pose);
  EXPECT_NEAR(base.x_m, expected.x_m, 1e-12);
  EXPECT_NEAR(base.y_m, expected.y_m, 1e-12);
  EXPECT_NEAR(base.z_m, expected.z_m, 1e-12);
  EXPECT_NEAR(std::remainder(base.yaw_rad - expected.yaw_rad, 2 * M_PI), 0.0, 1e-12);
}

TEST(Convert, SaysUnknownWhereItDoesNotKnow)
{
  StairEstimate lost;
  lost.stamp = kTime;
  EXPECT_FALSE(is_known(lost.pose));
  stetro_msgs::msg::StairPose message;
  fill(message, lost, segment_of(papers_flight()));
  EXPECT_EQ(message.step_index(), -1);
  EXPECT_EQ(message.step_count(), 16);
  EXPECT_EQ(message.integrity(), stetro_msgs::msg::StairPose_Constants::INTEGRITY_LOST);
  EXPECT_EQ(message.reasons(), stetro_msgs::msg::StairPose_Constants::REASON_NOT_INITIALISED);
  EXPECT_TRUE(std::isnan(message.pose().pose().position().x()));
  EXPECT_TRUE(std::isnan(message.step_probability()));
}

}  // namespace
}  // namespace stetro_localizer
