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
#include <cstdint>
#include <limits>

#include "stetro_dds/stamp.hpp"

namespace stetro_dds
{
namespace
{

using namespace std::chrono_literals;  // NOLINT: literals only

constexpr std::int32_t kLastSecond = std::numeric_limits<std::int32_t>::max();
constexpr Time kLastTime{2'147'483'647'999'999'999};  // 2^31 s less a nanosecond

builtin_interfaces::msg::Time stamp(std::int32_t sec, std::uint32_t nanosec)
{
  builtin_interfaces::msg::Time result;
  result.sec(sec);
  result.nanosec(nanosec);
  return result;
}

TEST(Stamp, SaysSecondsAndTheRestInNanoseconds)
{
  EXPECT_EQ(time_of(stamp(1234, 567'890'123)), Time{1'234'567'890'123});
  EXPECT_EQ(stamp_of(Time{1'234'567'890'123}), stamp(1234, 567'890'123));
  EXPECT_EQ(stamp_of(1500ms), stamp(1, 500'000'000));
  EXPECT_EQ(stamp_of(Time{0}), stamp(0, 0));
}

TEST(Stamp, ThereAndBackIsTheIdentity)
{
  for (const Time time :
       {Time{0}, Time{1}, Time{999'999'999}, Time{1s}, Time{1000s + 10ms}, kLastTime}) {
    EXPECT_EQ(time_of(stamp_of(time)), time) << time.count();
  }
}

TEST(Stamp, IsTheZeroTimeIfItIsNone)
{
  EXPECT_EQ(time_of(stamp(-1, 0)), 0s);
  EXPECT_EQ(time_of(stamp(-1, 999'999'999)), 0s);
  EXPECT_EQ(time_of(stamp(std::numeric_limits<std::int32_t>::min(), 0)), 0s);
  EXPECT_EQ(time_of(stamp(1000, 999'999'999)), 1001s - 1ns) << "the last nanosecond of a second";
  EXPECT_EQ(time_of(stamp(1000, 1'000'000'000)), 0s) << "a whole second";
  EXPECT_EQ(time_of(stamp(1000, std::numeric_limits<std::uint32_t>::max())), 0s);
}

TEST(Stamp, IsZeroForATimeItCannotSay)
{
  EXPECT_EQ(stamp_of(Time{-1}), stamp(0, 0));
  EXPECT_EQ(stamp_of(-1000s), stamp(0, 0));
  EXPECT_EQ(stamp_of(Time::min()), stamp(0, 0));
  EXPECT_EQ(stamp_of(kLastTime), stamp(kLastSecond, 999'999'999));
  EXPECT_EQ(stamp_of(kLastTime + 1ns), stamp(0, 0)) << "one second more than 31 bits hold";
  EXPECT_EQ(stamp_of(Time::max()), stamp(0, 0));
}

}  // namespace
}  // namespace stetro_dds
