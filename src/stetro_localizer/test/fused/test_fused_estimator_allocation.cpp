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

#include <cstddef>
#include <cstdint>

#include "stetro_tests/counted_allocations.hpp"
#include "support/fused_rig.hpp"

namespace stetro_localizer
{
namespace
{

using std::chrono::milliseconds;

TEST(FusedEstimatorAllocation, TakesSamplesWithoutAllocating)
{
  Rig rig(3, uncalibrated());
  rig.robot.drive(0.0, 0.1, 0.0, 0.1);
  const Nanoseconds now = rig.robot.now;
  RangeSample ranges = rig.robot.ranges();
  ranges.stamp = now - milliseconds(15);  // wheels and gyroscope came since: they are taken again
  for (RangeReading & reading : ranges.readings) {
    reading.stamp = ranges.stamp;
  }
  const std::uint64_t fused = rig.estimator.reports()[Source::kSideLeft].fused;
  const std::size_t counted = allocations;
  const Verdict verdict = rig.estimator.add_ranges(ranges, now);
  EXPECT_EQ(allocations, counted);
  EXPECT_EQ(verdict.outcome, Outcome::kFused);
  EXPECT_EQ(rig.estimator.reports()[Source::kSideLeft].fused, fused + 1);
}

// Every kind of sample, from wall to wall and up a step.
TEST(FusedEstimatorAllocation, SweepsAndClimbsWithoutAllocating)
{
  Rig rig(3, uncalibrated());
  const std::size_t counted = allocations;
  rig.sweep();
  rig.robot.climb(3);
  rig.sweep();
  rig.estimator.tick(rig.robot.now + milliseconds(600));  // silent: it predicts
  EXPECT_EQ(allocations, counted);
  const SourceReports & reports = rig.estimator.reports();
  EXPECT_EQ(rig.estimate().step, 4);
  EXPECT_GT(reports[Source::kBumperLeft].fused, 0u);
  EXPECT_GT(reports[Source::kRiserSwitches].fused, 0u);
  EXPECT_GT(reports[Source::kBlocks].fused, 0u);
  EXPECT_TRUE(rig.estimate().reasons & kInputSilent);
}

}  // namespace
}  // namespace stetro_localizer
