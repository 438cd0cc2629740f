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
#include <time.h>

#include <limits>

#include "linux/device_clock.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using std::chrono::milliseconds;
using std::chrono::seconds;

Time monotonic()
{
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return seconds{now.tv_sec} + std::chrono::nanoseconds{now.tv_nsec};
}

TEST(DeviceClock, ShowsItsEpochPlusTheMonotonicTimeSinceItWasMade)
{
  const Time before = monotonic();
  const DeviceClock clock{seconds{1000}};
  const Time after = monotonic();
  const Time stamp = after + milliseconds{40};
  EXPECT_GE(clock.at(stamp), seconds{1000} + milliseconds{40});
  EXPECT_LE(clock.at(stamp), seconds{1000} + milliseconds{40} + (after - before));
  EXPECT_EQ(clock.at(stamp + Time{1}) - clock.at(stamp), Time{1}) << "exact at rate 1";
  EXPECT_GE(clock.now(), seconds{1000});
}

TEST(DeviceClock, RunsAtItsRateAndConvertsWaitsBack)
{
  const DeviceClock clock{Time::zero(), 4.0};
  const Time stamp = monotonic() + seconds{1};
  EXPECT_EQ(clock.at(stamp + milliseconds{10}) - clock.at(stamp), milliseconds{40});
  EXPECT_EQ(clock.real(milliseconds{100}), milliseconds{25});
  EXPECT_EQ(clock.rate(), 4.0);
  const DeviceClock slow{Time::zero(), 0.5};
  EXPECT_EQ(slow.at(stamp + milliseconds{10}) - slow.at(stamp), milliseconds{5});
  EXPECT_EQ(slow.real(milliseconds{100}), milliseconds{200});
}

TEST(DeviceClock, CopiesShowTheSameTime)
{
  const DeviceClock clock{seconds{5}, 2.0};
  const DeviceClock copy = clock;
  const Time stamp = monotonic();
  EXPECT_EQ(clock.at(stamp), copy.at(stamp));
}

TEST(DeviceClock, RefusesARateThatHardlyRunsOrIsNoNumber)
{
  EXPECT_THROW(DeviceClock(Time::zero(), 0.05), std::invalid_argument);
  EXPECT_THROW(DeviceClock(Time::zero(), 1001.0), std::invalid_argument);
  EXPECT_THROW(
    DeviceClock(Time::zero(), std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_driver::linux_io
