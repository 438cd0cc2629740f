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

#include "node/driver_topics.hpp"

#include <algorithm>
#include <string>

#include "stetro_dds/qos.hpp"
#include "stetro_driver/site_shape.hpp"

namespace stetro_driver
{
namespace
{

namespace qos = stetro_dds::qos;

constexpr Time kContactsPeriod = std::chrono::milliseconds{100};

}  // namespace

DriverTopics::DriverTopics(stetro_dds::Node & node, const DriverSetup & setup, World world)
: body_(shape_of(setup.robot)),
  site_(setup.site),
  lidar_(world == World::kReal || sim_options(setup).lidar),
  range_sensor_(setup.robot.geometry.range_sensor),
  ranges_(node.advertise<stetro_msgs::msg::RangeArray>("ranges", qos::kSensor)),
  contacts_(node.advertise<stetro_msgs::msg::Contacts>("contacts", qos::kContacts)),
  blocks_(node.advertise<stetro_msgs::msg::BlockStates>("blocks", qos::kSensor)),
  imu_(node.advertise<sensor_msgs::msg::Imu>("imu/data", qos::kSensor)),
  odometry_(node.advertise<nav_msgs::msg::Odometry>("odom", qos::kSensor)),
  transforms_(node.advertise<tf2_msgs::msg::TFMessage>("/tf", qos::kTf)),
  static_transforms_(node.advertise<tf2_msgs::msg::TFMessage>("/tf_static", qos::kTfStatic))
{
  const bool simulated = world == World::kSimulated;
  if (simulated) {
    clock_ = &node.advertise<rosgraph_msgs::msg::Clock>("/clock", qos::kClock);
  }
  if (simulated && setup.params.sim.ground_truth) {
    ground_truth_ = &node.advertise<stetro_msgs::msg::StairPose>("ground_truth", qos::kSensor);
  }
  if (simulated && lidar_) {
    scan_ = &node.advertise<sensor_msgs::msg::LaserScan>("scan", qos::kSensor);
  }
  if (setup.params.range_topics) {
    for (const auto name : kRangeNames) {
      range_topics_.push_back(
        &node.advertise<sensor_msgs::msg::Range>("range/" + std::string(name), qos::kSensor));
    }
  }
}

void DriverTopics::publish_static(Time now)
{
  static_transforms_.publish(to_static_transforms(now, body_, lidar_));
}

void DriverTopics::publish(const SensorFrame & frame)
{
  if (clock_ != nullptr) {
    clock_->publish(to_clock(frame.time));
  }
  if (frame.odometry.stamp > odometry_sent_) {
    odometry_sent_ = frame.odometry.stamp;
    odometry_.publish(to_odometry(frame.odometry));
  }
  if (!frame.gyro.fault && frame.gyro.stamp > gyro_sent_) {
    gyro_sent_ = frame.gyro.stamp;
    imu_.publish(to_imu(frame.gyro));
  }
  if (contacts_due(frame)) {
    contacts_.publish(to_contacts(frame));
  }
  if (scan_ != nullptr && frame.scan_complete) {
    scan_->publish(to_scan(*frame.scan));
  }
  if (!frame.ranges_complete) {
    return;
  }
  blocks_.publish(to_blocks(frame));
  ranges_.publish(to_ranges(frame));
  transforms_.publish(to_transforms(frame, body_));
  for (std::size_t i = 0; i < range_topics_.size(); ++i) {
    if (frame.ranges[i].status != RangeStatus::kFault) {
      range_topics_[i]->publish(to_range(frame, static_cast<RangePlace>(i), range_sensor_));
    }
  }
}

void DriverTopics::publish(const GroundTruth & truth)
{
  if (ground_truth_ != nullptr) {
    const stetro_site::Flight * flight = site_.find_flight(truth.segment);
    ground_truth_->publish(to_ground_truth(truth, flight != nullptr ? flight->steps() : 0));
  }
}

bool DriverTopics::contacts_due(const SensorFrame & frame)
{
  const bool changed = !std::equal(
    frame.contacts.begin(), frame.contacts.end(), last_contacts_.begin(),
    [](const ContactReading & a, const ContactReading & b) {
      return a.closed == b.closed && a.fault == b.fault;
    });
  if (!changed && frame.time - contacts_sent_ < kContactsPeriod) {
    return false;
  }
  last_contacts_ = frame.contacts;
  contacts_sent_ = frame.time;
  return true;
}

}  // namespace stetro_driver
