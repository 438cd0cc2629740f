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
#include "nlohmann/json.hpp"

namespace stetro_bringup
{
namespace
{

constexpr int kSteps = 4;

AccuracyReport report_of(const ClimbScore & score, const std::string & scenario)
{
  ClimbRecord record;
  record.scores = {score};
  AccuracyReport report{1, 7, "site", "none", "stairs", kSteps, {"paper"}, {"", kSteps, 1}, {}};
  report.overall.add(record);
  if (!scenario.empty()) {
    report.scenarios.emplace_back(scenario, kSteps, 1);
    report.scenarios.back().add(record);
  }
  return report;
}

TEST(AccuracyJson, NestsItsKeysAndBoundsItsRates)
{
  ClimbRecord record;
  record.seed = 7;
  record.end = ClimbEnd::kHeld;
  record.detail = "integrity is LOST";
  record.last_step = 3;
  record.scores.resize(1);
  ClimbScore & score = record.scores.front();
  ScoredEstimate sample;
  sample.step = 2;
  sample.errors.y_m = 0.003;
  sample.nees = 3.0;
  score.samples = {sample};
  score.closures_m = {0.002, 0.004};
  score.steps.checks = 10;
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

// Garwood for 2 in 100, from chi-square tables: 0.2422 and 7.2247 expected; one-sided 6.2958.
TEST(AccuracyJson, BoundsTheFalseAlarmsAStep)
{
  ClimbScore score;
  score.alarms = 2;
  score.steps.on_stairs = 100;
  const AccuracyReport report = report_of(score, "");
  const auto json = nlohmann::json::parse(summary_json(report));
  const auto & alarms = json["paper"]["false_alarms"];
  EXPECT_EQ(alarms["times"], 2);
  EXPECT_EQ(alarms["steps"], 100);
  EXPECT_DOUBLE_EQ(alarms["per_step"], 0.02);
  EXPECT_NEAR(alarms["low_95"], 0.002422, 1e-6);
  EXPECT_NEAR(alarms["high_95"], 0.072247, 1e-6);
  EXPECT_NEAR(alarms["at_most_95"], 0.062958, 1e-6);
  EXPECT_NE(
    summary_table(report).find("false alarms after the first tread: 2 in 100 steps"),
    std::string::npos);
}

TEST(AccuracyJson, NoAlarmIsFalseWhereFaultsWereInjected)
{
  ClimbScore score;
  score.alarms = 2;
  score.steps.on_stairs = 100;
  const auto json = nlohmann::json::parse(summary_json(report_of(score, "dead")));
  EXPECT_FALSE(json["paper"].contains("false_alarms"));
  EXPECT_FALSE(json["faults"]["dead"]["paper"].contains("false_alarms"));
}

// Struck on the last tick of a climb, there is no estimate left to score.
TEST(AccuracyJson, BoundsTheMissedFaultsOfAScenario)
{
  ClimbScore score;
  score.detection = Detection{};
  score.detection->struck = true;
  AccuracyReport report = report_of(score, "stuck");
  score.detection->never_ok = true;
  ClimbRecord blind;
  blind.scores = {score};
  report.scenarios.back().add(blind);
  const auto json = nlohmann::json::parse(summary_json(report));
  const auto & detection = json["faults"]["stuck"]["paper"]["detection"];
  EXPECT_EQ(detection["struck"], 2);
  EXPECT_EQ(detection["never_ok_again"], 1);
  EXPECT_EQ(detection["missed"]["count"], 1);
  EXPECT_EQ(detection["missed"]["of"], 1);
  EXPECT_NEAR(detection["missed"]["low_95"], 0.025, 1e-9);
  EXPECT_EQ(detection["missed"]["high_95"], 1.0);
  EXPECT_EQ(detection["within_1_s_of_telling_motion"]["count"], 0);
}

TEST(AccuracyJson, TellsWhenMiscountsWereNoticed)
{
  ClimbScore score;
  score.steps.checks = 60;
  score.steps.wrong = 3;
  score.steps.undetected = 1;
  score.steps.miscounts = {
    {0, MiscountEnd::kNoticed}, {1, MiscountEnd::kNoticed}, {0, MiscountEnd::kCorrected}};
  const auto json = nlohmann::json::parse(summary_json(report_of(score, "steps")));
  const auto & errors = json["faults"]["steps"]["paper"]["step_errors"];
  EXPECT_EQ(errors["undetected"]["count"], 1);
  EXPECT_NEAR(errors["undetected"]["low_95"], 1.0 - std::pow(0.975, 1.0 / 60.0), 1e-9);
  const auto & miscounts = errors["miscounts"];
  EXPECT_EQ(miscounts["began"], 3);
  EXPECT_EQ(miscounts["noticed_before_next_climb"]["count"], 1);
  EXPECT_EQ(miscounts["noticed_within_one_step"]["count"], 2);
  EXPECT_EQ(miscounts["noticed_within_one_step"]["of"], 3);
  EXPECT_EQ(miscounts["noticed_by_climbs_begun"], (std::vector<int>{1, 1}));
  EXPECT_EQ(miscounts["corrected_unnoticed"], 1);
  EXPECT_EQ(miscounts["never_noticed"], 0);
}

// 0.05^(1/n): the claim that a clean campaign makes.
TEST(AccuracyJson, OneSidedBoundsAreWhatACleanCampaignClaims)
{
  ClimbScore score;
  score.steps.checks = 30'000;
  const auto json = nlohmann::json::parse(summary_json(report_of(score, "")));
  const auto & undetected = json["paper"]["step_errors"]["undetected"];
  EXPECT_NEAR(undetected["at_most_95"], 1.0 - std::pow(0.05, 1.0 / 30'000), 1e-12);
  EXPECT_LT(undetected["at_most_95"], 1e-4);
  EXPECT_NEAR(undetected["high_95"], 1.0 - std::pow(0.025, 1.0 / 30'000), 1e-12);
  EXPECT_GT(undetected["high_95"], 1e-4);
}

// -ln 0.05 = 2.99573: without any in 29 958 treads the risk is below 1e-4, with 29 957 it is not.
TEST(AccuracyJson, ClaimsNoRiskThatTheStepsDoNotCarry)
{
  const auto shown = [](std::uint64_t treads, std::uint64_t misled) {
    ClimbScore score;
    ScoredEstimate sample;
    sample.step = 2;
    sample.protection = {0.01, 0.01, 0.01};
    score.samples = {sample};
    score.stated_risk = 1e-4;
    score.treads = treads;
    score.treads_exceeded = misled + 3;
    score.treads_misled = misled;
    const AccuracyReport report = report_of(score, "");
    const bool doubted = summary_table(report).find("do not show") != std::string::npos;
    auto integrity = nlohmann::json::parse(summary_json(report))["paper"]["integrity"];
    EXPECT_EQ(doubted, !integrity["risk"]["carried"].get<bool>());
    return integrity;
  };
  const auto few = shown(800, 0);
  EXPECT_EQ(few["treads_beyond_protection_while_ok"]["times"], 3);
  EXPECT_EQ(few["treads_beyond_protection_while_ok"]["steps"], 800);
  EXPECT_EQ(few["treads_beyond_protection_for_1_s"]["times"], 0);
  EXPECT_EQ(few["risk"]["stated"], 1e-4);
  EXPECT_NEAR(few["risk"]["at_most_95"], 2.99573 / 800, 1e-8);
  EXPECT_EQ(few["risk"]["clean_steps_needed"], 29958);
  EXPECT_FALSE(few["risk"]["carried"]);
  EXPECT_FALSE(shown(29'957, 0)["risk"]["carried"]);
  EXPECT_TRUE(shown(29'958, 0)["risk"]["carried"]);
  EXPECT_FALSE(shown(29'958, 1)["risk"]["carried"]);
}

}  // namespace
}  // namespace stetro_bringup
