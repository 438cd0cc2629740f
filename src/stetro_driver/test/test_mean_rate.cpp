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

#include <random>

#include "linux/imu/mean_rate.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using std::chrono::milliseconds;

TEST(MeanRate, WeighsSamplesByTheirTime)
{
  MeanRate turning;
  turning.add({0.0, 0.0, 0.1}, milliseconds{10});
  turning.add({0.3, 0.0, 0.4}, milliseconds{20});  // the one between was hurt on its way
  const auto mean = turning.take();
  ASSERT_TRUE(mean);
  EXPECT_NEAR(mean->rate_rad_s[0], 0.2, 1e-15);
  EXPECT_NEAR(mean->rate_rad_s[1], 0.0, 1e-15);
  EXPECT_NEAR(mean->rate_rad_s[2], 0.3, 1e-15);  // (0.1 * 10 + 0.4 * 20) / 30
  EXPECT_EQ(mean->samples, 2u);
}

TEST(MeanRate, IsNothingUntilASampleComes)
{
  MeanRate turning;
  EXPECT_FALSE(turning.take());
  turning.add({1.0, 1.0, 1.0}, milliseconds{10});
  EXPECT_TRUE(turning.take());
  EXPECT_FALSE(turning.take()) << "it was taken";
}

TEST(MeanRate, OfEqualSamplesIsThatSampleToTheLastBit)
{
  std::mt19937 random{20260522};
  std::uniform_int_distribution<int> lasted_ns{9'900'000, 10'100'000};
  MeanRate turning;
  for (int look = 0; look < 100; ++look) {
    for (int sample = 0; sample <= look % 4; ++sample) {
      turning.add({0.1, 0.2, 1.0 / 3.0}, Time{lasted_ns(random)});
    }
    EXPECT_EQ(turning.take()->rate_rad_s, (Axes{0.1, 0.2, 1.0 / 3.0})) << look;
  }
}

// Property: at whatever times one looks, the angles between add up to those of the samples.
TEST(MeanRate, LosesNoAngleAndCountsNoneTwice)
{
  std::mt19937 random{20260521};
  std::uniform_real_distribution<double> rate_rad_s{-2.0, 2.0};
  std::uniform_int_distribution<int> lasted_us{500, 20'000};
  std::bernoulli_distribution looks{0.4};
  for (int round = 0; round < 100; ++round) {
    MeanRate turning;
    double turned_rad = 0.0;
    double told_rad = 0.0;
    Time now{0};
    Time looked{0};
    for (int sample = 0; sample < 200; ++sample) {
      const Time lasted = std::chrono::microseconds{lasted_us(random)};
      const double rate = rate_rad_s(random);
      now += lasted;
      turned_rad += rate * time_to_seconds(lasted);
      turning.add({0.0, 0.0, rate}, lasted);
      if (looks(random) || sample == 199) {
        const auto mean = turning.take();
        ASSERT_TRUE(mean);
        told_rad += mean->rate_rad_s[2] * time_to_seconds(now - looked);
        looked = now;
      }
    }
    EXPECT_NEAR(told_rad, turned_rad, 1e-12) << round;
  }
}

}  // namespace
}  // namespace stetro_driver::linux_io
