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
#include <stdexcept>
#include <thread>
#include <vector>

#include "stetro_dds/timer.hpp"

namespace stetro_dds
{
namespace
{

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

class SimulatedTimer : public testing::Test
{
protected:
  bool at(Time now)
  {
    clock_.set(now);
    return timer_.fire_if_due();
  }

  Clock clock_{TimeSource::kByHand};
  std::vector<Time> fired_at_;
  Timer timer_{
    clock_, Timer::Counts::kNodeTime, 100ms, [this](Time now) { fired_at_.push_back(now); }};
};

TEST_F(SimulatedTimer, WaitsForTimeToBeKnown)
{
  EXPECT_FALSE(timer_.fire_if_due());
  EXPECT_FALSE(at(1000s)) << "its first period begins";
  EXPECT_FALSE(at(1000s + 99ms));
  EXPECT_TRUE(at(1000s + 100ms));
}

TEST_F(SimulatedTimer, FiresOnceAPeriodHoweverOftenItIsAsked)
{
  for (int i = 0; i <= 100; ++i) {
    at(1000s + i * 10ms);
    timer_.fire_if_due();
  }
  EXPECT_EQ(fired_at_.size(), 10U);
  EXPECT_EQ(fired_at_.front(), 1000s + 100ms);
  EXPECT_EQ(fired_at_.back(), 1001s);
}

TEST_F(SimulatedTimer, SkipsWhatItMissedAndStaysOnItsGrid)
{
  at(1000s);
  EXPECT_TRUE(at(1000s + 350ms));
  EXPECT_FALSE(timer_.fire_if_due());
  EXPECT_EQ(timer_.skipped(), 2U);
  EXPECT_FALSE(at(1000s + 399ms));
  EXPECT_TRUE(at(1000s + 400ms));
}

TEST_F(SimulatedTimer, IsSilentOnceCancelled)
{
  at(1000s);
  timer_.cancel();
  EXPECT_FALSE(at(1001s));
}

TEST_F(SimulatedTimer, DoesNotDecideHowLongTheExecutorSleeps)
{
  at(1000s);
  EXPECT_FALSE(timer_.next_steady());
}

TEST(SteadyTimer, CountsSteadyTimeEvenOnASimulatedClock)
{
  Clock clock(TimeSource::kByHand);
  int fired = 0;
  Timer timer(clock, Timer::Counts::kSteadyTime, 1ms, [&fired](Time) { ++fired; });
  ASSERT_TRUE(timer.next_steady());
  const auto deadline = Clock::steady_now() + 5s;
  while (fired == 0 && Clock::steady_now() < deadline) {
    timer.fire_if_due();
  }
  EXPECT_EQ(fired, 1);
  EXPECT_GT(*timer.next_steady(), Clock::steady_now() - 1ms);
}

TEST(TimerSetup, RefusesAPeriodThatIsNone)
{
  const Clock clock(TimeSource::kSystem);
  EXPECT_THROW(Timer(clock, Timer::Counts::kNodeTime, 0s, [](Time) {}), std::invalid_argument);
  EXPECT_THROW(Timer(clock, Timer::Counts::kNodeTime, 1s, nullptr), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_dds
