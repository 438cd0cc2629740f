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
#include <sstream>
#include <string>

#include "nlohmann/json.hpp"
#include "stetro_bringup/summary.hpp"

namespace stetro_bringup
{

TEST(Summary, HasTheKeysThatScriptsRead)
{
  ClimbErrors errors;
  errors.y_error_m.add(0.03);
  const auto summary = nlohmann::json::parse(summary_json(ClimbOutcome{}, errors));
  for (const char * key :
       {"completed", "final_step", "integrity", "seed", "estimator", "y_rmse_m", "x_rmse_m",
        "heading_rmse_rad", "closure_error_mean_m", "closure_error_std_m", "wall_time_s",
        "faults"}) {
    EXPECT_TRUE(summary.contains(key)) << key;
  }
  EXPECT_NEAR(summary["y_rmse_m"].get<double>(), 0.03, 1e-12);
  EXPECT_TRUE(summary["x_rmse_m"].is_null()) << "nothing was measured, so nothing is claimed";
}

StaircaseFound two_steps()
{
  StaircaseFound staircase;
  staircase.steps = {
    {1, 0.321, 0.001, 2.051, 0.002}, {2, std::nan(""), std::nan(""), 2.052, 0.002}};
  staircase.largest_deviation_m = 0.002;
  staircase.largest_deviation_of = "width of step 2";
  return staircase;
}

std::string printed(const ClimbOutcome & outcome)
{
  std::ostringstream out;
  print_summary(out, outcome, ClimbErrors{});
  return out.str();
}

TEST(Summary, TellsTheStaircaseAsBuilt)
{
  ClimbOutcome outcome;
  outcome.staircase = two_steps();
  const auto json =
    nlohmann::json::parse(summary_json(outcome, ClimbErrors{}))["staircase_as_built"];
  EXPECT_EQ(json["treads_measured"], 1);
  EXPECT_NEAR(json["largest_deviation_m"].get<double>(), 0.002, 1e-12);
  ASSERT_EQ(json["steps"].size(), 2u);
  EXPECT_NEAR(json["steps"][0]["tread_sigma_m"].get<double>(), 0.001, 1e-12);
  EXPECT_TRUE(json["steps"][1]["tread_m"].is_null()) << "no riser ends the last tread";
  EXPECT_TRUE(json["deviations"].empty());
  EXPECT_NE(
    printed(outcome).find("1 treads measured, largest deviation 2.0 mm (width of step 2); as the "
                          "site file says"),
    std::string::npos)
    << printed(outcome);
}

TEST(Summary, WarnsOfAStepThatTheSiteFileHasWrong)
{
  ClimbOutcome outcome;
  outcome.staircase = two_steps();
  outcome.staircase.deviations = {{1, "tread", 0.361, 0.001, 0.32}};
  const auto json = nlohmann::json::parse(summary_json(outcome, ClimbErrors{}));
  const auto & one = json["staircase_as_built"]["deviations"][0];
  EXPECT_EQ(one["step"], 1);
  EXPECT_EQ(one["measure"], "tread");
  EXPECT_NEAR(one["site_m"].get<double>(), 0.32, 1e-12);
  const std::string text = printed(outcome);
  EXPECT_NE(
    text.find("tread of step 1 is 361.0 mm (sigma 1.0 mm), the site file says 320.0 mm"),
    std::string::npos)
    << text;
  EXPECT_EQ(text.find("as the site file says"), std::string::npos);
}

TEST(Summary, HasNoStaircaseWhereNoneWasMeasured)
{
  EXPECT_EQ(printed(ClimbOutcome{}).find("staircase"), std::string::npos);
}

TEST(Summary, TellsHandOversAndKidnaps)
{
  ClimbOutcome outcome;
  outcome.hand_overs = {{"lower", "landing", 400.0, 0.004, -0.01}};
  Kidnap noticed;
  noticed.segment = "landing";
  noticed.noticed_after_s = 2.5;
  outcome.kidnaps = {noticed};
  const auto json = nlohmann::json::parse(summary_json(outcome, ClimbErrors{}));
  EXPECT_EQ(json["hand_overs"][0]["to"], "landing");
  EXPECT_EQ(json["hand_overs"][0]["jump_m"], 0.004);
  EXPECT_EQ(json["kidnaps"][0]["noticed_after_s"], 2.5);
  EXPECT_TRUE(json["kidnaps"][0]["relocalised_after_s"].is_null());
  const std::string text = printed(outcome);
  EXPECT_NE(text.find("0.40 cm, -0.57 deg beyond the motion, lower to landing"), std::string::npos)
    << text;
  EXPECT_NE(text.find("noticed after 2.5 s of motion, NOT RELOCALISED"), std::string::npos) << text;
}

TEST(Summary, SaysWhatARunFallsShortOf)
{
  ClimbOutcome good;
  good.completed = true;
  good.final_segment = "first";
  good.final_step = 0;
  good.integrity = "OK";
  good.hand_overs = {{"lower", "landing", 400.0, 0.009, 0.0}};
  Kidnap kidnap;
  kidnap.segment = "landing";
  kidnap.noticed_after_s = 4.9;
  kidnap.relocalised_after_s = 30.0;
  good.kidnaps = {kidnap};
  good.kidnaps_asked = {"landing"};
  const Goal goal{"first", 0};
  EXPECT_TRUE(shortfalls(good, goal).empty());
  const auto only = [&goal](const ClimbOutcome & outcome) {
    const auto all = shortfalls(outcome, goal);
    return all.size() == 1u ? all[0] : std::to_string(all.size()) + " shortfalls";
  };
  auto outcome = good;
  outcome.hand_overs[0].jump_m = 0.011;
  EXPECT_EQ(only(outcome), "the pose jumps 1.10 cm from lower to landing");
  outcome = good;
  outcome.kidnaps[0].noticed_after_s = 5.1;
  EXPECT_EQ(only(outcome), "the kidnap on landing is noticed after 5.1 s of motion");
  outcome.kidnaps[0].noticed_after_s.reset();
  EXPECT_EQ(only(outcome), "the kidnap on landing is not noticed");
  outcome = good;
  outcome.kidnaps[0].relocalised_after_s.reset();
  EXPECT_EQ(only(outcome), "the robot is not found after the kidnap on landing");
  outcome = good;
  outcome.kidnaps_asked = {"landing", "first"};
  EXPECT_EQ(only(outcome), "no kidnap happened on first");
}

TEST(Summary, CountsARunOnlyAtItsGoalTrustedAndWithoutFault)
{
  ClimbOutcome good;
  good.completed = true;
  good.final_segment = "stairs";
  good.final_step = 16;
  good.integrity = "OK";
  const Goal top{"stairs", 16};
  EXPECT_TRUE(succeeded(good, top));
  EXPECT_FALSE(succeeded(good, {"stairs", 17}));
  EXPECT_FALSE(succeeded(good, {"upper", 16}));
  auto outcome = good;
  outcome.completed = false;
  EXPECT_FALSE(succeeded(outcome, top));
  outcome = good;
  outcome.integrity = "DEGRADED";
  EXPECT_FALSE(succeeded(outcome, top));
  outcome = good;
  outcome.faults = {"bumper stuck"};
  EXPECT_FALSE(succeeded(outcome, top));
}

}  // namespace stetro_bringup
