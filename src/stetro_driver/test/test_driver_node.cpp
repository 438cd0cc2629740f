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
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "loopback.hpp"
#include "pilot.hpp"
#include "stetro_dds/qos.hpp"
#include "stetro_driver/driver_node.hpp"
#include "stetro_msgs/Clock.hpp"
#include "stetro_msgs/Command.hpp"
#include "stetro_msgs/CommandStatus.hpp"
#include "stetro_msgs/Contacts.hpp"
#include "stetro_msgs/Imu.hpp"
#include "stetro_msgs/PoseWithCovarianceStamped.hpp"
#include "stetro_msgs/RangeArray.hpp"
#include "stetro_msgs/StairPose.hpp"

namespace stetro_driver
{
namespace
{

namespace qos = stetro_dds::qos;
namespace command = stetro_msgs::msg::Command_Constants;
namespace status = stetro_msgs::msg::CommandStatus_Constants;
using std::chrono::milliseconds;
using std::chrono::seconds;
using stetro_msgs::msg::Command;
using stetro_msgs::msg::CommandStatus;

DriverSetup setup_of(const DriverParams & params)
{
  stetro_site::FlightSpec spec;
  spec.id = "stairs";
  spec.steps = stetro_site::equal_steps(16, 0.14, 0.32);
  spec.width_foot_m = 2.05;
  spec.width_top_m = 2.05;
  spec.lower_floor = "ground";
  spec.upper_floor = "first";
  return DriverSetup{params, stetro_site::Flight{spec}, stetro_site::Robot{}};
}

DriverParams quiet()
{
  DriverParams params;
  params.sim.world = "site";
  params.sim.errors = no_errors();
  params.sim.start = {-0.5, 1.025, 0.0};
  return params;
}

stetro_dds::NodeOptions named(const char * name)
{
  stetro_dds::NodeOptions options;
  options.name = name;
  options.ns = "/stetro";
  return options;
}

/// A driver, and beside it a node that listens to it and commands it, in one process.
class DriverNodeTest : public ::testing::Test
{
protected:
  DriverNodeTest() : context_(test::loopback()), observer_(context_, named("observer"))
  {
    command_ = &observer_.advertise<Command>("command", qos::kCommand);
    pose_ = &observer_.advertise<geometry_msgs::msg::PoseWithCovarianceStamped>("pose", qos::kPose);
    count<rosgraph_msgs::msg::Clock>("/clock", qos::kClock);
    count<sensor_msgs::msg::Imu>("imu/data", qos::kSensor);
    count<stetro_msgs::msg::RangeArray>("ranges", qos::kSensor);
    count<stetro_msgs::msg::Contacts>("contacts", qos::kContacts);
    count<stetro_msgs::msg::StairPose>("ground_truth", qos::kSensor);
    observer_.subscribe<CommandStatus>(
      "command_status", qos::kCommandStatus,
      [this](const CommandStatus & message) { answers_.push_back(message); });
    executor_.add(observer_);
  }

  void launch(const DriverParams & params)
  {
    driver_.emplace(context_, named("driver"), setup_of(params));
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

  [[nodiscard]] double x_m() const { return driver_->robot().truth().x_m; }

  /// A valid command to roll forward at 0.1 m/s.
  Command roll()
  {
    const Time now = driver_->robot().time();
    Command message;
    message.header().stamp().sec(static_cast<std::int32_t>(now.count() / 1'000'000'000));
    message.header().stamp().nanosec(static_cast<std::uint32_t>(now.count() % 1'000'000'000));
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

TEST_F(DriverNodeTest, TellsEachTopicAtItsRate)
{
  launch(quiet());
  received_.clear();
  step(100);
  EXPECT_EQ(received_["/clock"], 100);
  EXPECT_EQ(received_["imu/data"], 100);
  EXPECT_EQ(received_["ground_truth"], 100);
  EXPECT_NEAR(received_["ranges"], 30, 1);
  EXPECT_NEAR(received_["contacts"], 10, 1);
}

TEST_F(DriverNodeTest, KeepsGroundTruthToItselfWhenToldTo)
{
  DriverParams params = quiet();
  params.sim.ground_truth = false;
  launch(params);
  step(10);
  EXPECT_EQ(received_["ground_truth"], 0);
}

TEST_F(DriverNodeTest, DoesWhatItIsCommandedAndSaysSo)
{
  launch(quiet());
  step(10);
  const CommandStatus answer = ask(roll());
  EXPECT_EQ(answer.outcome(), status::OUTCOME_ACCEPTED);
  EXPECT_EQ(answer.sequence_number(), 1u);
  EXPECT_EQ(answer.driver_state(), status::DRIVER_ACTIVE);
  step(10);
  EXPECT_NEAR(x_m(), -0.49, 1e-9);
}

TEST_F(DriverNodeTest, StandsWithin200MillisecondsOfTheLastCommand)
{
  launch(quiet());
  for (int i = 0; i < 20; ++i) {
    ask(roll());
    step(5);
  }
  ask(roll());
  answers_.clear();
  step(20);
  const double stopped_m = x_m();
  step(100);
  EXPECT_EQ(x_m(), stopped_m);
  ASSERT_EQ(answers_.size(), 1u);
  EXPECT_EQ(answers_.front().outcome(), status::OUTCOME_EXPIRED);
  EXPECT_EQ(ask(roll()).outcome(), status::OUTCOME_ACCEPTED) << "commands returned";
  step(5);
  EXPECT_GT(x_m(), stopped_m);
}

TEST_F(DriverNodeTest, SaysWhenALiftHasArrived)
{
  launch(quiet());
  Command lift = roll();
  lift.kind(command::KIND_LIFT);
  lift.vx(0.0);
  lift.block(1);
  bool done = false;
  for (int i = 0; i < 80 && !done; ++i) {
    Command renewed = roll();
    lift.header(renewed.header());
    lift.sequence_number(renewed.sequence_number());
    ask(lift);
    step(5);
    done = answers_.back().outcome() == status::OUTCOME_DONE;
  }
  EXPECT_TRUE(done);
  EXPECT_NEAR(driver_->robot().truth().block_heights_m[0], 0.18, 1e-9);
}

TEST_F(DriverNodeTest, RefusesAndCounts)
{
  launch(quiet());
  Command wrong = roll();
  wrong.vx(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(ask(wrong).reason(), status::REASON_NOT_FINITE);
  wrong = roll();
  wrong.kind(77);
  EXPECT_EQ(ask(wrong).reason(), status::REASON_UNKNOWN_KIND);
  wrong = roll();
  wrong.header().stamp().sec(0);
  wrong.header().stamp().nanosec(0);
  EXPECT_EQ(ask(wrong).reason(), status::REASON_BAD_STAMP);
  wrong = roll();
  wrong.vx(0.0);
  wrong.vy(0.1);
  EXPECT_EQ(ask(wrong).reason(), status::REASON_WRONG_STEERING);
  EXPECT_EQ(ask(roll()).outcome(), status::OUTCOME_ACCEPTED);
  wrong = roll();
  wrong.issuer("joystick");
  EXPECT_EQ(ask(wrong).reason(), status::REASON_FOREIGN_ISSUER);
  wrong = roll();
  wrong.sequence_number(1);
  EXPECT_EQ(ask(wrong).reason(), status::REASON_OUT_OF_ORDER);
  const auto & subscriptions = driver_->node().subscriptions();
  for (const auto & subscription : subscriptions) {
    if (subscription->topic() == "/stetro/command") {
      EXPECT_EQ(subscription->counts().refused, 6u);
      EXPECT_EQ(subscription->counts().refused_by_reason.at("not_finite"), 1u);
    }
  }
}

TEST_F(DriverNodeTest, RefusesCommandsWhileInactive)
{
  DriverParams params = quiet();
  params.start_active = false;
  launch(params);
  step(10);
  EXPECT_GT(received_["imu/data"], 0) << "sensors are read";
  const CommandStatus answer = ask(roll());
  EXPECT_EQ(answer.reason(), status::REASON_NOT_ACTIVE);
  EXPECT_EQ(answer.driver_state(), status::DRIVER_INACTIVE);
}

TEST_F(DriverNodeTest, RunsFasterThanRealTimeUntilToldToStop)
{
  DriverParams params = quiet();
  params.sim.speed = 50.0;
  launch(params);
  const Time begin = stetro_dds::Clock::steady_now();
  const Time from = driver_->robot().time();
  driver_->run(executor_, [&] { return driver_->robot().time() - from >= seconds{5}; });
  const Time took = stetro_dds::Clock::steady_now() - begin;
  EXPECT_GE(took, milliseconds{95});
  EXPECT_LT(took, seconds{5});
}

TEST_F(DriverNodeTest, WaitsForALocalizerThatFallsSilent)
{
  DriverParams params = quiet();
  params.sim.speed = 50.0;
  launch(params);
  geometry_msgs::msg::PoseWithCovarianceStamped pose;
  pose.header().stamp().sec(1000);
  pose_->publish(pose);
  const Time begin = stetro_dds::Clock::steady_now();
  driver_->run(executor_, [&] { return driver_->robot().time() >= milliseconds{1'000'200}; });
  // 90 ms at speed 50, 200 ms of patience, then 110 ms at real time.
  EXPECT_GE(stetro_dds::Clock::steady_now() - begin, milliseconds{300});
}

}  // namespace
}  // namespace stetro_driver
