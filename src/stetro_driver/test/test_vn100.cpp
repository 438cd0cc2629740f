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

#include <cmath>
#include <random>
#include <vector>

#include "vn100_bench.hpp"

namespace stetro_driver
{
namespace
{

using emulator::ImuMotion;
using emulator::Vn100Emulator;
using linux_io::Axes;
using linux_io::Vn100;

constexpr double kDegree = 3.14159265358979323846 / 180.0;

ImuMotion turning_left_with_its_nose_up()
{
  ImuMotion motion;
  motion.base_in_world = linux_io::from_euler(0.0, -20 * kDegree, 100 * kDegree);
  motion.rate_rad_s = {0.0, 0.0, 0.25};
  motion.acceleration_m_s2 = {9.8 * std::sin(20 * kDegree), 0.0, 9.8 * std::cos(20 * kDegree)};
  return motion;
}

class Vn100Outputs : public Vn100Bench, public testing::WithParamInterface<const char *>
{
};

TEST_P(Vn100Outputs, MeasuresInBaseLinkHoweverItIsMounted)
{
  config_.output = GetParam();
  config_.mounting_yaw_rad = options_.mounting_yaw_rad = 90 * kDegree;
  config_.mounting_roll_rad = options_.mounting_roll_rad = 10 * kDegree;
  Vn100Emulator emulator(options_, clock_);
  emulator.set_motion(turning_left_with_its_nose_up());
  Vn100 imu(config_, clock_);
  ASSERT_TRUE(eventually([&] { return !imu.fault(clock_.now()); }));
  const GyroReading reading = imu.reading(clock_.now());
  EXPECT_FALSE(reading.fault);
  ASSERT_TRUE(reading.attitude && reading.acceleration_m_s2);
  const Axes euler = linux_io::to_euler(reading.attitude->base_in_world);
  EXPECT_NEAR(euler[0], 0.0, 2e-5);
  EXPECT_NEAR(euler[1], -20 * kDegree, 2e-5) << "nose up";
  EXPECT_NEAR(euler[2], 100 * kDegree, 2e-5);
  EXPECT_NEAR(reading.rate_rad_s[2], 0.25, 2e-6) << "to the left";
  EXPECT_NEAR((*reading.acceleration_m_s2)[0], 9.8 * std::sin(20 * kDegree), 2e-3);
  EXPECT_NEAR((*reading.acceleration_m_s2)[2], 9.8 * std::cos(20 * kDegree), 2e-3);
  EXPECT_EQ(imu.statistics().identity.model, "VN-100T-CR");
  EXPECT_EQ(imu.statistics().identity.serial_number, "0100012345");
}

INSTANTIATE_TEST_SUITE_P(BinaryAndAscii, Vn100Outputs, testing::Values("binary", "ascii"));

// A change of the motion shows in the first measurement stamped after it, and in none before.
TEST_F(Vn100Bench, StampsSayWhenItWasMeasured)
{
  config_.rate_hz = 50;
  config_.silent_periods = 20;  // this is about stamps
  Vn100Emulator emulator(options_, clock_);
  Vn100 imu(config_, clock_);
  ASSERT_TRUE(eventually([&] { return !imu.fault(clock_.now()); }));
  ImuMotion motion;
  for (int round = 1; round <= 10; ++round) {
    motion.rate_rad_s[2] = 0.01 * round;
    const Time before = clock_.now();
    emulator.set_motion(motion);
    const Time after = clock_.now();
    GyroReading last = imu.reading(before);
    GyroReading first;
    ASSERT_TRUE(eventually([&] {
      last = first.stamp > last.stamp ? first : last;
      first = imu.reading(clock_.now());
      return first.rate_rad_s[2] > motion.rate_rad_s[2] - 0.01 + 1e-6;
    }));
    // Its rate is the mean of the old and the new one, so it says itself when the change was.
    const double share = (first.rate_rad_s[2] - motion.rate_rad_s[2] + 0.01) / 0.01;
    const Time began =
      first.stamp - seconds_to_time(share * time_to_seconds(first.stamp - last.stamp));
    EXPECT_GT(began, before - std::chrono::milliseconds{1});
    EXPECT_LT(began, after + std::chrono::milliseconds{15}) << "less than a period";
  }
}

TEST_F(Vn100Bench, SamplesAreAPeriodApartWhenTheyAreReadLate)
{
  config_.rate_hz = 100;
  config_.silent_periods = 50;
  Vn100Emulator emulator(options_, clock_);
  Vn100 imu(config_, clock_);
  std::vector<Time> stamps;
  ASSERT_TRUE(eventually([&] {
    const Time stamp = imu.reading(clock_.now()).stamp;
    if (stamp > Time{0} && (stamps.empty() || stamp != stamps.back())) {
      stamps.push_back(stamp);
    }
    return stamps.size() >= 60;
  }));
  for (std::size_t i = 30; i < stamps.size(); ++i) {
    const double periods = time_to_seconds(stamps[i] - stamps[i - 1]) / 0.01;
    EXPECT_GE(periods, 0.9) << i;
    EXPECT_NEAR(periods, std::round(periods), 0.1) << i << ", one that we missed is no matter";
  }
}

// Property: whatever the rhythms of world, sensor and loop, no angle is lost and none counts twice.
TEST_F(Vn100Bench, ReadingsAddUpToTheAngleTurned)
{
  config_.rate_hz = 100;
  config_.silent_periods = 50;  // this is about angles
  Vn100Emulator emulator(options_, clock_);
  Vn100 imu(config_, clock_);
  std::mt19937 random{20260520};
  std::uniform_real_distribution<double> rate_rad_s{-1.0, 1.0};
  ImuMotion motion;
  double true_rad = 0.0;
  double told_rad = 0.0;
  // It stands in the beginning, until the sensor's clock is known well, and in the end.
  ASSERT_TRUE(eventually([&] { return imu.statistics().counts.good > 50; }));
  GyroReading last = imu.reading(clock_.now());
  const auto look = [&] {
    const GyroReading reading = imu.reading(clock_.now());
    EXPECT_FALSE(reading.fault);
    told_rad += reading.rate_rad_s[2] * time_to_seconds(reading.stamp - last.stamp);
    last = reading;
  };
  Time since = clock_.now();
  Time looks_at = since;
  for (int tick = 0; tick < 300; ++tick) {  // of 7.3 ms, and a look each 13.7 ms
    const bool ends = tick == 299;
    motion.rate_rad_s[2] = ends ? 0.0 : rate_rad_s(random);
    emulator.set_motion(motion, since);
    const Time until = since + std::chrono::microseconds{7300};
    ASSERT_TRUE(eventually([&] { return clock_.now() >= until; }));
    true_rad += motion.rate_rad_s[2] * time_to_seconds(until - since);
    since = until;
    if (since >= looks_at) {
      look();
      looks_at += std::chrono::microseconds{13'700};
    }
  }
  const Time stood = clock_.now();
  ASSERT_TRUE(eventually([&] {
    look();
    return last.stamp > stood + std::chrono::milliseconds{30};
  }));
  EXPECT_NEAR(told_rad, true_rad, 0.003) << "1 rad/s for what a stamp may be off";
}

TEST_F(Vn100Bench, AnAcceleratedClockCarriesOverToPeriodsAndStamps)
{
  const linux_io::DeviceClock fast(std::chrono::seconds{1000}, 4.0);
  Vn100Emulator emulator(options_, fast);
  emulator.set_motion(turning_left_with_its_nose_up());
  Vn100 imu(config_, fast);
  const Time begin = imu.reading(fast.now()).stamp;
  const std::uint64_t good = imu.statistics().counts.good;
  ASSERT_TRUE(eventually([&] { return imu.statistics().counts.good >= good + 20; }));
  const Time end = imu.reading(fast.now()).stamp;
  EXPECT_NEAR(time_to_seconds(end - begin), 1.0, 0.25) << "20 measurements at 20 Hz";
}

TEST_F(Vn100Bench, WhatTheWireCannotCarryIsRefused)
{
  const auto refusal = [&] {
    try {
      const Vn100 imu(config_, clock_);
    } catch (const HardwareError & error) {
      return std::string(error.what());
    }
    return std::string();
  };
  config_.output = "ascii";
  config_.rate_hz = 100;
  EXPECT_NE(refusal().find("rate_hz"), std::string::npos) << "94 lines fill 115 200 baud";
  config_.rate_hz = 30;
  EXPECT_NE(refusal().find("1, 2, 4, 5, 10"), std::string::npos) << refusal();
  config_.output = "binary";
  EXPECT_NE(refusal().find("divides 800"), std::string::npos) << refusal();
  config_.rate_hz = 200;
  config_.serial.baud = 57'600;
  EXPECT_NE(refusal().find("at most 96"), std::string::npos) << refusal();
  config_.rate_hz = 80;
  EXPECT_NE(refusal().find(options_.link), std::string::npos) << "only the port is missing";
}

TEST(Vn100Config, EveryFieldAcceptsItsDefault)
{
  linux_io::Vn100Config config;
  const auto fields = stetro_config::fields_of(config);
  EXPECT_EQ(fields.size(), 15u);
  for (const auto & field : fields) {
    EXPECT_TRUE(field.accepts(field.get())) << field.name;
  }
  stetro_config::Faults faults;
  check(config, faults);
  EXPECT_TRUE(faults.empty()) << "and together they fit";
}

}  // namespace
}  // namespace stetro_driver
