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

#ifndef NODE__DRIVER_TOPICS_HPP_
#define NODE__DRIVER_TOPICS_HPP_

#include <array>
#include <cstdint>
#include <vector>

#include "node/convert.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_driver/driver_setup.hpp"

namespace stetro_driver
{

/// Whose robot it is. A simulation makes the time of everyone, and knows what is really so.
enum class World { kReal, kSimulated };

/// What a driver tells: one publisher a topic, each at its rate.
/**
 *   imu/data, odom                         when measured anew: each tick of a simulation, 100 Hz
 *   /clock, ground_truth                   the same, of a simulation
 *   ranges, blocks, /tf                    with each cycle of the range sensors, 30 Hz
 *   contacts                               on change, and each 100 ms
 *   scan                                   with each turn of a simulated lidar; a real one has
 *                                          a driver of its own
 *   /tf_static                             once
 */
class DriverTopics
{
public:
  DriverTopics(stetro_dds::Node & node, const DriverSetup & setup, World world);

  void publish_static(Time now);
  void publish(const SensorFrame & frame);
  void publish(const GroundTruth & truth);

private:
  [[nodiscard]] bool contacts_due(const SensorFrame & frame);

  const BodyShape body_;
  const stetro_site::Site site_;
  const bool lidar_;  // its place is told
  const stetro_site::RangeSensor range_sensor_;
  stetro_dds::Publisher<stetro_msgs::msg::RangeArray> & ranges_;
  stetro_dds::Publisher<stetro_msgs::msg::Contacts> & contacts_;
  stetro_dds::Publisher<stetro_msgs::msg::BlockStates> & blocks_;
  stetro_dds::Publisher<sensor_msgs::msg::Imu> & imu_;
  stetro_dds::Publisher<nav_msgs::msg::Odometry> & odometry_;
  stetro_dds::Publisher<tf2_msgs::msg::TFMessage> & transforms_;
  stetro_dds::Publisher<tf2_msgs::msg::TFMessage> & static_transforms_;
  stetro_dds::Publisher<rosgraph_msgs::msg::Clock> * clock_ = nullptr;
  stetro_dds::Publisher<stetro_msgs::msg::StairPose> * ground_truth_ = nullptr;
  stetro_dds::Publisher<sensor_msgs::msg::LaserScan> * scan_ = nullptr;
  std::vector<stetro_dds::Publisher<sensor_msgs::msg::Range> *> range_topics_;  // none, or all
  std::array<ContactReading, kContactPlaces> last_contacts_{};
  Time contacts_sent_{0};
  Time odometry_sent_{0};  // stamps: what is told twice is refused as out of order
  Time gyro_sent_{0};
};

}  // namespace stetro_driver

#endif  // NODE__DRIVER_TOPICS_HPP_
