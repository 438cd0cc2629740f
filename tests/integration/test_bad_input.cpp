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

// A peer sends what no driver would while the robot climbs: it is refused and counted, nothing
// crashes, and the estimate stays what it was.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <string>

#include "integration/refusals.hpp"
#include "integration/simulated_time.hpp"
#include "stetro_dds/stamp.hpp"
#include "stetro_msgs/BlockStates.hpp"
#include "stetro_msgs/Contacts.hpp"
#include "stetro_msgs/Imu.hpp"
#include "stetro_msgs/Odometry.hpp"
#include "stetro_msgs/RangeArray.hpp"
#include "stetro_tests/raw_message.hpp"

namespace stetro_tests
{

using builtin_interfaces::msg::Time;
using nav_msgs::msg::Odometry;
using sensor_msgs::msg::Imu;
using stetro_dds::stamp_of;
using stetro_msgs::msg::BlockStates;
using stetro_msgs::msg::Command;
using stetro_msgs::msg::CommandStatus;
using stetro_msgs::msg::Contacts;
using stetro_msgs::msg::MissionRequest;
using stetro_msgs::msg::RangeArray;
using stetro_msgs::msg::RangeReading;
namespace reading_constants = stetro_msgs::msg::RangeReading_Constants;
namespace pose_constants = stetro_msgs::msg::StairPose_Constants;
namespace command_constants = stetro_msgs::msg::Command_Constants;
namespace outcome = stetro_msgs::msg::CommandStatus_Constants;
namespace qos = stetro_dds::qos;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class BadInput : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    run_ = std::make_unique<RobotRun>();
    hostile_ = std::make_unique<Observer>(run_->domain, "hostile");
    ASSERT_EQ(run_->start_climb(), "");
    ASSERT_EQ(wait_moment(*run_, {"sweep_left", 1}), "");
  }

  static void TearDownTestSuite()
  {
    hostile_.reset();
    run_.reset();
  }

  /// Nobody crashed, the pose is sound and where the truth is, the mission goes on.
  void TearDown() override
  {
    for (Process * process :
         {&run_->stack.driver(), &run_->stack.localizer(), &run_->stack.supervisor()}) {
      EXPECT_TRUE(process->running()) << process->tail();
    }
    const auto pose = run_->pose.last();
    const auto truth = run_->truth.last();
    ASSERT_TRUE(pose && truth);
    EXPECT_NE(pose->integrity(), pose_constants::INTEGRITY_LOST);
    EXPECT_NEAR(pose->tread_y(), truth->tread_y(), 0.05);
    EXPECT_NEAR(pose->step_index(), truth->step_index(), 1);
    EXPECT_STREQ(run_->operators.status().last()->fault().c_str(), "");
  }

  /// Sends messages until the node has counted a refusal more on the topic.
  template <class Send>
  void expect_refused(const std::string & node, const std::string & topic, Send send)
  {
    const auto speaks = [&](const auto & array) { return refused_count(array, node, topic) >= 0; };
    run_->diagnostics.forget();
    const auto before = run_->diagnostics.wait_for(speaks, 20s);
    ASSERT_TRUE(before) << node << " says nothing about " << topic;
    const std::int64_t count = refused_count(*before, node, topic);
    const Deadline deadline{20s};
    bool counted = false;
    while (!counted && !deadline.passed()) {
      send();
      counted =
        run_->diagnostics
          .wait_for(
            [&](const auto & array) { return refused_count(array, node, topic) > count; }, 500ms)
          .has_value();
    }
    EXPECT_TRUE(counted) << node << " counted no refusal on " << topic;
  }

  /// A sample of one good reading but for what `spoil` does to it.
  template <class Spoil>
  void expect_ranges_refused(Spoil spoil)
  {
    auto & writer = hostile_->publisher<RangeArray>("ranges", qos::kSensor);
    expect_refused("localizer", "/stetro/ranges", [&] {
      RangeArray message = good_ranges();
      spoil(message);
      writer.publish(message);
    });
  }

  static RangeArray good_ranges()
  {
    const Time now = stamp_of(now_simulated(*run_));
    RangeArray message;
    message.header().stamp(now);
    message.header().frame_id("base_link");
    message.readings().resize(1);
    RangeReading & reading = message.readings().front();
    reading.stamp(now);
    reading.sensor("side_left");
    reading.range(0.3);
    reading.standard_deviation(0.01);
    reading.status(reading_constants::STATUS_VALID);
    return message;
  }

  static std::unique_ptr<RobotRun> run_;
  static std::unique_ptr<Observer> hostile_;
};

std::unique_ptr<RobotRun> BadInput::run_;
std::unique_ptr<Observer> BadInput::hostile_;

TEST_F(BadInput, ValidRangesThatAreNoNumbers)
{
  for (const double range : {kNan, kInfinity, -kInfinity, -0.2}) {
    SCOPED_TRACE(range);
    expect_ranges_refused([&](RangeArray & m) { m.readings().front().range(range); });
  }
}

TEST_F(BadInput, StampsOfZeroOfTheFutureAndOfThePast)
{
  const auto restamp = [](RangeArray & message, std::chrono::nanoseconds time) {
    message.header().stamp(stamp_of(time));
    message.readings().front().stamp(stamp_of(time));
  };
  expect_ranges_refused([&](RangeArray & m) { restamp(m, 0s); });
  expect_ranges_refused([&](RangeArray & m) { restamp(m, now_simulated(*run_) + 60s); });
  expect_ranges_refused([&](RangeArray & m) { restamp(m, now_simulated(*run_) - 5s); });
}

TEST_F(BadInput, OtherSensorsThatAreNotFinite)
{
  auto & imu = hostile_->publisher<Imu>("imu/data", qos::kSensor);
  expect_refused("localizer", "/stetro/imu/data", [&] {
    Imu message;
    message.header().stamp(stamp_of(now_simulated(*run_)));
    message.angular_velocity().z(kNan);
    imu.publish(message);
  });
  auto & odometry = hostile_->publisher<Odometry>("odom", qos::kSensor);
  expect_refused("localizer", "/stetro/odom", [&] {
    Odometry message;
    message.header().stamp(stamp_of(now_simulated(*run_)));
    message.twist().twist().linear().x(kInfinity);
    odometry.publish(message);
  });
}

TEST_F(BadInput, ASequenceLongerThanItsBoundAndAnImpossibleBoolean)
{
  Observer raw(run_->domain, "raw");
  auto & ranges = raw.publisher<Raw<RangeArray>>("ranges", qos::kSensor);
  expect_refused("localizer", "/stetro/ranges", [&] {
    RangeArray message = good_ranges();
    message.readings().resize(17, message.readings().front());
    ranges.publish({bytes_of(message)});
  });
  auto & blocks = raw.publisher<Raw<BlockStates>>("blocks", qos::kSensor);
  const auto send_impossible_boolean = [&] {
    BlockStates message;
    message.header().stamp(stamp_of(now_simulated(*run_)));
    Bytes bytes = bytes_of(message);
    bytes.back() = 2;  // steering_moving
    blocks.publish({bytes});
  };
  expect_refused("localizer", "/stetro/blocks", send_impossible_boolean);
  expect_refused("supervisor", "/stetro/blocks", send_impossible_boolean);
}

TEST_F(BadInput, BytesOfNoSenseOnEveryTopicThatIsListenedTo)
{
  Observer raw(run_->domain, "noise");
  auto & ranges = raw.publisher<Raw<RangeArray>>("ranges", qos::kSensor);
  auto & blocks = raw.publisher<Raw<BlockStates>>("blocks", qos::kSensor);
  auto & contacts = raw.publisher<Raw<Contacts>>("contacts", qos::kContacts);
  auto & commands = raw.publisher<Raw<Command>>("command", qos::kCommand);
  auto & missions = raw.publisher<Raw<MissionRequest>>("mission", qos::kMission);
  std::mt19937 random{20250301};
  std::uniform_int_distribution<int> byte{0, 255};
  std::uniform_int_distribution<std::size_t> length{0, 400};
  for (int i = 0; i < 300; ++i) {
    Bytes bytes(length(random));
    for (auto & value : bytes) {
      value = static_cast<std::uint8_t>(byte(random));
    }
    if (bytes.size() >= 4 && i % 2 == 0) {
      bytes[0] = 0;  // every other one claims to be plain CDR and is decoded
      bytes[1] = 1;
    }
    ranges.publish({bytes});
    blocks.publish({bytes});
    contacts.publish({bytes});
    commands.publish({bytes});
    missions.publish({bytes});
  }
  EXPECT_TRUE(let_pass(*run_, 2s)) << run_->stack.tails();
}

class BadCommand : public BadInput
{
protected:
  /// A command of someone who is not the supervisor, finished by `spoil`, is refused.
  template <class Spoil>
  void expect_command_refused(Spoil spoil)
  {
    auto & writer = hostile_->publisher<Command>("command", qos::kCommand);
    static std::uint64_t sequence = 0;
    const auto answers = [](const CommandStatus & status) {
      return std::string(status.issuer().c_str()) == "intruder" &&
             status.sequence_number() == sequence;
    };
    const Deadline deadline{20s};
    while (!deadline.passed()) {
      Command command;
      command.header().stamp(stamp_of(now_simulated(*run_)));
      command.sequence_number(++sequence);
      command.issuer("intruder");
      command.issuer_instance(42);
      command.valid_for().nanosec(150'000'000);
      command.kind(command_constants::KIND_TWIST);
      spoil(command);
      writer.publish(command);
      if (const auto status = run_->command_status.wait_for(answers, 500ms)) {
        EXPECT_EQ(status->outcome(), outcome::OUTCOME_REFUSED);
        EXPECT_NE(status->reason(), outcome::REASON_NONE);
        reason_ = status->reason();
        return;
      }
    }
    ADD_FAILURE() << "no answer to the command";
  }

  int reason_ = -1;
};

TEST_F(BadCommand, OfASecondIssuer)
{
  ASSERT_EQ(wait_moment(*run_, {"sweep_left", run_->truth.last()->step_index() + 1}), "");
  expect_command_refused([](Command & command) { command.vy(-0.05); });
  EXPECT_EQ(reason_, outcome::REASON_FOREIGN_ISSUER);
}

TEST_F(BadCommand, ThatMakesNoSense)
{
  expect_command_refused([](Command & command) { command.vx(kNan); });
  expect_command_refused([](Command & command) { command.kind(99); });
  expect_command_refused([](Command & command) { command.valid_for().nanosec(0); });
  expect_command_refused([](Command & command) { command.header().stamp(Time()); });
}

}  // namespace stetro_tests
