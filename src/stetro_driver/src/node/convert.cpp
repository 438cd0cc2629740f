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

#include "node/convert.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stetro_msgs/bounds.hpp"

namespace stetro_driver
{
namespace
{

namespace reading = stetro_msgs::msg::RangeReading_Constants;
namespace contact = stetro_msgs::msg::ContactState_Constants;
namespace command = stetro_msgs::msg::Command_Constants;

constexpr char kBase[] = "base_link";
constexpr char kLidar[] = "lidar";
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
// A wheel's share of what the ground does to it, as a variance per axis of a velocity sample.
constexpr double kSpeedVariance = 1e-4;  // (1 cm/s)^2
constexpr double kTurnVariance = 1e-3;   // (1.8 deg/s)^2
// Dead reckoning, one standard deviation: the wheels' scale and slips per metre rolled and per
// radian turned, and the turning that no wheel feels per metre rolled.
constexpr double kPositionDrift = 0.05;   // [m/m]
constexpr double kHeadingDrift = 0.05;    // [rad/rad]
constexpr double kHeadingPerMetre = 0.1;  // [rad/m]
constexpr double kNotMeasured = 1e6;      // an axis that wheels cannot know

std::uint8_t status_of(RangeStatus status)
{
  switch (status) {
    case RangeStatus::kValid:
      return reading::STATUS_VALID;
    case RangeStatus::kTooNear:
      return reading::STATUS_TOO_NEAR;
    case RangeStatus::kNoTarget:
      return reading::STATUS_NO_TARGET;
    case RangeStatus::kWeak:
      return reading::STATUS_WEAK;
    case RangeStatus::kStale:
      return reading::STATUS_STALE;
    case RangeStatus::kFault:
      return reading::STATUS_FAULT;
  }
  return reading::STATUS_UNKNOWN;
}

MotionKind kind_of(std::uint8_t kind)
{
  switch (kind) {
    case command::KIND_TWIST:
      return MotionKind::kTwist;
    case command::KIND_LIFT:
      return MotionKind::kLift;
    case command::KIND_LOWER:
      return MotionKind::kLower;
    case command::KIND_STEER:
      return MotionKind::kSteer;
    case command::KIND_HOLD:
      return MotionKind::kHold;
    case command::KIND_STOP:
      return MotionKind::kStop;
    default:
      return MotionKind::kUnknown;
  }
}

stetro_msgs::msg::ContactState to_contact(const ContactReading & from)
{
  stetro_msgs::msg::ContactState message;
  message.state(from.closed ? contact::STATE_CLOSED : contact::STATE_OPEN);
  message.last_change(stamp_of(from.last_change));
  message.fault(from.fault);
  return message;
}

stetro_msgs::msg::BlockState to_block(const BlockReading & from)
{
  stetro_msgs::msg::BlockState message;
  message.height(from.height_m);
  message.target(from.target_m);
  message.moving(from.moving);
  message.at_lower_lock(from.at_lower_lock);
  message.at_upper_lock(from.at_upper_lock);
  message.load(from.load);
  message.fault(from.fault);
  return message;
}

geometry_msgs::msg::Quaternion turned(double yaw_rad)
{
  geometry_msgs::msg::Quaternion q;
  q.z(std::sin(yaw_rad / 2.0));
  q.w(std::cos(yaw_rad / 2.0));
  return q;
}

/// A 6x6 diagonal over x, y, z and the turns about x, y, z.
std::array<double, 36> diagonal(double x, double y, double z, double tilt, double yaw)
{
  std::array<double, 36> covariance{};
  covariance[0] = x;
  covariance[7] = y;
  covariance[14] = z;
  covariance[21] = tilt;
  covariance[28] = tilt;
  covariance[35] = yaw;
  return covariance;
}

/// Grows with what was rolled and turned. A heading that drifted carries what is rolled sideways.
std::array<double, 36> drift_of(const OdometryReading & odometry)
{
  const double yaw_rad =
    std::hypot(kHeadingDrift * odometry.turned_rad, kHeadingPerMetre * odometry.rolled_m);
  const double position_m =
    std::hypot(kPositionDrift * odometry.rolled_m, std::min(yaw_rad, 1.0) * odometry.rolled_m);
  const double across = position_m * position_m;
  return diagonal(across, across, kNotMeasured, kNotMeasured, yaw_rad * yaw_rad);
}

geometry_msgs::msg::TransformStamped transform(
  Time time, const std::string & parent, const std::string & child, const Vector3 & at_m,
  const geometry_msgs::msg::Quaternion & rotation)
{
  geometry_msgs::msg::TransformStamped message;
  message.header(header_of(time, parent));
  message.child_frame_id(child);
  message.transform().translation().x(at_m.x);
  message.transform().translation().y(at_m.y);
  message.transform().translation().z(at_m.z);
  message.transform().rotation(rotation);
  return message;
}

std::string block_frame(int block) { return "block" + std::to_string(block); }

/// The rotation that takes +x to a beam along an axis of the body.
geometry_msgs::msg::Quaternion along(const Vector3 & direction)
{
  if (direction.z < -0.5) {
    geometry_msgs::msg::Quaternion down;  // +90 degrees about y
    down.y(std::sqrt(0.5));
    down.w(std::sqrt(0.5));
    return down;
  }
  return turned(std::atan2(direction.y, direction.x));
}

}  // namespace

std_msgs::msg::Header header_of(Time time, const std::string & frame)
{
  std_msgs::msg::Header header;
  header.stamp(stamp_of(time));
  header.frame_id(frame);
  return header;
}

CommandRequest to_request(const stetro_msgs::msg::Command & message)
{
  CommandRequest request;
  request.issuer = message.issuer().c_str();
  request.issuer_cut = stetro_msgs::fills_a_string(message);  // it has no other bounded string
  request.issuer_instance = message.issuer_instance();
  request.sequence_number = message.sequence_number();
  request.stamp = time_of(message.header().stamp());
  request.valid_for =
    std::chrono::seconds{message.valid_for().sec()} + Time{message.valid_for().nanosec()};
  request.motion.kind = kind_of(message.kind());
  request.motion.vx_m_s = message.vx();
  request.motion.vy_m_s = message.vy();
  request.motion.wz_rad_s = message.wz();
  request.motion.block = message.block();
  request.motion.steering_rad = message.steering_angle();
  return request;
}

stetro_msgs::msg::RangeArray to_ranges(const SensorFrame & frame)
{
  stetro_msgs::msg::RangeArray message;
  message.header(header_of(frame.time, kBase));
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    const RangeReading & from = frame.ranges[i];
    stetro_msgs::msg::RangeReading to;
    to.stamp(stamp_of(from.stamp));
    to.sensor(std::string(kRangeNames[i]));
    to.range(from.range_m);
    to.standard_deviation(from.std_dev_m);
    to.status(status_of(from.status));
    message.readings().push_back(to);
  }
  return message;
}

sensor_msgs::msg::Range to_range(
  const SensorFrame & frame, RangePlace place, const stetro_site::RangeSensor & sensor)
{
  const RangeReading & from = frame.range(place);
  sensor_msgs::msg::Range message;
  message.header(header_of(from.stamp, std::string(kRangeNames[static_cast<std::size_t>(place)])));
  message.radiation_type(sensor_msgs::msg::Range_Constants::INFRARED);
  message.field_of_view(static_cast<float>(sensor.cone_rad));
  message.min_range(static_cast<float>(sensor.min_range_m));
  message.max_range(static_cast<float>(sensor.reliable_range_m));
  message.range(static_cast<float>(from.range_m));
  const double variance = from.std_dev_m * from.std_dev_m;
  message.variance(std::isfinite(variance) ? static_cast<float>(variance) : 0.0F);  // 0: unknown
  return message;
}

stetro_msgs::msg::Contacts to_contacts(const SensorFrame & frame)
{
  const auto at = [&](ContactPlace place) { return to_contact(frame.contact(place)); };
  stetro_msgs::msg::Contacts message;
  message.header(header_of(frame.time, kBase));
  message.left_front(at(ContactPlace::kLeftFront));
  message.left_middle(at(ContactPlace::kLeftMiddle));
  message.left_rear(at(ContactPlace::kLeftRear));
  message.right_front(at(ContactPlace::kRightFront));
  message.right_middle(at(ContactPlace::kRightMiddle));
  message.right_rear(at(ContactPlace::kRightRear));
  message.riser_left(at(ContactPlace::kRiserLeft));
  message.riser_right(at(ContactPlace::kRiserRight));
  message.emergency_stop(at(ContactPlace::kEmergencyStop));
  return message;
}

stetro_msgs::msg::BlockStates to_blocks(const SensorFrame & frame)
{
  stetro_msgs::msg::BlockStates message;
  message.header(header_of(frame.blocks_stamp, kBase));
  message.block1(to_block(frame.block(1)));
  message.block2(to_block(frame.block(2)));
  message.block3(to_block(frame.block(3)));
  message.steering_angle(frame.steering.angle_rad);
  message.steering_target(frame.steering.target_rad);
  message.steering_moving(frame.steering.moving);
  return message;
}

sensor_msgs::msg::Imu to_imu(const GyroReading & gyro)
{
  sensor_msgs::msg::Imu message;
  message.header(header_of(gyro.stamp, kBase));
  message.orientation_covariance()[0] = -1.0;  // not measured, as ROS 2 says it
  message.linear_acceleration_covariance()[0] = -1.0;
  message.orientation().w(1.0);
  if (gyro.attitude) {
    const Quaternion & q = gyro.attitude->base_in_world;
    const double tilt = std::pow(gyro.attitude->tilt_std_dev_rad, 2);
    message.orientation().x(q.x);
    message.orientation().y(q.y);
    message.orientation().z(q.z);
    message.orientation().w(q.w);
    message.orientation_covariance() = {
      tilt, 0, 0, 0, tilt, 0, 0, 0, std::pow(gyro.attitude->yaw_std_dev_rad, 2)};
  }
  if (gyro.acceleration_m_s2) {
    const double noise = std::pow(gyro.acceleration_std_dev_m_s2, 2);
    message.linear_acceleration().x((*gyro.acceleration_m_s2)[0]);
    message.linear_acceleration().y((*gyro.acceleration_m_s2)[1]);
    message.linear_acceleration().z((*gyro.acceleration_m_s2)[2]);
    message.linear_acceleration_covariance() = {noise, 0, 0, 0, noise, 0, 0, 0, noise};
  }
  message.angular_velocity().x(gyro.rate_rad_s[0]);
  message.angular_velocity().y(gyro.rate_rad_s[1]);
  message.angular_velocity().z(gyro.rate_rad_s[2]);
  const double variance = gyro.std_dev_rad_s * gyro.std_dev_rad_s;
  message.angular_velocity_covariance() = {variance, 0, 0, 0, variance, 0, 0, 0, variance};
  return message;
}

nav_msgs::msg::Odometry to_odometry(const OdometryReading & odometry)
{
  nav_msgs::msg::Odometry message;
  message.header(header_of(odometry.stamp, "odom"));
  message.child_frame_id(kBase);
  message.pose().pose().position().x(odometry.x_m);
  message.pose().pose().position().y(odometry.y_m);
  message.pose().pose().orientation(turned(odometry.yaw_rad));
  message.pose().covariance(drift_of(odometry));
  message.twist().twist().linear().x(odometry.vx_m_s);
  message.twist().twist().linear().y(odometry.vy_m_s);
  message.twist().twist().angular().z(odometry.wz_rad_s);
  message.twist().covariance(
    diagonal(kSpeedVariance, kSpeedVariance, kNotMeasured, kNotMeasured, kTurnVariance));
  return message;
}

rosgraph_msgs::msg::Clock to_clock(Time time)
{
  rosgraph_msgs::msg::Clock message;
  message.clock(stamp_of(time));
  return message;
}

tf2_msgs::msg::TFMessage to_transforms(const SensorFrame & frame, const BodyShape & body)
{
  tf2_msgs::msg::TFMessage message;
  const OdometryReading & odometry = frame.odometry;
  message.transforms().push_back(transform(
    frame.time, "odom", kBase, {odometry.x_m, odometry.y_m, 0.0}, turned(odometry.yaw_rad)));
  // base_link is on the surface that block 2 stands on; lifted, it left block 3's.
  const double surface_m = frame.block(frame.block(2).at_lower_lock ? 2 : 3).height_m;
  for (int block = 1; block <= 3; ++block) {
    message.transforms().push_back(transform(
      frame.time, kBase, block_frame(block),
      {body.block_x_m(block), 0.0, frame.block(block).height_m - surface_m}, turned(0.0)));
  }
  return message;
}

sensor_msgs::msg::LaserScan to_scan(const LidarScan & scan)
{
  const auto beams = static_cast<double>(scan.ranges_m.size());
  sensor_msgs::msg::LaserScan message;
  message.header(header_of(scan.stamp, kLidar));
  message.angle_min(static_cast<float>(scan.angle_min_rad));
  message.angle_max(
    static_cast<float>(scan.angle_min_rad + (beams - 1.0) * scan.angle_increment_rad));
  message.angle_increment(static_cast<float>(scan.angle_increment_rad));
  message.time_increment(0.0F);  // a turn is one instant
  message.scan_time(static_cast<float>(scan.period_s));
  message.range_min(static_cast<float>(scan.min_range_m));
  message.range_max(static_cast<float>(scan.max_range_m));
  message.ranges(scan.ranges_m);
  return message;
}

tf2_msgs::msg::TFMessage to_static_transforms(Time time, const BodyShape & body, bool lidar)
{
  tf2_msgs::msg::TFMessage message;
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    const TofMounting & tof = body.tof[i];
    message.transforms().push_back(transform(
      time, block_frame(tof.block), std::string(kRangeNames[i]),
      {tof.position_m.x - body.block_x_m(tof.block), tof.position_m.y, tof.position_m.z},
      along(tof.direction)));
  }
  if (lidar) {
    message.transforms().push_back(transform(
      time, kBase, kLidar, {body.lidar.x_m, body.lidar.y_m, body.lidar.height_m},
      turned(body.lidar.yaw_rad)));
  }
  return message;
}

stetro_msgs::msg::StairPose to_ground_truth(const GroundTruth & truth, int steps)
{
  namespace stair_pose = stetro_msgs::msg::StairPose_Constants;
  stetro_msgs::msg::StairPose message;
  message.header(header_of(truth.time, truth.segment));
  message.segment_id(truth.segment);
  message.segment_kind(truth.on_floor ? stair_pose::SEGMENT_FLOOR : stair_pose::SEGMENT_FLIGHT);
  message.step_index(truth.step);
  message.step_count(steps);
  message.step_probability(1.0);
  message.pose().pose().position().x(truth.x_m);
  message.pose().pose().position().y(truth.y_m);
  message.pose().pose().position().z(truth.z_m);
  message.pose().pose().orientation(turned(truth.yaw_rad));
  message.tread_x(truth.tread_x_m);
  message.tread_y(truth.on_floor ? kUnknown : truth.y_m);
  message.block_heights(truth.block_heights_m);
  message.protection_along(kUnknown);
  message.protection_across(kUnknown);
  message.protection_heading(kUnknown);
  message.integrity_risk(kUnknown);
  return message;
}

}  // namespace stetro_driver
