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

#include <filesystem>
#include <string>

#include "driver_fixture.hpp"

namespace stetro_driver
{
namespace
{

namespace command = stetro_msgs::msg::Command_Constants;
namespace status = stetro_msgs::msg::CommandStatus_Constants;
using stetro_msgs::msg::CommandStatus;
using test::quiet;
using test::setup_of;
using EmergencyStop = test::DriverFixture;

TEST_F(EmergencyStop, AnEmergencyStopIsResetByAStopAndAHoldAfterItsRelease)
{
  DriverParams params = quiet();
  params.sim.faults = "estop@0.1-0.5";
  launch(params);
  ask(roll());
  step(20);
  const double stopped_m = x_m();
  EXPECT_EQ(ask(roll()).reason(), status::REASON_EMERGENCY_STOP);
  ask_to(command::KIND_STOP);
  ask_to(command::KIND_HOLD);
  EXPECT_EQ(ask(roll()).reason(), status::REASON_EMERGENCY_STOP) << "it is still pressed";
  step(100);
  ask_to(command::KIND_HOLD);
  ask_to(command::KIND_STOP);
  EXPECT_EQ(ask(roll()).reason(), status::REASON_EMERGENCY_STOP) << "released, and still latched";
  ask_to(command::KIND_STOP);
  ask_to(command::KIND_HOLD);
  step(10);
  EXPECT_EQ(x_m(), stopped_m) << "it needs a new command";
  EXPECT_EQ(ask(roll()).outcome(), status::OUTCOME_ACCEPTED);
  step(10);
  EXPECT_GT(x_m(), stopped_m);
}

TEST_F(EmergencyStop, ALatchedEmergencyStopOutlivesTheDriver)
{
  const std::string path = ::testing::TempDir() + "driver_node.snapshot";
  std::filesystem::remove(path);
  DriverParams params = quiet();
  params.sim.faults = "estop@0.1-0.5";
  params.sim.snapshot_file = path;
  {
    SimRobot before{
      shape_of(setup_of(params).flight()), shape_of(setup_of(params).robot), sim_options(params)};
    before.configure();
    for (int tick = 0; tick < 100; ++tick) {
      before.step();
    }
  }
  launch(params);
  step(50);  // longer than a driver stands that took a world over
  EXPECT_GT(received_["imu/data"], 0) << "sensors are read";
  const CommandStatus answer = ask(roll());
  EXPECT_EQ(answer.reason(), status::REASON_EMERGENCY_STOP);
  EXPECT_EQ(answer.driver_state(), status::DRIVER_INACTIVE);
  ask_to(command::KIND_STOP);
  ask_to(command::KIND_HOLD);
  EXPECT_EQ(ask(roll()).driver_state(), status::DRIVER_ACTIVE);
  step(10);
  EXPECT_GT(x_m(), -0.5);
  driver_.reset();
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace stetro_driver
