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

#ifndef SUPPORT__SENSOR_WIRE_HPP_
#define SUPPORT__SENSOR_WIRE_HPP_

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "node/convert.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_localizer/estimator.hpp"
#include "stetro_msgs/PoseCorrection.hpp"

namespace stetro_localizer
{

/// A domain id that no other test process holds; the lock ends with the process.
inline std::uint32_t free_domain()
{
  const auto start = static_cast<std::uint32_t>(::getpid());
  for (std::uint32_t i = 0; i < 90; ++i) {
    const std::uint32_t id = 10 + (start + i) % 90;
    const auto path = std::filesystem::temp_directory_path() /
                      ("stetro_test_domain_" + std::to_string(id) + ".lock");
    const int file = ::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0) {
      return id;
    }
    ::close(file);
  }
  throw std::runtime_error("no free domain id between 10 and 99");
}

/// Options of a context on a domain of this test's own, loopback only. ROS_DOMAIN_ID decides.
inline stetro_dds::ContextOptions test_options()
{
  static const std::uint32_t kDomain = std::getenv("ROS_DOMAIN_ID") != nullptr
                                         ? stetro_dds::ContextOptions::from_environment().domain_id
                                         : free_domain();
  stetro_dds::ContextOptions options;
  options.domain_id = kDomain;
  return options;
}

/// In place of an estimator: sends what a StairRobot senses as the driver's messages.
class SensorWire : public Estimator
{
public:
  explicit SensorWire(stetro_dds::Context & context)
  : node_(context, {"driver", "/stetro", stetro_dds::TimeSource::kByHand})
  {
  }

  stetro_dds::Node & node() { return node_; }

  /// What follows each message: the receiver's turn.
  void set_turn(std::function<void(Nanoseconds)> turn) { turn_ = std::move(turn); }

  void begin(const StateReading &) override {}

  Verdict add_ranges(const RangeSample & sample, Nanoseconds now) override
  {
    stetro_msgs::msg::RangeArray message;
    message.header().stamp(stamp_of(sample.stamp));
    for (const Place place : stetro_site::kPlaces) {
      stetro_msgs::msg::RangeReading reading;
      reading.stamp(stamp_of(sample[place].stamp));
      reading.sensor(stetro_site::name_of(place));
      reading.range(sample[place].range_m);
      reading.standard_deviation(std::numeric_limits<double>::quiet_NaN());
      reading.status(static_cast<std::uint8_t>(sample[place].status));
      message.readings().push_back(reading);
    }
    return send(ranges_, message, now);
  }

  Verdict add_contacts(const ContactSample & sample, Nanoseconds now) override
  {
    stetro_msgs::msg::Contacts message;
    message.header().stamp(stamp_of(sample.stamp));
    set(message.left_front(), sample.left[0]);
    set(message.left_middle(), sample.left[1]);
    set(message.left_rear(), sample.left[2]);
    set(message.right_front(), sample.right[0]);
    set(message.right_middle(), sample.right[1]);
    set(message.right_rear(), sample.right[2]);
    set(message.riser_left(), sample.riser_left);
    set(message.riser_right(), sample.riser_right);
    return send(contacts_, message, now);
  }

  Verdict add_blocks(const BlockSample & sample, Nanoseconds now) override
  {
    stetro_msgs::msg::BlockStates message;
    message.header().stamp(stamp_of(sample.stamp));
    const std::array<stetro_msgs::msg::BlockState *, 3> blocks{
      &message.block1(), &message.block2(), &message.block3()};
    for (std::size_t i = 0; i < 3; ++i) {
      blocks[i]->height(sample.blocks[i].height_m);
      blocks[i]->load(sample.blocks[i].load);
      blocks[i]->moving(sample.blocks[i].moving);
    }
    return send(blocks_, message, now);
  }

  Verdict add_gyro(const GyroSample & sample, Nanoseconds now) override
  {
    sensor_msgs::msg::Imu message;
    message.header().stamp(stamp_of(sample.stamp));
    message.angular_velocity().z(sample.rate_radps);
    return send(imu_, message, now);
  }

  Verdict add_odometry(const OdometrySample & sample, Nanoseconds now) override
  {
    nav_msgs::msg::Odometry message;
    message.header().stamp(stamp_of(sample.stamp));
    message.twist().twist().linear().x(sample.vx_mps);
    message.twist().twist().linear().y(sample.vy_mps);
    message.twist().twist().angular().z(sample.wz_radps);
    message.pose().pose().orientation().w(1.0);
    return send(odom_, message, now);
  }

  void tell(const geometry_msgs::msg::PoseWithCovarianceStamped & message)
  {
    send(initialpose_, message, last_);
  }
  void correct(const stetro_msgs::msg::PoseCorrection & message)
  {
    send(correction_, message, last_);
  }

  void tick(Nanoseconds) override {}
  std::optional<std::string> tell_pose(
    const stetro_site::Pose &, const stetro_site::Covariance &) override
  {
    return std::nullopt;
  }
  [[nodiscard]] const StairEstimate & estimate() const override { return estimate_; }
  [[nodiscard]] const SourceReports & reports() const override { return reports_; }
  [[nodiscard]] std::vector<Bias> biases() const override { return {}; }
  [[nodiscard]] const std::vector<Source> & compared() const override { return compared_; }
  [[nodiscard]] StoredState state_to_store() const override { return {}; }
  [[nodiscard]] std::uint64_t state_version() const override { return 0; }

private:
  static void set(stetro_msgs::msg::ContactState & message, Switch from)
  {
    namespace contact = stetro_msgs::msg::ContactState_Constants;
    message.state(from.closed ? contact::STATE_CLOSED : contact::STATE_OPEN);
  }

  template <class Message>
  Verdict send(stetro_dds::Publisher<Message> & publisher, const Message & message, Nanoseconds now)
  {
    last_ = now;
    publisher.publish(message);
    turn_(now);
    return {};
  }

  stetro_dds::Node node_;
  std::function<void(Nanoseconds)> turn_ = [](Nanoseconds) {};
  Nanoseconds last_{0};
  std::vector<Source> compared_;
  StairEstimate estimate_;
  SourceReports reports_;
  stetro_dds::Publisher<stetro_msgs::msg::RangeArray> & ranges_ =
    node_.advertise<stetro_msgs::msg::RangeArray>("ranges", stetro_dds::qos::kSensor);
  stetro_dds::Publisher<stetro_msgs::msg::Contacts> & contacts_ =
    node_.advertise<stetro_msgs::msg::Contacts>("contacts", stetro_dds::qos::kContacts);
  stetro_dds::Publisher<stetro_msgs::msg::BlockStates> & blocks_ =
    node_.advertise<stetro_msgs::msg::BlockStates>("blocks", stetro_dds::qos::kSensor);
  stetro_dds::Publisher<sensor_msgs::msg::Imu> & imu_ =
    node_.advertise<sensor_msgs::msg::Imu>("imu/data", stetro_dds::qos::kSensor);
  stetro_dds::Publisher<nav_msgs::msg::Odometry> & odom_ =
    node_.advertise<nav_msgs::msg::Odometry>("odom", stetro_dds::qos::kSensor);
  stetro_dds::Publisher<geometry_msgs::msg::PoseWithCovarianceStamped> & initialpose_ =
    node_.advertise<geometry_msgs::msg::PoseWithCovarianceStamped>(
      "initialpose", stetro_dds::qos::kCorrection);
  stetro_dds::Publisher<stetro_msgs::msg::PoseCorrection> & correction_ =
    node_.advertise<stetro_msgs::msg::PoseCorrection>(
      "pose_correction", stetro_dds::qos::kCorrection);
};

}  // namespace stetro_localizer

#endif  // SUPPORT__SENSOR_WIRE_HPP_
