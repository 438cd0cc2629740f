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

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <string>

#include "device_bench.hpp"
#include "linux/motion/chassis.hpp"
#include "servo_line.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using emulator::EmulatedServo;
using emulator::HerkulexEmulator;
using emulator::HerkulexFaults;
using emulator::HerkulexLine;
using namespace std::chrono_literals;

constexpr double kHalfPi = 1.57079632679489661923;

// A chassis and its eight emulated servos: wheels 1 to 4, steering 5 and 6, lifts 7 and 8.
struct Bench
{
  explicit Bench(const std::string & name) : Bench(test::fast_line(name)) {}

  explicit Bench(const HerkulexLine & at) : line(at), servos(line, {1, 2, 3, 4, 5, 6, 7, 8}, clock)
  {
    config.bus = test::bus_config(line);
    config.command_timeout_s = 1.0;
    for (std::uint8_t i = 0; i < 2; ++i) {
      stand(static_cast<std::uint8_t>(5 + i), config.steering.joints[i].zero_rad);
      stand(static_cast<std::uint8_t>(7 + i), config.lifts.joints[i].zero_rad);
    }
    chassis.emplace(config, clock);
  }

  // Where a servo's shaft is at power-up; from there on it follows its motor.
  void stand(std::uint8_t id, double rad)
  {
    servos.with(id, [&](EmulatedServo & servo) {
      servo.set_measured(rad, 0.0);
      servo.power_cycle();
      servo.release();
    });
  }

  void start()
  {
    chassis->configure();
    chassis->activate();
  }

  // Repeats a command, as a control loop does, until something holds.
  bool until(
    const JointCommand & command, const std::function<bool(const ChassisReading &)> & holds)
  {
    return eventually([&] {
      static_cast<void>(chassis->command(command));
      return holds(chassis->reading());
    });
  }

  emulator::ServoDrive drive(std::uint8_t id)
  {
    return servos.with(id, [](const EmulatedServo & servo) { return servo.drive(); });
  }

  DeviceClock clock;
  emulator::HerkulexLine line;
  HerkulexEmulator servos;
  ChassisConfig config;
  std::optional<Chassis> chassis;
};

JointCommand twist(double vx_m_s)
{
  JointCommand command;
  command.kind = MotionKind::kTwist;
  command.vx_m_s = vx_m_s;
  return command;
}

JointCommand steer(double angle_rad)
{
  JointCommand command;
  command.kind = MotionKind::kSteer;
  command.steering_rad = angle_rad;
  return command;
}

JointCommand lift(MotionKind kind, int block)
{
  JointCommand command;
  command.kind = kind;
  command.block = block;
  return command;
}

TEST(Chassis, SetsUpEveryServoBrakedAndPowersThemWhenAsked)
{
  Bench bench{"power"};
  bench.chassis->configure();
  const auto policy = [](const EmulatedServo & s) { return s.ram(ram::kTorquePolicy); };
  for (std::uint8_t id = 1; id <= 8; ++id) {
    EXPECT_EQ(bench.drive(id).torque, Torque::kBrake) << int{id};
    EXPECT_EQ(bench.drive(id).mode, id <= 4 ? ServoMode::kVelocity : ServoMode::kPosition);
    EXPECT_EQ(bench.servos.with(id, policy), id <= 4 ? 0x35 : id <= 6 ? 0x24 : 0x00);
  }
  bench.chassis->activate();
  for (std::uint8_t id = 1; id <= 8; ++id) {
    EXPECT_EQ(bench.drive(id).torque, Torque::kOn) << int{id};
  }
  EXPECT_FALSE(bench.chassis->deactivate());
  for (std::uint8_t id = 1; id <= 8; ++id) {
    EXPECT_EQ(bench.drive(id).torque, Torque::kBrake) << int{id};
  }
}

TEST(Chassis, RollsForwardAndCountsIt)
{
  Bench bench{"roll"};
  bench.start();
  ASSERT_TRUE(
    bench.until(twist(0.1), [](const ChassisReading & r) { return r.odometry.x_m > 0.02; }));
  EXPECT_GT(bench.drive(1).pwm, 0.0);
  EXPECT_LT(bench.drive(2).pwm, 0.0) << "mounted the other way round";
  // Emulated shafts turn at 7.0 rad/s at full PWM, 24 mm of radius: told 0.1, near 0.1.
  EXPECT_NEAR(bench.chassis->reading().odometry.vx_m_s, 0.1, 0.03);
  EXPECT_NEAR(bench.chassis->reading().odometry.y_m, 0.0, 0.002);
  ASSERT_TRUE(bench.until({}, [&](const ChassisReading &) { return bench.drive(1).pwm == 0.0; }));
  // All shafts are still short of the gap at 2.8 rad, where odometry knows less.
  double turned = 0.0;
  for (std::uint8_t id = 1; id <= 4; ++id) {
    turned +=
      std::abs(bench.servos.with(id, [](EmulatedServo & s) { return s.position_rad(); })) / 4.0;
  }
  EXPECT_LT(turned, 2.7);
  EXPECT_TRUE(bench.until(
    {},
    [&](const ChassisReading & r) {
      return std::abs(r.odometry.rolled_m - 0.024 * turned) < 0.001;
    }))
    << bench.chassis->reading().odometry.rolled_m << " counted, " << 0.024 * turned << " turned";
}

TEST(Chassis, SteersAtItsSpeedAndSaysWhenItIsThere)
{
  Bench bench{"steer"};
  bench.start();
  const Time begin = bench.clock.now();
  ASSERT_TRUE(bench.until(
    steer(kHalfPi),
    [](const ChassisReading & r) {
      return !r.steering.moving && std::abs(r.steering.angle_rad - kHalfPi) < 0.02;
    }))
    << bench.chassis->reading().steering.angle_rad;
  const double took_s = time_to_seconds(bench.clock.now() - begin);
  EXPECT_GT(took_s, 0.9 * kHalfPi / 1.6);
}

TEST(Chassis, LiftsABlockByItsStrokeAndHoldsOnTheWay)
{
  Bench bench{"lift"};
  bench.start();
  ASSERT_TRUE(bench.until(lift(MotionKind::kLift, 1), [](const ChassisReading & r) {
    return r.blocks[0].height_m > 0.05 && r.blocks[0].moving;
  }));
  ASSERT_TRUE(bench.until({}, [](const ChassisReading & r) { return !r.blocks[0].moving; }));
  const double held_m = bench.chassis->reading().blocks[0].height_m;
  EXPECT_LT(held_m, 0.10);
  ASSERT_TRUE(bench.until(lift(MotionKind::kLift, 1), [](const ChassisReading & r) {
    return r.blocks[0].at_upper_lock && !r.blocks[0].moving;
  }));
  EXPECT_NEAR(bench.chassis->reading().blocks[0].height_m, 0.18, 0.002);
  EXPECT_FALSE(bench.chassis->reading().blocks[0].at_lower_lock);
}

TEST(Chassis, HoldsWhenNobodyCommandsItAnyMore)
{
  Bench bench{"expire"};
  bench.start();
  ASSERT_TRUE(
    bench.until(twist(0.1), [&](const ChassisReading &) { return bench.drive(1).pwm > 0; }));
  EXPECT_TRUE(eventually([&] { return bench.drive(1).pwm == 0.0; }));
}

TEST(Chassis, MadeSafeItHoldsUntilItIsActivatedAgain)
{
  Bench bench{"safe"};
  bench.start();
  ASSERT_TRUE(
    bench.until(twist(0.1), [&](const ChassisReading &) { return bench.drive(1).pwm > 0; }));
  bench.chassis->make_safe();
  bench.chassis->make_safe();
  ASSERT_TRUE(
    bench.until(twist(0.1), [&](const ChassisReading &) { return bench.drive(1).pwm == 0; }));
  const Time then = bench.chassis->reading().stamp + 200ms;
  bool stayed = true;
  ASSERT_TRUE(bench.until(twist(0.1), [&](const ChassisReading & r) {
    stayed = stayed && bench.drive(1).pwm == 0.0;
    return r.stamp > then;
  }));
  EXPECT_TRUE(stayed);
  bench.chassis->activate();
  EXPECT_TRUE(
    bench.until(twist(0.1), [&](const ChassisReading &) { return bench.drive(1).pwm > 0; }));
}

TEST(Chassis, RefusesATwistItsWheelsCannotTurn)
{
  Bench bench{"fast"};
  bench.start();
  const auto fault = bench.chassis->command(twist(0.3));  // 12.5 rad/s, of 7.1
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, IoFaultKind::kBadCommand);
}

bool rolling(Bench & bench) { return bench.drive(1).pwm > 0.0; }

TEST(Chassis, HoldsWhileOneServoIsSilentAndGoesOnWhenItIsBack)
{
  Bench bench{"silent"};
  bench.start();
  const OpenResources before;
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(bench.until(twist(0.1), [&](const ChassisReading &) { return rolling(bench); }));
    bench.servos.set_faults({{8}, Time{0}, 0.0});
    ASSERT_TRUE(bench.until(
      twist(0.1), [&](const ChassisReading & r) { return r.fault && !rolling(bench); }));
    const ChassisReading reading = bench.chassis->reading();
    EXPECT_EQ(reading.fault->kind, IoFaultKind::kSilent);
    EXPECT_EQ(reading.fault->detail, "lift rear (servo 8): no answer");
    EXPECT_TRUE(reading.blocks[2].fault);
    bench.servos.set_faults({});
  }
  ASSERT_TRUE(
    bench.until(twist(0.1), [&](const ChassisReading & r) { return !r.fault && rolling(bench); }));
  EXPECT_TRUE(OpenResources{} == before);
}

// A cable that is pulled takes the last word with it: on the robot a relay stops the wheels.
TEST(Chassis, LosesTheWheelsPowerWithTheCableAndNotTheLifts)
{
  HerkulexLine line = test::fast_line("cable");
  line.on_relay = {1, 2, 3, 4};
  line.relay_after = 1s;  // this computer may keep a thread waiting
  Bench bench{line};
  bench.start();
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(bench.until(twist(0.1), [&](const ChassisReading &) { return rolling(bench); }));
    bench.servos.unplug();
    ASSERT_TRUE(bench.until(twist(0.1), [&](const ChassisReading & r) {
      return r.fault && bench.drive(1).torque == Torque::kFree;
    }));
    EXPECT_EQ(bench.chassis->reading().fault->kind, IoFaultKind::kSilent);
    EXPECT_EQ(bench.drive(7).torque, Torque::kOn);
    bench.servos.plug();
  }
  ASSERT_TRUE(
    bench.until(twist(0.1), [&](const ChassisReading & r) { return !r.fault && rolling(bench); }));
  EXPECT_GE(bench.chassis->line_counts().reopens, 2U);
}

TEST(Chassis, NeedsAPersonAfterALatchedError)
{
  Bench bench{"latched"};
  bench.start();
  bench.servos.with(7, [](EmulatedServo & s) { s.trip(kTemperatureError); });
  ASSERT_TRUE(bench.until({}, [&](const ChassisReading & r) {
    return r.fault && bench.drive(7).torque == Torque::kBrake;
  }));
  EXPECT_EQ(
    bench.chassis->reading().fault->detail, "lift front (servo 7): latched error: temperature");
  bench.chassis->activate();
  EXPECT_TRUE(bench.until({}, [](const ChassisReading & r) { return !r.fault; }));
  EXPECT_EQ(bench.drive(7).torque, Torque::kOn);
}

TEST(Chassis, FeelsTheGroundUnderABlock)
{
  Bench bench{"ground"};
  bench.start();
  ASSERT_TRUE(bench.until(lift(MotionKind::kLift, 1), [](const ChassisReading & r) {
    return r.blocks[0].at_upper_lock;
  }));
  // A tread of 0.14 m: below that the servo does not get.
  const JointConfig & joint = bench.config.lifts.joints[0];
  const double tread_rad = servo_rad(joint, 0.14 / bench.config.lifts.m_per_rad);
  ASSERT_TRUE(bench.until(lift(MotionKind::kLower, 1), [&](const ChassisReading & r) {
    bench.servos.with(
      7, [&](EmulatedServo & s) { s.set_measured(std::max(s.drive().goal_rad, tread_rad), 0.0); });
    return r.blocks[0].at_lower_lock;
  }));
  EXPECT_NEAR(bench.chassis->reading().blocks[0].height_m, 0.14, 0.001);
}

TEST(Chassis, KnowsAfterARestartWhichBlocksStood)
{
  const TempDirectory directory;
  Bench bench{"restart"};
  bench.config.blocks_file = (directory.path() / "blocks").string();
  bench.chassis.emplace(bench.config, bench.clock);
  bench.start();
  ASSERT_TRUE(bench.until(lift(MotionKind::kLift, 1), [](const ChassisReading & r) {
    return r.blocks[0].at_upper_lock;
  }));
  bench.chassis.emplace(bench.config, bench.clock);
  bench.start();
  const auto blocks = bench.chassis->reading().blocks;
  EXPECT_TRUE(blocks[0].at_upper_lock);
  EXPECT_FALSE(blocks[0].at_lower_lock);
  EXPECT_TRUE(blocks[1].at_lower_lock && blocks[2].at_lower_lock);
}

TEST(Chassis, NamesEveryServoThatIsMissingAtTheStart)
{
  Bench bench{"missing"};
  bench.servos.set_faults({{2, 7}, Time{0}, 0.0});
  try {
    bench.chassis->configure();
    FAIL() << "two servos are missing";
  } catch (const HardwareError & error) {
    EXPECT_STREQ(
      error.what(),
      "wheel front right (servo 2): no answer; lift front (servo 7): no answer; accepted: every "
      "servo of the robot file on the line, powered");
  }
  EXPECT_THROW(bench.chassis->activate(), HardwareError);
  bench.servos.set_faults({});
  bench.chassis->configure();
  EXPECT_FALSE(bench.chassis->reading().fault);
}

TEST(Chassis, GivesDiagnosticsOfEveryServo)
{
  Bench bench{"diagnostics"};
  bench.start();
  const auto all = bench.chassis->diagnostics();
  ASSERT_EQ(all.size(), 8U);
  EXPECT_EQ(all[6].name, "lift front (servo 7)");
  EXPECT_NEAR(all[6].state.voltage_v, 7.4, 0.04);
  EXPECT_EQ(all[6].state.temperature_raw, 0x60);
  EXPECT_GT(all[6].counts.good, 0U);
  EXPECT_FALSE(all[6].faulty);
}

}  // namespace
}  // namespace stetro_driver::linux_io
