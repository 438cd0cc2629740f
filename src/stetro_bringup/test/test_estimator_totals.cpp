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

#include "accuracy/accuracy_report.hpp"
#include "accuracy/estimator_totals.hpp"
#include "nlohmann/json.hpp"

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

TEST(AccuracyReport, NestsItsKeysAndBoundsItsRates)
{
  ClimbRecord record;
  record.seed = 7;
  record.end = ClimbEnd::kHeld;
  record.detail = "integrity is LOST";
  record.last_step = 3;
  record.scores.resize(1);
  ClimbScore & score = record.scores.front();
  score.samples = {sample_on(2, 0.003, 3.0)};
  score.closures_m = {0.002, 0.004};
  score.step_checks = 10;
  score.ticks_ok = 75;
  score.ticks_lost = 25;
  AccuracyReport report{1, 7, "site", "none", "stairs", kSteps, {"paper"}, {"", kSteps, 1}, {}};
  report.overall.add(record);
  const auto json = nlohmann::json::parse(summary_json(report));
  const auto & paper = json["paper"];
  EXPECT_DOUBLE_EQ(paper["y"]["rmse_m"], 0.003);
  EXPECT_DOUBLE_EQ(paper["heading"]["max_rad"], 0.0);
  EXPECT_NEAR(paper["closure_error"]["mean_m"], 0.003, 1e-12);
  EXPECT_NEAR(paper["closure_error"]["std_m"], 0.001, 1e-12);
  EXPECT_DOUBLE_EQ(paper["nees_inside_95"], 1.0);
  EXPECT_EQ(paper["undetected_step_errors"], 0);
  EXPECT_NEAR(paper["step_errors"]["undetected"]["high_95"], 0.3085, 5e-5);  // none of ten
  EXPECT_DOUBLE_EQ(paper["integrity"]["ok_share"], 0.75);
  EXPECT_DOUBLE_EQ(paper["integrity"]["lost_share"], 0.25);
  EXPECT_TRUE(paper["handover_jump_p999_m"].is_null()) << "there was none";
  EXPECT_TRUE(paper["first_tread"]["y"]["rmse_m"].is_null());
  EXPECT_EQ(json["climbs"]["unfinished"][0]["seed"], 7);
  EXPECT_EQ(json["climbs"]["unfinished"][0]["end"], "held");
  EXPECT_NE(summary_table(report).find("held on step 3, integrity is LOST"), std::string::npos);
}

}  // namespace
}  // namespace stetro_bringup
