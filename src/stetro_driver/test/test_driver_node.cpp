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
#include <string>

#include "driver_fixture.hpp"

namespace stetro_driver
{
namespace
{

namespace command = stetro_msgs::msg::Command_Constants;
namespace status = stetro_msgs::msg::CommandStatus_Constants;
using std::chrono::milliseconds;
using std::chrono::seconds;
using stetro_msgs::msg::Command;
using stetro_msgs::msg::CommandStatus;
using test::quiet;
using DriverNodeTest = test::DriverFixture;

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

TEST_F(DriverNodeTest, ScansInABuildingWithDrawnFloors)
{
  const auto site = stetro_site::load_site(SITES "two_floors.yaml");
  launch(DriverSetup{quiet(), site, "lower", stetro_site::Robot{}});
  received_.clear();
  step(100);
  EXPECT_NEAR(received_["scan"], 10, 1);
}

TEST_F(DriverNodeTest, HasNoScanOnStairsAlone)
{
  launch(quiet());
  step(50);
  EXPECT_EQ(received_["scan"], 0);
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
  EXPECT_NEAR(driver_->world()->truth().block_heights_m[0], 0.18, 1e-9);
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
  wrong = roll();
  wrong.issuer(std::string(64, 's'));
  EXPECT_EQ(ask(wrong).reason(), status::REASON_BAD_ISSUER);
  const auto commands = counts("/stetro/command");
  EXPECT_EQ(commands.refused, 7u);
  ASSERT_EQ(commands.refused_by_reason.count("not_finite"), 1u);
  EXPECT_EQ(commands.refused_by_reason.at("not_finite"), 1u);
  EXPECT_EQ(commands.refused_by_reason.count("bad_issuer"), 1u);
}

TEST_F(DriverNodeTest, RefusesPosesThatNoLocalizerCanHaveMade)
{
  launch(quiet());
  geometry_msgs::msg::PoseWithCovarianceStamped pose;
  for (const int sec : {0, 5000}) {
    pose.header().stamp().sec(sec);
    pose_->publish(pose);
    executor_.drain();
  }
  EXPECT_EQ(counts("/stetro/pose").refused, 2u);
  pose.header().stamp().sec(1000);
  pose_->publish(pose);
  executor_.drain();
  EXPECT_EQ(counts("/stetro/pose").refused, 2u);
}

TEST_F(DriverNodeTest, WaitsOnlyForASupervisorThatItObeys)
{
  DriverParams params = quiet();
  params.sim.speed = 50.0;
  launch(params);
  Command refused = roll();
  refused.vx(99.0);
  EXPECT_EQ(ask(refused).reason(), status::REASON_OUT_OF_BOUNDS);
  const Time begin = stetro_dds::Clock::steady_now();
  driver_->run(executor_, [&] { return driver_->world()->time() >= milliseconds{1'000'500}; });
  EXPECT_LT(stetro_dds::Clock::steady_now() - begin, milliseconds{200}) << "10 ms, and no patience";
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
  const Time from = driver_->world()->time();
  driver_->run(executor_, [&] { return driver_->world()->time() - from >= seconds{5}; });
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
  driver_->run(executor_, [&] { return driver_->world()->time() >= milliseconds{1'000'200}; });
  // 90 ms at speed 50, 200 ms of patience, then 110 ms at real time.
  EXPECT_GE(stetro_dds::Clock::steady_now() - begin, milliseconds{300});
}

}  // namespace
}  // namespace stetro_driver
