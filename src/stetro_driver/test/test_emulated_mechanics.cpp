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

#include <array>

#include "emulator/emulated_mechanics.hpp"
#include "linux/motion/steering.hpp"

namespace stetro_driver::emulator
{
namespace
{

using linux_io::ServoMode;
using linux_io::Torque;

constexpr double kTick = 0.01;

class EmulatedMechanicsTest : public ::testing::Test
{
protected:
  EmulatedMechanicsTest()
  {
    for (std::size_t i = 0; i < linux_io::kPair; ++i) {
      drives_.lifts[i] = {
        Torque::kOn, ServoMode::kPosition, linux_io::servo_rad(config_.lifts.joints[i], 0.0), 0.0};
      drives_.steering[i] = {
        Torque::kOn, ServoMode::kPosition, linux_io::servo_rad(config_.steering.joints[i], 0.0),
        0.0};
    }
    for (BlockReading & block : blocks_) {
      block.at_lower_lock = true;
    }
  }

  /// Tells a lift to be extended by so much.
  void extend(std::size_t lift, double extension_m)
  {
    drives_.lifts[lift].goal_rad =
      linux_io::servo_rad(config_.lifts.joints[lift], extension_m / config_.lifts.m_per_rad);
  }

  SimActuation follow() { return mechanics_.follow(drives_, blocks_, kTick); }

  linux_io::ChassisConfig config_{};
  EmulatedMechanics mechanics_{config_};
  ChassisDrives drives_{};
  std::array<BlockReading, kBlocks> blocks_{};
};

TEST_F(EmulatedMechanicsTest, StandsWhileNothingIsTold)
{
  const SimActuation moved = follow();
  EXPECT_EQ(moved.vx_m_s, 0.0);
  EXPECT_EQ(moved.lifted_m, (std::array<double, kBlocks>{}));
  EXPECT_NEAR(moved.steering_rad, 0.0, 1e-12);
}

TEST_F(EmulatedMechanicsTest, HalfPowerRollsAtHalfOfFullSpeed)
{
  for (std::size_t i = 0; i < linux_io::kWheels; ++i) {
    const double sense = config_.wheels.wheels[i].reversed ? -1.0 : 1.0;
    drives_.wheels[i] = {Torque::kOn, ServoMode::kVelocity, 0.0, 0.5 * sense};
  }
  EXPECT_NEAR(follow().vx_m_s, 0.5 * 7.1 * 0.024, 1e-12);
  for (ServoDrive & wheel : drives_.wheels) {
    wheel.torque = Torque::kFree;
  }
  EXPECT_EQ(follow().vx_m_s, 0.0) << "without torque no wheel turns";
}

TEST_F(EmulatedMechanicsTest, OneLiftMovesItsOwnBlock)
{
  extend(0, 0.001);
  EXPECT_NEAR(follow().lifted_m[0], 0.001, 1e-12);
  EXPECT_EQ(follow().lifted_m[1], 0.0);
  extend(0, 0.0);
  extend(1, 0.5);
  EXPECT_NEAR(follow().lifted_m[2], 7.1 * 0.045 * kTick, 1e-12) << "no faster than it can";
}

TEST_F(EmulatedMechanicsTest, BothLiftsTogetherMoveTheMiddleBlock)
{
  extend(0, -0.002);
  extend(1, -0.001);
  EXPECT_NEAR(follow().lifted_m[1], 0.0015, 1e-12);
  blocks_[1].at_lower_lock = false;
  extend(0, 0.001);
  extend(1, 0.0);
  EXPECT_NEAR(follow().lifted_m[1], -0.0005, 1e-12) << "in the air, also when one is ahead";
}

TEST_F(EmulatedMechanicsTest, StallsWhenTheMiddleBlockHasTouchedDown)
{
  extend(0, 0.003);
  extend(1, 0.003);
  EXPECT_EQ(follow().lifted_m, (std::array<double, kBlocks>{}));
}

TEST_F(EmulatedMechanicsTest, ABrakeKeepsAndAFreeShaftLetsGo)
{
  extend(0, -0.1);
  drives_.lifts[0].torque = Torque::kBrake;
  EXPECT_EQ(follow().lifted_m[0], 0.0);
  drives_.lifts[0].torque = Torque::kFree;
  EXPECT_LT(follow().lifted_m[0], 0.0) << "the block falls";
}

// Two free lifts once raised the block they sit in, by the weight of those beside it.
TEST_F(EmulatedMechanicsTest, FreeShaftsRaiseNothing)
{
  for (ServoDrive & lift : drives_.lifts) {
    lift.torque = Torque::kFree;
  }
  const SimActuation moved = follow();
  EXPECT_LT(moved.lifted_m[0], 0.0);
  EXPECT_EQ(moved.lifted_m[1], 0.0);
  EXPECT_LT(moved.lifted_m[2], 0.0);
}

TEST_F(EmulatedMechanicsTest, ShaftsSayWhatTheBodyDid)
{
  SensorFrame frame;
  frame.odometry.vx_m_s = 0.12;
  frame.blocks[0].height_m = 0.18;
  const ChassisShafts shafts = mechanics_.shafts_after(frame, kTick);
  EXPECT_NEAR(shafts.wheels[0].speed_rad_s, 5.0, 1e-12);  // 0.12 m/s at 24 mm
  EXPECT_NEAR(shafts.wheels[1].speed_rad_s, -5.0, 1e-12) << "it is mounted the other way";
  EXPECT_NEAR(shafts.lifts[0].position_rad, -1.6 + 4.0, 1e-12);  // 0.18 m at 0.045 m/rad
  EXPECT_NEAR(shafts.lifts[1].position_rad, 1.6, 1e-12);
}

}  // namespace
}  // namespace stetro_driver::emulator
