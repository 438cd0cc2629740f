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

#ifndef NODE__CONVERT_HPP_
#define NODE__CONVERT_HPP_

#include <string>

#include "stetro_dds/stamp.hpp"
#include "stetro_driver/body_shape.hpp"
#include "stetro_driver/command_gate.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/sim_robot.hpp"
#include "stetro_driver/time.hpp"
#include "stetro_msgs/BlockStates.hpp"
#include "stetro_msgs/Clock.hpp"
#include "stetro_msgs/Command.hpp"
#include "stetro_msgs/CommandStatus.hpp"
#include "stetro_msgs/Contacts.hpp"
#include "stetro_msgs/Imu.hpp"
#include "stetro_msgs/LaserScan.hpp"
#include "stetro_msgs/Odometry.hpp"
#include "stetro_msgs/Range.hpp"
#include "stetro_msgs/RangeArray.hpp"
#include "stetro_msgs/StairPose.hpp"
#include "stetro_msgs/TFMessage.hpp"
#include "stetro_site/robot_geometry.hpp"

/// \file
/// Between the driver's core and the wire: the only place that knows both.

namespace stetro_driver
{

using stetro_dds::stamp_of;
using stetro_dds::time_of;

[[nodiscard]] std_msgs::msg::Header header_of(Time time, const std::string & frame);

/// A command as it came. A kind that we do not know becomes kUnknown, for the gate to refuse.
[[nodiscard]] CommandRequest to_request(const stetro_msgs::msg::Command & message);

[[nodiscard]] stetro_msgs::msg::RangeArray to_ranges(const SensorFrame & frame);
[[nodiscard]] sensor_msgs::msg::Range to_range(
  const SensorFrame & frame, RangePlace place, const stetro_site::RangeSensor & sensor);
[[nodiscard]] stetro_msgs::msg::Contacts to_contacts(const SensorFrame & frame);
[[nodiscard]] stetro_msgs::msg::BlockStates to_blocks(const SensorFrame & frame);
[[nodiscard]] sensor_msgs::msg::Imu to_imu(const GyroReading & gyro);
[[nodiscard]] nav_msgs::msg::Odometry to_odometry(const OdometryReading & odometry);
[[nodiscard]] rosgraph_msgs::msg::Clock to_clock(Time time);

/// odom -> base_link, and base_link -> block1, block2, block3.
[[nodiscard]] tf2_msgs::msg::TFMessage to_transforms(
  const SensorFrame & frame, const BodyShape & body);

[[nodiscard]] sensor_msgs::msg::LaserScan to_scan(const LidarScan & scan);

/// block -> sensor, for each range sensor; x along its beam. And base_link -> lidar, if wanted.
[[nodiscard]] tf2_msgs::msg::TFMessage to_static_transforms(
  Time time, const BodyShape & body, bool lidar);

/// What is really so, as a pose on the stairs or a floor. Covariance, integrity and protection stay
/// unknown. \param steps of the flight; 0 on a floor
[[nodiscard]] stetro_msgs::msg::StairPose to_ground_truth(const GroundTruth & truth, int steps);

}  // namespace stetro_driver

#endif  // NODE__CONVERT_HPP_
