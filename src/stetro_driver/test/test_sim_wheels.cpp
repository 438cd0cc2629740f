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

#include "sim/sim_wheels.hpp"

namespace stetro_driver::sim
{
namespace
{

constexpr double kTick = 0.01;

/// Rolls forward for a time and adds up what the body did.
double rolled_m(SimWheels & wheels, double speed_m_s, int ticks)
{
  double sum_m = 0.0;
  for (int i = 0; i < ticks; ++i) {
    sum_m += wheels.roll({speed_m_s, 0.0, 0.0}, kTick).x_m;
  }
  return sum_m;
}

TEST(SimWheels, PerfectWheelsDoWhatTheyAreTold)
{
  SimWheels wheels{no_errors(), 1};
  EXPECT_NEAR(rolled_m(wheels, 0.1, 100), 0.1, 1e-12);
  EXPECT_NEAR(wheels.odometry(Time{5}).x_m, 0.1, 1e-12);
  EXPECT_EQ(wheels.odometry(Time{5}).stamp, Time{5});
}

TEST(SimWheels, ASlipMovesTheBodyButNotOdometry)
{
  SimWheels wheels{no_errors(), 1};
  wheels.slip(-0.02);
  EXPECT_NEAR(rolled_m(wheels, 0.1, 100), 0.08, 1e-12);
  EXPECT_NEAR(wheels.odometry(Time{0}).x_m, 0.1, 1e-12);
}

TEST(SimWheels, ASlipWaitsForMotion)
{
  SimWheels wheels{no_errors(), 1};
  wheels.slip(0.01);
  EXPECT_EQ(wheels.roll({}, kTick).x_m, 0.0);
  EXPECT_NEAR(rolled_m(wheels, 0.05, 100), 0.06, 1e-12);
}

TEST(SimWheels, OdometryHasItsScale)
{
  SimErrors errors = no_errors();
  errors.odometry_scale_std = 0.02;
  double squares = 0.0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SimWheels wheels{errors, seed};
    const double body_m = rolled_m(wheels, 0.1, 10);
    const double ratio = wheels.odometry(Time{0}).x_m / body_m;
    EXPECT_NEAR(ratio, 1.0 + wheels.scale(), 1e-9);
    squares += wheels.scale() * wheels.scale();
  }
  EXPECT_NEAR(std::sqrt(squares / 500.0), 0.02, 0.002);
}

// 1 slip in 20 s of motion, 5 to 20 mm either way.
TEST(SimWheels, SlipsAsOftenAsTheErrorsSay)
{
  SimErrors errors = no_errors();
  errors.slip_rate_hz = 0.05;
  double longest_m = 0.0;
  int slips = 0;
  SimWheels wheels{errors, 3};
  bool slipping = false;
  for (int i = 0; i < 400000; ++i) {  // 4000 s: 200 slips
    const double extra_m = wheels.roll({0.1, 0.0, 0.0}, kTick).x_m - 0.001;
    const bool now = std::abs(extra_m) > 1e-9;
    slips += now && !slipping ? 1 : 0;
    slipping = now;
    longest_m = std::max(longest_m, std::abs(extra_m));
  }
  EXPECT_NEAR(slips, 200, 45);
  EXPECT_LE(longest_m, 0.001 + 1e-12) << "10 cm/s at most: no jump";
}

TEST(SimWheels, TheHeadingWandersOnlyWhileMoving)
{
  SimErrors errors = no_errors();
  errors.heading_disturbance_rms_rad_s = SimErrors{}.heading_disturbance_rms_rad_s;
  SimWheels wheels{errors, 5};
  double squares = 0.0;
  constexpr int kTicks = 200000;
  for (int i = 0; i < kTicks; ++i) {
    EXPECT_EQ(wheels.roll({}, kTick).yaw_rad, 0.0);
    const double rate_rad_s = wheels.roll({0.0, 0.1, 0.0}, kTick).yaw_rad / kTick;
    squares += rate_rad_s * rate_rad_s;
  }
  EXPECT_NEAR(std::sqrt(squares / kTicks), 0.0087266, 0.0008);
  EXPECT_EQ(wheels.odometry(Time{0}).yaw_rad, 0.0) << "the wheels do not feel it";
}

TEST(SimWheels, CountsTheWholeWay)
{
  SimWheels wheels{no_errors(), 1};
  for (const double vx_m_s : {0.1, -0.1}) {
    for (int tick = 0; tick < 100; ++tick) {
      static_cast<void>(wheels.roll({vx_m_s, 0.0, 0.0}, 0.01));
    }
  }
  for (const double wz_rad_s : {0.2, -0.2}) {
    for (int tick = 0; tick < 100; ++tick) {
      static_cast<void>(wheels.roll({0.0, 0.0, wz_rad_s}, 0.01));
    }
  }
  const OdometryReading odometry = wheels.odometry(Time{1});
  EXPECT_NEAR(odometry.x_m, 0.0, 1e-12);
  EXPECT_NEAR(odometry.rolled_m, 0.2, 1e-12);
  EXPECT_NEAR(odometry.turned_rad, 0.4, 1e-12);
}

}  // namespace
}  // namespace stetro_driver::sim
