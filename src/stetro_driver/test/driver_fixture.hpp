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

#ifndef DRIVER_FIXTURE_HPP_
#define DRIVER_FIXTURE_HPP_

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "buildings.hpp"
#include "loopback.hpp"
#include "pilot.hpp"
#include "stetro_dds/qos.hpp"
#include "stetro_dds/stamp.hpp"
#include "stetro_driver/driver_node.hpp"
#include "stetro_driver/sim_robot.hpp"
#include "stetro_driver/site_shape.hpp"
#include "stetro_msgs/Clock.hpp"
#include "stetro_msgs/Command.hpp"
#include "stetro_msgs/CommandStatus.hpp"
#include "stetro_msgs/Contacts.hpp"
#include "stetro_msgs/Imu.hpp"
#include "stetro_msgs/LaserScan.hpp"
#include "stetro_msgs/PoseWithCovarianceStamped.hpp"
#include "stetro_msgs/RangeArray.hpp"
#include "stetro_msgs/StairPose.hpp"

namespace stetro_driver::test
{

namespace qos = stetro_dds::qos;
namespace command = stetro_msgs::msg::Command_Constants;
namespace status = stetro_msgs::msg::CommandStatus_Constants;
using std::chrono::milliseconds;
using std::chrono::seconds;
using stetro_msgs::msg::Command;
using stetro_msgs::msg::CommandStatus;

inline DriverSetup setup_of(const DriverParams & params)
{
  return DriverSetup{params, site_of(paper_flight()), "stairs", stetro_site::Robot{}};
}

/// A perfect robot on perfect stairs.
inline DriverParams quiet()
{
  DriverParams params;
  params.sim.world = "site";
  params.sim.errors = no_errors();
  params.sim.start = {-0.5, 1.025, 0.0};
  return params;
}

inline stetro_dds::NodeOptions named(const char * name)
{
  stetro_dds::NodeOptions options;
  options.name = name;
  options.ns = "/stetro";
  return options;
}

/// A driver, and beside it a node that listens to it and commands it, in one process.
class DriverFixture : public ::testing::Test
{
protected:
  DriverFixture() : context_(loopback()), observer_(context_, named("observer"))
  {
    command_ = &observer_.advertise<Command>("command", qos::kCommand);
    pose_ = &observer_.advertise<geometry_msgs::msg::PoseWithCovarianceStamped>("pose", qos::kPose);
    count<rosgraph_msgs::msg::Clock>("/clock", qos::kClock);
    count<sensor_msgs::msg::Imu>("imu/data", qos::kSensor);
    count<stetro_msgs::msg::RangeArray>("ranges", qos::kSensor);
    count<stetro_msgs::msg::Contacts>("contacts", qos::kContacts);
    count<stetro_msgs::msg::StairPose>("ground_truth", qos::kSensor);
    count<sensor_msgs::msg::LaserScan>("scan", qos::kSensor);
    observer_.subscribe<CommandStatus>(
      "command_status", qos::kCommandStatus,
      [this](const CommandStatus & message) { answers_.push_back(message); });
    executor_.add(observer_);
  }

  void launch(const DriverParams & params) { launch(setup_of(params)); }

  void launch(const DriverSetup & setup)
  {
    driver_.emplace(context_, named("driver"), setup);
    executor_.add(driver_->node());
    ASSERT_TRUE(driver_->node().wait_matched({"command", "command_status", "ranges"}, seconds{10}));
    driver_->start();
    executor_.drain();
  }

  template <class Message>
  void count(const char * topic, const stetro_dds::QosProfile & profile)
  {
    observer_.subscribe<Message>(
      topic, profile, [this, topic](const Message &) { ++received_[topic]; });
  }

  void step(int ticks)
  {
    for (int i = 0; i < ticks; ++i) {
      driver_->step();
      executor_.drain();
    }
  }

  [[nodiscard]] double x_m() const { return driver_->world()->truth().x_m; }

  /// A valid command to roll forward at 0.1 m/s.
  Command roll()
  {
    Command message;
    message.header().stamp(stetro_dds::stamp_of(driver_->world()->time()));
    message.sequence_number(++sequence_);
    message.issuer("supervisor");
    message.issuer_instance(7);
    message.valid_for().nanosec(150'000'000);
    message.kind(command::KIND_TWIST);
    message.vx(0.1);
    return message;
  }

  /// Sends a command and returns the driver's first answer to it.
  CommandStatus ask(const Command & message)
  {
    answers_.clear();
    command_->publish(message);
    executor_.drain();
    EXPECT_FALSE(answers_.empty());
    return answers_.empty() ? CommandStatus{} : answers_.front();
  }

  /// A command that rolls nowhere.
  CommandStatus ask_to(std::uint8_t kind)
  {
    Command message = roll();
    message.kind(kind);
    message.vx(0.0);
    return ask(message);
  }

  [[nodiscard]] stetro_dds::SubscriptionCounts counts(const std::string & topic)
  {
    const auto & all = driver_->node().subscriptions();
    const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto & one) { return one->topic() == topic; });
    EXPECT_NE(found, all.end()) << topic;
    return found == all.end() ? stetro_dds::SubscriptionCounts{} : (*found)->counts();
  }

  stetro_dds::Context context_;
  stetro_dds::Executor executor_;
  stetro_dds::Node observer_;
  std::optional<DriverNode> driver_;
  stetro_dds::Publisher<Command> * command_ = nullptr;
  stetro_dds::Publisher<geometry_msgs::msg::PoseWithCovarianceStamped> * pose_ = nullptr;
  std::map<std::string, int> received_;
  std::vector<CommandStatus> answers_;
  std::uint64_t sequence_ = 0;
};

}  // namespace stetro_driver::test

#endif  // DRIVER_FIXTURE_HPP_
