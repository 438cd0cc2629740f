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

#include "stetro_dds/clock.hpp"
#include "stetro_dds/monotone_time.hpp"

namespace stetro_dds
{
namespace
{

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;
using std::chrono_literals::operator""us;

TEST(SystemClock, TellsTheTimeSinceTheEpoch)
{
  const Clock clock(TimeSource::kSystem);
  const Time wall = std::chrono::system_clock::now().time_since_epoch();
  EXPECT_GE(clock.now(), wall);
  EXPECT_LT(clock.now(), wall + 10s);
  EXPECT_TRUE(clock.known());
}

TEST(SystemClock, CannotBeSet)
{
  Clock clock(TimeSource::kSystem);
  EXPECT_TRUE(clock.set(1s));
}

TEST(SimulatedClock, IsUnknownUntilSet)
{
  Clock clock(TimeSource::kClockTopic);
  EXPECT_FALSE(clock.known());
  EXPECT_EQ(clock.now(), 0s);
  EXPECT_FALSE(clock.set(1000s));
  EXPECT_TRUE(clock.known());
  EXPECT_EQ(clock.now(), 1000s);
}

TEST(SimulatedClock, RefusesTimeZeroAndThePast)
{
  Clock clock(TimeSource::kByHand);
  EXPECT_EQ(clock.set(0s)->reason, "time zero");
  EXPECT_FALSE(clock.set(1000s));
  EXPECT_EQ(clock.set(-1s)->reason, "time zero");
  EXPECT_EQ(clock.set(999s)->reason, "time runs backwards");
  EXPECT_EQ(clock.now(), 1000s);
  EXPECT_EQ(clock.faults().zero, 2U);
  EXPECT_EQ(clock.faults().backwards, 1U);
}

TEST(SimulatedClock, RefusesAStrayJumpAndGoesOn)
{
  Clock clock(TimeSource::kClockTopic);
  ASSERT_FALSE(clock.set(1000s));
  const auto refusal = clock.set(2000000000s);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->reason, "time jumps");
  EXPECT_EQ(clock.now(), 1000s);
  EXPECT_FALSE(clock.set(1000s + 10ms)) << "the true time is followed all the same";
  EXPECT_EQ(clock.faults().forwards, 1u);
}

TEST(SimulatedClock, BelievesAJumpThatManySettingsAgreeOn)
{
  Clock clock(TimeSource::kClockTopic);
  ASSERT_FALSE(clock.set(1000s));
  int refused = 0;
  while (refused < 100 && clock.set(1100s + refused * 10ms)) {
    ++refused;
  }
  EXPECT_EQ(refused, 9);
  EXPECT_EQ(clock.now(), 1100s + 9 * 10ms);
}

TEST(SimulatedClock, MayBeToldTheSameTimeTwice)
{
  Clock clock(TimeSource::kByHand);
  EXPECT_FALSE(clock.set(1000s));
  EXPECT_FALSE(clock.set(1000s));
  EXPECT_EQ(clock.faults().backwards, 0U);
}

TEST(MonotoneTime, FollowsASteadyWall)
{
  MonotoneTime time;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(time.advance(1000s + i * 10ms, 5s + i * 10ms), 1000s + i * 10ms);
  }
  EXPECT_EQ(time.faults().backwards + time.faults().forwards, 0U);
}

TEST(MonotoneTime, FollowsAndCountsAStepForwards)
{
  MonotoneTime time;
  time.advance(1000s, 5s);
  EXPECT_EQ(time.advance(4600s, 6s), 4600s);
  EXPECT_EQ(time.faults().forwards, 1U);
}

TEST(MonotoneTime, GoesOnThroughAStepBackwards)
{
  MonotoneTime time;
  time.advance(1000s, 5s);
  // 1 s later the wall says an hour less: 1 s at 999/1000 of the steady rate
  EXPECT_EQ(time.advance(1000s - 3600s, 6s), 1000s + 999ms);
  EXPECT_EQ(time.faults().backwards, 1U);
  EXPECT_EQ(time.faults().behind, 3600s + 999ms);
  EXPECT_EQ(time.advance(1001s - 3600s, 7s), 1000s + 1998ms);
  EXPECT_EQ(time.faults().backwards, 1U) << "one step, counted once";
}

TEST(MonotoneTime, MeetsTheWallAgainAfterASmallStep)
{
  MonotoneTime time;
  Time last = time.advance(1000s, 0s);
  for (int i = 1; i <= 20; ++i) {  // 5 ms back; lost at 1 ms a second, so gone after 5 s
    const Time now = time.advance(1000s - 5ms + i * 1s, i * 1s);
    EXPECT_GT(now, last);
    last = now;
  }
  EXPECT_EQ(last, 1020s - 5ms);
  EXPECT_EQ(time.faults().behind, 0s);
  EXPECT_EQ(time.faults().backwards, 1U);
}

}  // namespace
}  // namespace stetro_dds
