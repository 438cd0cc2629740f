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

#include "stetro_localizer/gyro_heading.hpp"

namespace stetro_localizer
{
namespace
{

using std::chrono::milliseconds;

constexpr Nanoseconds kStart = std::chrono::seconds(1000);
constexpr double kDeg = M_PI / 180.0;

Nanoseconds feed(GyroHeading & gyro, Nanoseconds from, int samples, double rate, bool standing)
{
  for (int i = 0; i < samples; ++i) {
    from += milliseconds(10);
    gyro.add({from, rate}, standing);
  }
  return from;
}

TEST(GyroHeading, IntegratesCounterClockwisePositive)
{
  GyroHeading gyro{GyroParams{}};
  gyro.add({kStart, 0.1}, false);
  feed(gyro, kStart, 100, 0.1, false);
  EXPECT_NEAR(gyro.angle_rad(), 0.1, 1e-9);  // 0.1 rad/s for 1 s
}

TEST(GyroHeading, LearnsItsBiasOnlyWhileStanding)
{
  GyroHeading moving{GyroParams{}};
  feed(moving, kStart, 500, 0.3 * kDeg, false);
  EXPECT_EQ(moving.bias().value, 0.0);
  GyroHeading gyro{GyroParams{}};
  Nanoseconds now = feed(gyro, kStart, 200, 0.3 * kDeg, true);
  EXPECT_NEAR(gyro.bias().value, 0.3 * kDeg, 0.01 * kDeg);
  const double before = gyro.angle_rad();
  feed(gyro, now, 1000, 0.3 * kDeg, false);
  EXPECT_NEAR(gyro.angle_rad() - before, 0.0, 0.1 * kDeg) << "10 s of bias are taken off";
}

TEST(GyroHeading, DoesNotLearnARealTurnAsBias)
{
  GyroHeading gyro{GyroParams{}};
  feed(gyro, kStart, 100, 0.1, true);  // pushed while the wheels stand
  EXPECT_EQ(gyro.bias().value, 0.0);
}

TEST(GyroHeading, VarianceGrowsWithTimeUntilMarked)
{
  GyroHeading gyro{GyroParams{}};
  gyro.add({kStart, 0.0}, false);
  const Nanoseconds now = feed(gyro, kStart, 1000, 0.0, false);
  // (0.0052 rad/s * 10 s)^2 of bias and 1000 (0.0018 * 0.01)^2 of white noise.
  const double expected = 0.052 * 0.052 + 1000 * std::pow(0.0018 * 0.01, 2);
  EXPECT_NEAR(gyro.variance_since_mark() / expected, 1.0, 0.01);
  gyro.mark();
  EXPECT_EQ(gyro.variance_since_mark(), 0.0);
  feed(gyro, now, 1, 0.0, false);
  EXPECT_GT(gyro.variance_since_mark(), 0.0);
}

TEST(GyroHeading, TellsOfASilenceAndDoubtsMore)
{
  GyroHeading gyro{GyroParams{}};
  EXPECT_TRUE(gyro.add({kStart, 0.1}, false));
  EXPECT_FALSE(gyro.add({kStart + milliseconds(500), 0.1}, false));
  EXPECT_EQ(gyro.angle_rad(), 0.0);
  EXPECT_GE(gyro.variance_since_mark(), 0.05 * 0.05);  // 0.1 rad/s for 0.5 s may be unseen
}

}  // namespace
}  // namespace stetro_localizer
