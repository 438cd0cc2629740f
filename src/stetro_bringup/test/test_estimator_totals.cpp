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

#include "accuracy/estimator_totals.hpp"

namespace stetro_bringup
{
namespace
{

constexpr int kSteps = 4;

ScoredEstimate sample_on(int step, double y_error_m, double nees)
{
  ScoredEstimate sample;
  sample.step = step;
  sample.integrity = stetro_localizer::Integrity::kOk;
  sample.errors.y_m = y_error_m;
  sample.nees = nees;
  return sample;
}

TEST(EstimatorTotals, KeepsTheFirstTreadAndTouchDownsApart)
{
  ClimbScore score;
  score.samples = {
    sample_on(1, 0.1, 3.0), sample_on(2, 0.003, 3.0), sample_on(2, -0.004, 3.0),
    sample_on(3, 0.9, 3.0)};
  score.samples.front().first_tread = true;
  score.samples.back().confirming = true;
  EstimatorTotals totals(kSteps);
  totals.add(score);
  EXPECT_EQ(totals.errors.y_m.count(), 2u);
  EXPECT_NEAR(totals.errors.y_m.rmse(), std::sqrt(12.5e-6), 1e-12);
  EXPECT_EQ(totals.first_tread.y_m.count(), 1u);
  EXPECT_EQ(totals.confirming, 1u);
  EXPECT_EQ(totals.treads.at(2).y_m.count(), 2u);
}

// Four steps: beyond tread 2 no riser is left for the front sensors to see.
TEST(EstimatorTotals, TellsNeesWithAndWithoutAReference)
{
  ClimbScore score;
  score.samples = {
    sample_on(2, 0.0, 3.0), sample_on(2, 0.0, 9.4),  // above 9.348
    sample_on(3, 0.0, 0.21),                         // below 0.2158
    sample_on(4, 0.0, 1.0), sample_on(4, 0.0, std::nan(""))};
  EstimatorTotals totals(kSteps);
  totals.add(score);
  EXPECT_EQ(totals.nees.known(), 4u);
  EXPECT_EQ(totals.nees.unknown, 1u);
  EXPECT_DOUBLE_EQ(totals.nees.inside_share(), 0.5);
  EXPECT_DOUBLE_EQ(totals.nees_with_reference.inside_share(), 0.5);
  EXPECT_EQ(totals.nees_with_reference.above, 1u);
  EXPECT_DOUBLE_EQ(totals.nees_without_reference.inside_share(), 0.5);
  EXPECT_NEAR(totals.nees.mean(), (3.0 + 9.4 + 0.21 + 1.0) / 4.0, 1e-12);
}

TEST(EstimatorTotals, AJumpIsTheLargerOfItsTwoParts)
{
  ClimbScore score;
  score.hand_overs = {{0.001, -0.003}, {-0.002, 0.0}};
  EstimatorTotals totals(kSteps);
  totals.add(score);
  EXPECT_DOUBLE_EQ(totals.hand_over_m.max(), 0.003);
  EXPECT_NEAR(totals.hand_over_m.mean(), 0.0025, 1e-12);
  EXPECT_DOUBLE_EQ(totals.hand_over_x_m.max(), 0.002);
}

TEST(EstimatorTotals, AddUpTheCountersOfTheClimbs)
{
  ClimbScore one;
  one.alarms = 2;
  one.treads = 16;
  one.treads_exceeded = 1;
  one.steps = {16, 3, 1, 15, {{0, MiscountEnd::kNoticed}, {1, MiscountEnd::kCorrected}}};
  ClimbScore other;
  other.alarms = 1;
  other.treads = 4;
  other.steps = {4, 1, 1, 3, {{2, MiscountEnd::kUnnoticed}}};
  EstimatorTotals totals(kSteps);
  totals.add(one);
  totals.add(other);
  EXPECT_EQ(totals.climbs, 2u);
  EXPECT_EQ(totals.counts.alarms, 3u);
  EXPECT_EQ(totals.counts.treads, 20u);
  EXPECT_EQ(totals.counts.treads_exceeded, 1u);
  EXPECT_EQ(totals.counts.steps.checks, 20u);
  EXPECT_EQ(totals.counts.steps.wrong, 4u);
  EXPECT_EQ(totals.counts.steps.undetected, 2u);
  EXPECT_EQ(totals.counts.steps.on_stairs, 18u);
  ASSERT_EQ(totals.counts.steps.miscounts.size(), 3u);
  EXPECT_EQ(totals.counts.steps.miscounts[2].end, MiscountEnd::kUnnoticed);
}

TEST(EstimatorTotals, KeepsTheLongestTimesAndCountsTheClimbsBeyondOneSecond)
{
  EstimatorTotals totals(kSteps);
  for (const double exceedance_s : {0.2, 1.0, 1.01, 3.0}) {
    ClimbScore score;
    score.longest_exceedance_s = exceedance_s;
    score.longest_confirmation_s = 0.1 * exceedance_s;
    totals.add(score);
  }
  EXPECT_EQ(totals.exceeded_climbs, 2u) << "one second is tolerated";
  EXPECT_DOUBLE_EQ(totals.longest_exceedance_s, 3.0);
  EXPECT_DOUBLE_EQ(totals.longest_confirmation_s, 0.3);
}

TEST(EstimatorTotals, JudgesOnlyFaultsThatStruckAndCouldBeNoticed)
{
  EstimatorTotals totals(kSteps);
  ClimbScore score;
  totals.add(score);  // none injected
  score.detection = Detection{};
  totals.add(score);  // ended before it
  score.detection->struck = true;
  totals.add(score);  // missed
  score.detection->never_ok = true;
  totals.add(score);
  EXPECT_EQ(totals.detections.size(), 1u);
  EXPECT_EQ(totals.never_ok, 1u);
}

TEST(EstimatorTotals, TakesLevelsAndSpreadsOnlyWhereTheyAreKnown)
{
  ClimbScore score;
  score.samples = {sample_on(2, 0.0, 3.0), sample_on(2, 0.0, 3.0)};
  score.samples[0].protection = {0.020, 0.030, std::nan("")};
  score.samples[0].sigma_x_m = std::nan("");
  score.samples[1].sigma_x_m = 0.004;
  score.samples[1].after_onset = true;
  EstimatorTotals totals(kSteps);
  totals.add(score);
  EXPECT_EQ(totals.protection_along_m.count(), 1u);
  EXPECT_DOUBLE_EQ(totals.protection_across_m.max(), 0.030);
  EXPECT_EQ(totals.protection_heading_rad.count(), 0u);
  EXPECT_DOUBLE_EQ(totals.treads[2].sigma_x_m.rms(), 0.004);
  EXPECT_EQ(totals.after_onset.y_m.count(), 1u);
}

}  // namespace
}  // namespace stetro_bringup
