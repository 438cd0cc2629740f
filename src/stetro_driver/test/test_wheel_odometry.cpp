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
#include <cmath>

#include "linux/motion/wheel_odometry.hpp"
#include "linux/servo/herkulex_registers.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using namespace std::chrono_literals;

constexpr double kTurn = 6.28318530717958647692;
constexpr double kHalfPi = kTurn / 4.0;
constexpr Time kPeriod = 20ms;
constexpr double kPeriodS = 0.02;

// What a servo measures of a shaft that has turned by so much.
struct Measured
{
  double position_rad;
  bool in_gap;
};

Measured measure(double shaft_rad)
{
  const int count = position_count(std::remainder(shaft_rad, kTurn));
  const bool in_gap = count < kLowestCount || count > kHighestCount;
  return {kRadPerCount * (count - kCentreCount), in_gap};
}

TEST(TurningAngle, CountsTurnsAcrossTheGapBothWays)
{
  for (const double speed : {6.0, -6.0, 0.8, -0.8}) {
    TurningAngle angle;
    double shaft = 0.3;
    Time now = 1s;
    const double start = measure(shaft).position_rad;
    double worst = 0.0;
    while (std::abs(shaft) < 4.0 * kTurn) {
      const Measured seen = measure(shaft);
      angle.measure(now, seen.position_rad, seen.in_gap, 0.9 * speed);  // told, and not quite done
      worst = std::max(worst, seen.in_gap ? 0.0 : std::abs(angle.angle_rad() - shaft));
      shaft += speed * kPeriodS;
      now += kPeriod;
    }
    EXPECT_LT(worst, kRadPerCount) << "at " << speed << " rad/s from " << start;
  }
}

TEST(TurningAngle, StaysInTheGapWhenItStopsThere)
{
  TurningAngle angle;
  double shaft = 2.5;
  Time now = 1s;
  const auto next = [&](double speed) {
    shaft += speed * kPeriodS;
    now += kPeriod;
    const Measured seen = measure(shaft);
    angle.measure(now, seen.position_rad, seen.in_gap, speed);
    return seen.in_gap;
  };
  while (!next(3.0)) {
  }
  for (int i = 0; i < 100; ++i) {
    next(0.0);
  }
  EXPECT_NEAR(angle.angle_rad(), shaft, 0.1) << "the gap is 0.72 rad wide";
  while (next(-3.0)) {
  }
  EXPECT_NEAR(angle.angle_rad(), shaft, kRadPerCount);
}

TEST(TurningAngle, SaysItsSpeedOverATenthOfASecond)
{
  TurningAngle angle;
  EXPECT_EQ(angle.speed_rad_s(), 0.0);
  for (int i = 0; i <= 50; ++i) {
    angle.measure(i * kPeriod, 2.0 * i * kPeriodS, false, 2.0);
  }
  EXPECT_NEAR(angle.speed_rad_s(), 2.0, 1e-9);
}

// Wheels at (+-0.2, 0) of 50 mm.
WheelsConfig two_wheels()
{
  WheelsConfig config;
  config.diameter_m = 0.05;
  config.wheels = {{{1, 0.2, 0.0, false}, {}, {2, -0.2, 0.0, true}, {}}};
  return config;
}

// Turns the wheels steadily for a second.
OdometryReading roll(double front_rad_s, double rear_rad_s, double steering_rad)
{
  WheelOdometry odometry{two_wheels()};
  for (int i = 0; i <= 50; ++i) {
    const Time now = 1s + i * kPeriod;
    std::array<WheelReading, kWheels> wheels{};
    wheels[0] = {now, front_rad_s * i * kPeriodS, false, front_rad_s};
    wheels[2] = {now, rear_rad_s * i * kPeriodS, false, rear_rad_s};
    odometry.update(wheels, steering_rad);
  }
  return odometry.reading();
}

TEST(WheelOdometry, RollsAlongX)
{
  const OdometryReading o = roll(2.0, -2.0, 0.0);  // 2 rad/s x 25 mm, the rear servo is reversed
  EXPECT_NEAR(o.x_m, 0.05, 1e-9);
  EXPECT_NEAR(o.y_m, 0.0, 1e-9);
  EXPECT_NEAR(o.vx_m_s, 0.05, 1e-9);
  EXPECT_NEAR(o.rolled_m, 0.05, 1e-9);
  EXPECT_EQ(o.stamp, Time{2s});
}

// A filter that uses the twist alone must not fall behind when the robot starts and stops.
TEST(WheelOdometry, ItsTwistAddsUpToItsPose)
{
  WheelOdometry odometry{two_wheels()};
  double shaft = 0.0;
  double added_m = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const double speed = i > 20 && i <= 70 ? 6.0 : 0.0;  // starts and stops at once
    shaft += speed * kPeriodS;
    const Time now = 1s + i * kPeriod;
    const Measured front = measure(shaft);
    const Measured rear = measure(-shaft);
    std::array<WheelReading, kWheels> wheels{};
    wheels[0] = {now, front.position_rad, front.in_gap, speed};
    wheels[2] = {now, rear.position_rad, rear.in_gap, -speed};
    odometry.update(wheels, 0.0);
    added_m += odometry.reading().vx_m_s * kPeriodS;
    EXPECT_NEAR(added_m, odometry.reading().x_m, 1e-9) << "after " << i << " periods";
    EXPECT_NEAR(added_m, 0.025 * shaft, 0.001) << "after " << i << " periods";
  }
}

TEST(WheelOdometry, TurnsOnTheSpotWithTheWheelsAcross)
{
  const OdometryReading o = roll(2.0, 2.0, kHalfPi);  // +-50 mm/s at +-0.2 m
  EXPECT_NEAR(o.yaw_rad, 0.25, 1e-9);
  EXPECT_NEAR(o.wz_rad_s, 0.25, 1e-9);
  EXPECT_NEAR(o.turned_rad, 0.25, 1e-9);
  EXPECT_NEAR(std::hypot(o.x_m, o.y_m), 0.0, 1e-9);
}

TEST(WheelOdometry, TakesNoMotionFromWhereTheWheelsStoodAtTheStart)
{
  WheelOdometry odometry{two_wheels()};
  std::array<WheelReading, kWheels> wheels{};
  wheels[0] = {1s, 1.5, false, 0.0};
  wheels[2] = {1s, -0.7, false, 0.0};
  odometry.update(wheels, 0.0);
  EXPECT_EQ(odometry.reading().x_m, 0.0);
}

}  // namespace
}  // namespace stetro_driver::linux_io
