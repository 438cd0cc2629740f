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

// The driver's node around a robot whose time passes by itself.

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>

#include "driver_fixture.hpp"
#include "fake_robot.hpp"

namespace stetro_driver
{
namespace
{

namespace status = stetro_msgs::msg::CommandStatus_Constants;
using std::chrono::milliseconds;
using std::chrono::seconds;
using stetro_msgs::msg::Command;
using test::FakeRobot;

class TimedRunTest : public test::DriverFixture
{
protected:
  void SetUp() override
  {
    auto robot = std::make_unique<FakeRobot>();
    robot_ = robot.get();
    driver_.emplace(
      context_, test::named("driver"), test::setup_of(DriverParams{}),
      DriverHardware{std::move(robot), nullptr, nullptr});
    executor_.add(driver_->node());
    ASSERT_TRUE(driver_->node().wait_matched({"command", "command_status", "ranges"}, seconds{10}));
    driver_->start();
  }

  /// Runs until something is so. \return whether it came true
  template <class Done>
  bool run_until(Done && done)
  {
    const Time end = stetro_dds::Clock::steady_now() + seconds{10};
    bool came_true = false;
    driver_->run(executor_, [&] {
      came_true = came_true || done();
      return came_true || stetro_dds::Clock::steady_now() > end;
    });
    return came_true;
  }

  void roll_forward()
  {
    Command message;
    message.vx(0.1);
    send(message, test::command::KIND_TWIST);
  }

  void send(Command message, std::uint8_t kind)
  {
    message.header().stamp(stetro_dds::stamp_of(observer_.clock().now()));
    message.sequence_number(++sequence_);
    message.issuer("supervisor");
    message.issuer_instance(7);
    message.valid_for().nanosec(150'000'000);
    message.kind(kind);
    command_->publish(message);
  }

  FakeRobot * robot_ = nullptr;
};

TEST_F(TimedRunTest, TellsWhatItSensesOnTheComputersClock)
{
  EXPECT_TRUE(run_until([this] { return received_["contacts"] > 1 && received_["ranges"] > 3; }));
  EXPECT_EQ(received_["/clock"], 0) << "a real robot makes nobody's time";
  EXPECT_EQ(received_["ground_truth"], 0);
  EXPECT_EQ(driver_->world(), nullptr);
  EXPECT_THROW(driver_->step(), std::logic_error);
}

TEST_F(TimedRunTest, CarriesOutACommandAndHoldsWhenItExpires)
{
  roll_forward();
  bool rolled = false;
  EXPECT_TRUE(run_until([&] {
    rolled = rolled || robot_->vx_m_s == 0.1;
    return rolled && robot_->vx_m_s == 0.0 && answers_.size() > 1;
  }));
  ASSERT_EQ(answers_.size(), 2u);
  EXPECT_EQ(answers_[0].outcome(), status::OUTCOME_ACCEPTED);
  EXPECT_EQ(answers_[0].driver_state(), status::DRIVER_ACTIVE);
  EXPECT_EQ(answers_[1].outcome(), status::OUTCOME_EXPIRED);
}

TEST_F(TimedRunTest, SaysWhenTheHardwareGivesUp)
{
  robot_->fault = IoFault{IoFaultKind::kSilent, "wheel: does not answer"};
  roll_forward();
  EXPECT_TRUE(run_until([this] { return answers_.size() > 1; }));
  EXPECT_EQ(answers_[1].outcome(), status::OUTCOME_REFUSED);
  EXPECT_EQ(answers_[1].reason(), status::REASON_FAULT);
}

TEST_F(TimedRunTest, TakesAndGivesPowerWhenAPersonResetsAFault)
{
  robot_->broken = true;
  std::size_t asked = 0;
  EXPECT_TRUE(run_until([&] {
    if (received_["ranges"] > 0 && asked == answers_.size() && asked < 2) {
      send({}, ++asked == 1 ? test::command::KIND_STOP : test::command::KIND_HOLD);
    }
    return !robot_->broken;
  }));
  EXPECT_EQ(robot_->activations, 2);
  ASSERT_GE(answers_.size(), 1u);
  EXPECT_EQ(answers_[0].reason(), status::REASON_FAULT) << "nothing acts meanwhile";
}

TEST_F(TimedRunTest, MakesARobotSafeWhoseLoopIsSilent)
{
  std::atomic<bool> stuck{true};
  robot_->on_read = [&] {
    while (stuck) {
    }
  };
  const Time begin = stetro_dds::Clock::steady_now();
  EXPECT_TRUE(run_until([&] {
    stuck = stuck && robot_->safes == 0 && stetro_dds::Clock::steady_now() - begin < seconds{5};
    return robot_->activations > 1;
  }))
    << "powered again, for the loop is back";
  EXPECT_GE(robot_->safes, 1);
  EXPECT_LT(stetro_dds::Clock::steady_now() - begin, seconds{2});
}

TEST_F(TimedRunTest, EndsWhenTheLoopDoes)
{
  robot_->on_read = [] { throw std::runtime_error("a driver with a flaw"); };
  EXPECT_THROW(run_until([] { return false; }), HardwareError);
  EXPECT_GE(robot_->safes, 1);
}

TEST_F(TimedRunTest, StandsWhenItIsToldToStop)
{
  roll_forward();
  EXPECT_TRUE(run_until([this] { return robot_->vx_m_s == 0.1; }));
  EXPECT_GE(robot_->safes, 1);
  EXPECT_EQ(driver_->node().lifecycle().state(), stetro_dds::LifecycleState::kFinalized);
}

}  // namespace
}  // namespace stetro_driver
