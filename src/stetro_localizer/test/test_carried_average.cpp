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

#include <stdexcept>

#include "stetro_localizer/carried_average.hpp"

namespace stetro_localizer
{
namespace
{

using std::chrono::milliseconds;

constexpr Nanoseconds kStart = std::chrono::seconds(1000);

CarriedAverage six_readings() { return {6, 3, milliseconds(400)}; }

TEST(CarriedAverage, IsThePapersPlainMeanWithoutACarrier)
{
  auto average = six_readings();
  for (const double value : {1.0, 2.0, 3.0, 6.0}) {
    average.add(kStart, value, 0.0);
  }
  const auto mean = average.at(kStart, 0.0);
  ASSERT_TRUE(mean.has_value());
  EXPECT_DOUBLE_EQ(mean->value, 3.0);  // (1 + 2 + 3 + 6) / 4
  EXPECT_EQ(mean->count, 4u);
}

TEST(CarriedAverage, KeepsOnlyTheWindow)
{
  auto average = six_readings();
  for (int i = 1; i <= 10; ++i) {
    average.add(kStart, i, 0.0);
  }
  EXPECT_DOUBLE_EQ(average.at(kStart, 0.0)->value, 7.5);  // (5 + ... + 10) / 6
}

TEST(CarriedAverage, SaysNothingWithTooFewOrTooOldReadings)
{
  auto average = six_readings();
  average.add(kStart, 1.0, 0.0);
  average.add(kStart, 1.0, 0.0);
  EXPECT_FALSE(average.at(kStart, 0.0)) << "two of at least three";
  average.add(kStart + milliseconds(100), 1.0, 0.0);
  EXPECT_TRUE(average.at(kStart + milliseconds(400), 0.0));
  EXPECT_FALSE(average.at(kStart + milliseconds(401), 0.0)) << "two of three have left by age";
}

// 0.15 m/s at 30 Hz: the plain mean of six lags by 2.5 periods, 12.5 mm. Carried, it does not lag.
TEST(CarriedAverage, DoesNotLagBehindAMovingRobot)
{
  auto plain = six_readings();
  auto carried = six_readings();
  const Nanoseconds period{33'333'333};
  double y_m = 0.2;
  Nanoseconds now = kStart;
  for (int i = 0; i < 20; ++i) {
    now += period;
    y_m += 0.15 / 30.0;
    plain.add(now, y_m, 0.0);
    carried.add(now, y_m, y_m - 0.2);  // odometry from where it began
  }
  EXPECT_NEAR(y_m - plain.at(now, 0.0)->value, 0.0125, 1e-9);
  EXPECT_NEAR(y_m - carried.at(now, y_m - 0.2)->value, 0.0, 1e-9);
}

TEST(CarriedAverage, RefusesAWindowThatCannotBe)
{
  EXPECT_THROW(CarriedAverage(0, 1, milliseconds(1)), std::invalid_argument);
  EXPECT_THROW(CarriedAverage(65, 1, milliseconds(1)), std::invalid_argument);
  EXPECT_THROW(CarriedAverage(6, 7, milliseconds(1)), std::invalid_argument);
  EXPECT_THROW(CarriedAverage(6, 3, milliseconds(0)), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_localizer
