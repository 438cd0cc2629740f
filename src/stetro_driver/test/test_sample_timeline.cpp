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

#include "linux/imu/sample_timeline.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using std::chrono::milliseconds;

TEST(SampleTimeline, AnArrivalOnTimeSetsTheStamp)
{
  SampleTimeline timeline;
  EXPECT_EQ(timeline.stamp(milliseconds{10}, milliseconds{1015}), milliseconds{1015});
  EXPECT_EQ(timeline.stamp(milliseconds{20}, milliseconds{1022}), milliseconds{1022})
    << "less delayed than the first";
}

TEST(SampleTimeline, SamplesThatPileUpKeepTheirDistances)
{
  SampleTimeline timeline;
  EXPECT_EQ(timeline.stamp(milliseconds{10}, milliseconds{1010}), milliseconds{1010});
  for (const int k : {2, 3, 4, 5}) {  // all read at once, 40 ms later
    const Time stamp = timeline.stamp(milliseconds{10 * k}, milliseconds{1055});
    EXPECT_NEAR(time_to_seconds(stamp - milliseconds{1000 + 10 * k}), 0.0, 1e-5) << k;
  }
}

// Property: whatever the delays and the drift of the sensor's clock within the creep, a stamp is
// late by no more than the least delay of late, and never runs backwards.
TEST(SampleTimeline, JitterIsTakenOutAndDriftIsFollowed)
{
  for (const double drift : {-1e-4, 0.0, 1e-4}) {
    std::mt19937 random{20260314};
    std::exponential_distribution<double> delay_s{500.0};  // 2 ms in the mean
    SampleTimeline timeline;
    Time last{0};
    double worst_s = 0.0;
    for (int k = 1; k <= 60'000; ++k) {  // ten minutes at 100 Hz
      const double truth_s = 1000.0 + 0.01 * k;
      const Time uptime = seconds_to_time(0.01 * k * (1.0 + drift));
      const Time stamp = timeline.stamp(uptime, seconds_to_time(truth_s + delay_s(random)));
      EXPECT_GT(stamp, last) << k;
      last = stamp;
      if (k > 1000) {
        worst_s = std::fmax(worst_s, std::fabs(time_to_seconds(stamp) - truth_s));
      }
    }
    EXPECT_LT(worst_s, 0.0005) << "drift " << drift;
  }
}

}  // namespace
}  // namespace stetro_driver::linux_io
