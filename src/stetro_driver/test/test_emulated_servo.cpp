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

#include <chrono>
#include <initializer_list>

#include "emulator/emulated_servo.hpp"

namespace stetro_driver::emulator
{
namespace
{

using linux_io::HerkulexCommand;
using linux_io::HerkulexPacket;
using linux_io::ServoMode;
using linux_io::Torque;
using namespace std::chrono_literals;
namespace ram = linux_io::ram;

constexpr std::uint8_t kId = 0xFD;
constexpr std::uint8_t kPlaytime = 100;  // 1.12 s

HerkulexPacket packet(HerkulexCommand command, std::initializer_list<std::uint8_t> payload)
{
  HerkulexPacket made{kId, command};
  made.append(payload);
  return made;
}

void write(EmulatedServo & servo, std::uint8_t address, std::uint8_t value)
{
  EXPECT_FALSE(servo.hear(packet(HerkulexCommand::kRamWrite, {address, 1, value}), 0s));
}

HerkulexPacket jog(int word, std::uint8_t set)
{
  return packet(
    HerkulexCommand::kIJog, {static_cast<std::uint8_t>(word & 0xFF),
                             static_cast<std::uint8_t>(word >> 8), set, kId, kPlaytime});
}

TEST(EmulatedServo, AnswersTheExampleOfTheManual)
{
  EmulatedServo servo{kId};
  write(servo, ram::kTorqueControl, 0x60);
  write(servo, ram::kLed, 1);
  const auto reply = servo.hear(packet(HerkulexCommand::kRamRead, {ram::kLed, 1}), 0s);
  ASSERT_TRUE(reply);
  HerkulexPacket expected{kId, 0x44};
  expected.append({0x35, 1, 1, 0, 0x42});  // green, no error, motor on and in position
  EXPECT_EQ(*reply, expected);
}

TEST(EmulatedServo, AcknowledgesReadsOnlyUntilToldOtherwise)
{
  EmulatedServo servo{kId};
  EXPECT_FALSE(servo.hear(jog(512, 0), 0s));
  EXPECT_TRUE(servo.hear(packet(HerkulexCommand::kStat, {}), 0s));
  const auto told = servo.hear(packet(HerkulexCommand::kRamWrite, {ram::kAckPolicy, 1, 2}), 0s);
  EXPECT_TRUE(told) << "the new policy holds for this one";
  EXPECT_TRUE(servo.hear(jog(512, 0), 0s));
}

TEST(EmulatedServo, FollowsATrajectoryInItsPlaytime)
{
  EmulatedServo servo{kId};
  write(servo, ram::kAccelerationRatio, 25);
  write(servo, ram::kTorqueControl, 0x60);
  static_cast<void>(servo.hear(jog(512 + 200, 0), 1s));  // 65 degrees: 1.1345 rad
  servo.advance(1s + 280ms);
  EXPECT_NEAR(servo.drive().goal_rad, 1.1345 / 6, 1e-3) << "a quarter at 4/3, from standing";
  servo.advance(1s + 560ms);
  EXPECT_NEAR(servo.drive().goal_rad, 1.1345 / 2, 1e-3) << "half the time, half the way";
  servo.advance(1s + 1120ms);
  EXPECT_NEAR(servo.drive().goal_rad, 1.1345, 1e-3);
}

TEST(EmulatedServo, JogsOnlyWithTorqueAndChangesItsModeOnlyWithout)
{
  EmulatedServo servo{kId};
  static_cast<void>(servo.hear(jog(700, 0), 1s));
  servo.advance(5s);
  EXPECT_NEAR(servo.position_rad(), 0.0, 1e-9);
  write(servo, ram::kTorqueControl, 0x60);
  static_cast<void>(servo.hear(jog(300, linux_io::kJogVelocity), 5s));
  EXPECT_EQ(servo.drive().mode, ServoMode::kPosition);
  write(servo, ram::kTorqueControl, 0x00);
  static_cast<void>(servo.hear(jog(0, linux_io::kJogVelocity), 5s));
  EXPECT_EQ(servo.drive().mode, ServoMode::kVelocity);
  write(servo, ram::kTorqueControl, 0x60);
  static_cast<void>(servo.hear(jog(0x4000 | 1023, linux_io::kJogVelocity), 5s));
  EXPECT_EQ(servo.drive().pwm, -1.0);
}

TEST(EmulatedServo, LetsGoOnErrorsOfItsPolicyAndRefusesTorqueUntilTheyAreCleared)
{
  EmulatedServo servo{kId};
  write(servo, ram::kTorqueControl, 0x60);
  servo.trip(linux_io::kPacketError);
  EXPECT_EQ(servo.drive().torque, Torque::kOn) << "not in the factory's policy";
  servo.trip(linux_io::kOverloadError);
  EXPECT_EQ(servo.drive().torque, Torque::kFree);
  write(servo, ram::kTorqueControl, 0x60);
  EXPECT_EQ(servo.drive().torque, Torque::kFree);
  static_cast<void>(servo.hear(packet(HerkulexCommand::kRamWrite, {48, 2, 0, 0}), 0s));
  EXPECT_EQ(servo.drive().torque, Torque::kFree) << "clearing gives no torque";
  write(servo, ram::kTorqueControl, 0x60);
  EXPECT_EQ(servo.drive().torque, Torque::kOn);
}

TEST(EmulatedServo, SetsBitsAboveThePositionAndSticksAtTheGap)
{
  EmulatedServo servo{kId};
  const auto word = [&](double rad) {
    servo.set_measured(rad, 0.0);
    return servo.ram(ram::kPosition) | servo.ram(ram::kPosition + 1) << 8;
  };
  EXPECT_EQ(word(0.1764), 0x6000 | 543);  // 10.1 degrees
  EXPECT_EQ(word(3.1), 0x6000 | 1023) << "177.6 degrees cannot be measured";
}

TEST(EmulatedServo, ForgetsItsRamWithoutPowerAndIsDeafWhileItReboots)
{
  EmulatedServo servo{kId};
  write(servo, ram::kTorquePolicy, 0);
  write(servo, ram::kTorqueControl, 0x60);
  static_cast<void>(servo.hear(packet(HerkulexCommand::kReboot, {}), 1s));
  EXPECT_EQ(servo.ram(ram::kTorquePolicy), 0x35);
  EXPECT_EQ(servo.drive().torque, Torque::kFree);
  EXPECT_FALSE(servo.hear(packet(HerkulexCommand::kStat, {}), 1900ms));
  EXPECT_TRUE(servo.hear(packet(HerkulexCommand::kStat, {}), 2s));
}

TEST(EmulatedServo, SaysWhatItDidNotUnderstand)
{
  EmulatedServo servo{kId};
  static_cast<void>(servo.hear(HerkulexPacket{kId, std::uint8_t{0x2A}}, 0s));
  EXPECT_EQ(servo.ram(ram::kStatusError), linux_io::kPacketError);
  EXPECT_NE(servo.ram(ram::kStatusDetail) & linux_io::kUnknownCommandDetail, 0);
  EXPECT_FALSE(servo.hear(packet(HerkulexCommand::kRamRead, {70, 10}), 0s));
  EXPECT_NE(servo.ram(ram::kStatusDetail) & linux_io::kRegisterRangeDetail, 0);
}

}  // namespace
}  // namespace stetro_driver::emulator
