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

#include "linux/clock_shift.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using namespace std::chrono_literals;

TEST(ClockShift, KeepsTheLargestDifference)
{
  ClockShift shift;
  EXPECT_EQ(shift.take(1000s, 5s), Time{995s});
  EXPECT_EQ(shift.take(1000s + 10ms, 5s + 12ms), Time{995s}) << "we were late";
  EXPECT_EQ(shift.take(1000s + 21ms, 5s + 20ms), Time{995s + 1ms});
  for (int i = 3; i < 1000; ++i) {  // a difference comes back now and then: stamps stay
    const Time late = i % 50 == 0 ? 0ms : 3ms;
    EXPECT_EQ(shift.take(1000s + i * 10ms + 1ms - late, 5s + i * 10ms), Time{995s + 1ms});
  }
}

// A wall clock was set back by 0.3 s: the caller's time goes on, 1 ms in a second slower.
TEST(ClockShift, FollowsACallerThatRunsSlower)
{
  ClockShift shift;
  static_cast<void>(shift.take(1000s, 5s));
  Time most_ahead{0};
  for (int i = 1; i < 30000; ++i) {
    const Time passed = i * 10ms;
    const Time caller = 1000s + passed - passed / 1000;
    const Time device = 5s + passed;
    most_ahead = std::max(most_ahead, device + shift.take(caller, device) - caller);
  }
  EXPECT_LE(most_ahead, Time{4ms});
}

TEST(ClockShift, TakesAStepAtOnce)
{
  ClockShift shift;
  static_cast<void>(shift.take(1000s, 5s));
  EXPECT_EQ(shift.take(999s, 5s + 10ms), Time{994s - 10ms});
  EXPECT_EQ(shift.take(1003s, 5s + 20ms), Time{998s - 20ms});
}

}  // namespace
}  // namespace stetro_driver::linux_io
