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
#include <string>

#include "linux/servo/herkulex_servo.hpp"
#include "servo_line.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using emulator::EmulatedServo;
using emulator::HerkulexEmulator;
using namespace std::chrono_literals;

constexpr std::uint8_t kId = 4;

struct Wired
{
  explicit Wired(const std::string & name)
  : line(test::fast_line(name)), emulator(line, {kId}, clock), bus(test::bus_config(line), clock)
  {
    bus.open();
  }

  template <class Act>
  auto with(Act && act)
  {
    return emulator.with(kId, act);
  }

  DeviceClock clock;
  emulator::HerkulexLine line;
  HerkulexEmulator emulator;
  HerkulexBus bus;
  HerkulexServo servo{"lift front", kId, {ServoMode::kPosition, 0x00, 0, false}};
};

TEST(HerkulexServo, SetsUpPoliciesModeAndTorque)
{
  Wired w{"setup"};
  EXPECT_FALSE(w.servo.ready());
  ASSERT_FALSE(w.servo.set_up(w.bus, Torque::kBrake));
  EXPECT_TRUE(w.servo.ready());
  EXPECT_EQ(w.with([](EmulatedServo & s) { return s.ram(ram::kAckPolicy); }), 1);
  EXPECT_EQ(w.with([](EmulatedServo & s) { return s.ram(ram::kTorquePolicy); }), 0);
  EXPECT_EQ(w.with([](EmulatedServo & s) { return s.ram(ram::kAccelerationRatio); }), 0);
  EXPECT_EQ(w.with([](EmulatedServo & s) { return s.drive().torque; }), Torque::kBrake);
  EXPECT_EQ(w.servo.health().counts().good, 1U);
}

TEST(HerkulexServo, SaysWhatItMeasures)
{
  Wired w{"state"};
  ASSERT_FALSE(w.servo.set_up(w.bus, Torque::kBrake));
  w.with([](EmulatedServo & s) {
    s.set_measured(10.075 * kRadPerDegree, 1.0154);  // 31 counts; two of 29.09 degrees a second
    s.set_pwm(-0.5);
    s.set_voltage(7.4);
    s.set_temperature(0x60);
  });
  for (int i = 0; i < 2; ++i) {  // either of the two requests
    ASSERT_FALSE(w.servo.refresh(w.bus));
    const ServoState & s = w.servo.state();
    EXPECT_NEAR(s.position_rad, 10.075 * kRadPerDegree, 1e-9);
    EXPECT_FALSE(s.in_gap);
    EXPECT_NEAR(s.speed_rad_s, 2 * 29.09 * kRadPerDegree, 1e-9);
    EXPECT_NEAR(s.pwm, -0.5, 0.001);
    EXPECT_NEAR(s.voltage_v, 7.4, 0.04);
    EXPECT_EQ(s.temperature_raw, 0x60);
  }
  w.with([](EmulatedServo & s) { s.set_measured(3.1, 0.0); });
  ASSERT_FALSE(w.servo.refresh(w.bus));
  EXPECT_TRUE(w.servo.state().in_gap);
}

TEST(HerkulexServo, IsNotReadyWithoutAnswers)
{
  Wired w{"absent"};
  w.emulator.set_faults({{kId}, Time{0}, 0.0});
  const auto fault = w.servo.set_up(w.bus, Torque::kBrake);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, IoFaultKind::kSilent);
  EXPECT_EQ(fault->detail, "lift front (servo 4): no answer");
  EXPECT_FALSE(w.servo.may_set_up(w.clock.now())) << "it is left alone for a while";
  EXPECT_TRUE(w.servo.may_set_up(w.clock.now() + 200ms));
}

// Whatever is asked to set up is asked again: one lost reply does not keep a robot from starting.
TEST(HerkulexServo, SetsUpOverALineThatLosesReplies)
{
  Wired w{"lossy"};
  w.emulator.set_faults({{}, Time{0}, 0.05});
  for (int i = 0; i < 20; ++i) {
    const auto fault = w.servo.set_up(w.bus, Torque::kBrake);
    ASSERT_FALSE(fault) << i << ": " << fault->detail;
  }
}

TEST(HerkulexServo, TakesNoReplyThatComesOneRequestLate)
{
  Wired w{"late"};
  ASSERT_FALSE(w.servo.set_up(w.bus, Torque::kBrake));
  w.emulator.set_faults({{}, 150ms, 0.0});  // its patience is 100 ms
  for (int i = 0; i < 4; ++i) {
    static_cast<void>(w.servo.refresh(w.bus));
    EXPECT_FALSE(w.servo.answered()) << "request " << i;
  }
}

TEST(HerkulexServo, NamesALatchedErrorUntilItIsCleared)
{
  Wired w{"latched"};
  ASSERT_FALSE(w.servo.set_up(w.bus, Torque::kOn));
  w.with([](EmulatedServo & s) { s.trip(kOverloadError | kTemperatureError); });
  const auto fault = w.servo.refresh(w.bus);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->detail, "lift front (servo 4): latched error: temperature, overload");
  EXPECT_TRUE(w.servo.ready()) << "it answers, and stays as it was set up";
  ASSERT_FALSE(w.servo.clear_errors(w.bus));
  EXPECT_FALSE(w.servo.refresh(w.bus));
}

TEST(HerkulexServo, MentionsButForgivesAPacketItDidNotUnderstand)
{
  Wired w{"garbage"};
  ASSERT_FALSE(w.servo.set_up(w.bus, Torque::kOn));
  w.with([](EmulatedServo & s) { s.hear_garbage(); });
  EXPECT_FALSE(w.servo.refresh(w.bus));
  EXPECT_EQ(describe_errors(w.servo.state().errors), "invalid packet");
}

}  // namespace
}  // namespace stetro_driver::linux_io
