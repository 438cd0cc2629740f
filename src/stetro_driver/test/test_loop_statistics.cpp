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

#include <algorithm>
#include <cstdlib>
#include <new>
#include <random>
#include <vector>

#include "linux/loop_statistics.hpp"

namespace
{

int allocations = 0;

}  // namespace

void * operator new(std::size_t size)
{
  ++allocations;
  if (void * memory = std::malloc(size)) {
    return memory;
  }
  throw std::bad_alloc();
}
void operator delete(void * memory) noexcept { std::free(memory); }
void operator delete(void * memory, std::size_t) noexcept { std::free(memory); }

namespace stetro_driver::linux_io
{
namespace
{

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr Time kPeriod = milliseconds{10};

TEST(LoopStatistics, ALoopThatKeepsItsTimeHasNoError)
{
  LoopStatistics loop(kPeriod);
  for (int k = 0; k < 100; ++k) {
    loop.begin(k * kPeriod);
    loop.end(k * kPeriod + milliseconds{2});
  }
  const LoopSummary summary = loop.summary();
  EXPECT_EQ(summary.cycles, 100u);
  EXPECT_EQ(summary.overruns, 0u);
  EXPECT_EQ(summary.mean_period, kPeriod);
  EXPECT_EQ(summary.period_error_max, Time{0});
  EXPECT_EQ(summary.period_error_p999, Time{0});
  EXPECT_EQ(summary.mean_work, milliseconds{2});
  EXPECT_EQ(summary.longest_work, milliseconds{2});
}

TEST(LoopStatistics, BeforeTheFirstCycleThereIsNothingToTell)
{
  LoopStatistics loop(kPeriod);
  loop.end(milliseconds{5});
  EXPECT_EQ(loop.summary().cycles, 0u);
  EXPECT_EQ(loop.summary().mean_period, Time{0});
  EXPECT_EQ(loop.summary().period_error_p50, Time{0});
}

TEST(LoopStatistics, ACycleThatWorksTooLongIsAnOverrun)
{
  LoopStatistics loop(kPeriod);
  loop.begin(milliseconds{0});
  loop.end(milliseconds{10});
  EXPECT_EQ(loop.summary().overruns, 0u) << "just in time";
  loop.begin(milliseconds{10});
  loop.end(milliseconds{23});
  loop.begin(milliseconds{23});
  loop.end(milliseconds{24});
  const LoopSummary summary = loop.summary();
  EXPECT_EQ(summary.overruns, 1u);
  EXPECT_EQ(summary.longest_work, milliseconds{13});
  EXPECT_EQ(summary.mean_work, milliseconds{8});  // (10 + 13 + 1) / 3
  EXPECT_EQ(summary.period_error_max, milliseconds{3});
  EXPECT_EQ(summary.mean_period, microseconds{11'500});  // (10 + 13) / 2
}

// Property: quantiles lie at the true ones or above, by no more than a bin of 9 %.
TEST(LoopStatistics, QuantilesAreThoseOfTheErrors)
{
  std::mt19937 random{20260315};
  std::lognormal_distribution<double> error_s{-9.0, 1.2};  // 0.12 ms, some of them 4 ms
  LoopStatistics loop(kPeriod);
  std::vector<Time> errors;
  Time now{0};
  loop.begin(now);
  for (int k = 0; k < 20'000; ++k) {
    const Time error = std::min(seconds_to_time(error_s(random)), kPeriod);
    errors.push_back(error);
    now += k % 2 == 0 ? kPeriod + error : kPeriod - error;  // late and early
    loop.begin(now);
  }
  std::sort(errors.begin(), errors.end());
  const LoopSummary summary = loop.summary();
  const auto expect_at = [&](double share, Time told) {
    const Time truth = errors[static_cast<std::size_t>(share * 20'000.0) - 1];
    EXPECT_GE(told, truth) << share;
    EXPECT_LE(time_to_seconds(told), 1.091 * time_to_seconds(truth)) << share;
  };
  expect_at(0.5, summary.period_error_p50);
  expect_at(0.999, summary.period_error_p999);
  EXPECT_EQ(summary.period_error_max, errors.back());
}

TEST(LoopStatistics, AllocatesNothing)
{
  LoopStatistics loop(kPeriod);
  const int before = allocations;
  for (int k = 0; k < 1000; ++k) {
    loop.begin(k * kPeriod);
    loop.end(k * kPeriod + milliseconds{k % 12});
  }
  const LoopSummary summary = loop.summary();
  EXPECT_EQ(allocations, before);
  EXPECT_EQ(summary.cycles, 1000u);
}

}  // namespace
}  // namespace stetro_driver::linux_io
