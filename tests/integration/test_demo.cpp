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
// The main job, as a user starts it: sixteen steps of the papers' staircase, the world as built.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "nlohmann/json.hpp"
#include "stetro_tests/deadline.hpp"
#include "stetro_tests/demo_run.hpp"

namespace stetro_tests
{

class DemoSeed : public testing::TestWithParam<std::tuple<std::string, int>>
{
};

TEST_P(DemoSeed, ClimbsToStep16WithoutFault)
{
  const auto & [estimator, seed] = GetParam();
  DemoRun demo(
    {"--in-process", "--no-plots", "--estimator", estimator, "--seed", std::to_string(seed)});
  ASSERT_EQ(demo.wait(180s), 0) << demo.tail();
  const auto summary = nlohmann::json::parse(demo.file("summary.json"));
  EXPECT_EQ(summary["final_step"], 16);
  EXPECT_EQ(summary["integrity"], "OK");
  EXPECT_TRUE(summary["faults"].empty()) << summary["faults"];
  const bool fused = estimator == "fused";
  EXPECT_LT(summary["y_rmse_m"], fused ? 0.015 : 0.05) << "a climb that arrives by luck";
  EXPECT_LT(summary["heading_rmse_rad"], fused ? 0.01 : 0.035);
  const auto & staircase = summary["staircase_as_built"];
  EXPECT_EQ(staircase["treads_measured"], fused ? 15 : 0) << "the last one ends at no riser";
  EXPECT_TRUE(staircase["deviations"].empty()) << staircase["deviations"];
}

INSTANTIATE_TEST_SUITE_P(
  Ten, DemoSeed, testing::Combine(testing::Values("fused"), testing::Range(2001, 2011)));
INSTANTIATE_TEST_SUITE_P(
  Papers, DemoSeed, testing::Combine(testing::Values("paper"), testing::Range(2001, 2006)));

TEST(DemoOverDds, LeavesWhatTheReadmeSays)
{
  DemoRun demo({"--seed", "2011"});
  ASSERT_EQ(demo.wait(300s), 0) << demo.tail();
  const auto summary = nlohmann::json::parse(demo.file("summary.json"));
  EXPECT_EQ(summary["completed"], true);
  EXPECT_EQ(summary["final_step"], 16);
  EXPECT_EQ(summary["estimator"], "fused");
  EXPECT_EQ(summary["seed"], 2011);
  EXPECT_EQ(summary["staircase_as_built"]["steps"].size(), 16u) << "told over the wire";
  const std::string steps = demo.file("steps.csv");
  EXPECT_EQ(std::count(steps.begin(), steps.end(), '\n'), 17) << "a header and a row a step\n"
                                                              << steps;
  const std::string trace = demo.file("trace.csv");
  EXPECT_GT(std::count(trace.begin(), trace.end(), '\n'), 10000);
  for (const char * picture : {"ranges.svg", "path_2d.svg", "path_3d.svg", "heading.svg"}) {
    const std::string svg = demo.file(picture);
    EXPECT_NE(svg.find("</svg>"), std::string::npos) << picture << " is not whole";
    EXPECT_GT(svg.size(), 50000U) << picture << " shows next to nothing";
  }
}

TEST(DemoJourney, GoesFromFloorToFloorAndIsCarriedOffOnEach)
{
  DemoRun demo(
    {"--in-process", "--no-plots", "--site", "two_floors", "--faults", "kidnap", "--seed", "3"});
  ASSERT_EQ(demo.wait(480s), 0) << demo.tail();
  const auto summary = nlohmann::json::parse(demo.file("summary.json"));
  EXPECT_EQ(summary["final_segment"], "first");
  EXPECT_TRUE(summary["shortfalls"].empty()) << summary["shortfalls"];
  ASSERT_EQ(summary["kidnaps"].size(), 3u);
  for (const auto & kidnap : summary["kidnaps"]) {
    EXPECT_LE(kidnap["noticed_after_s"], 5.0) << kidnap;
    EXPECT_FALSE(kidnap["relocalised_after_s"].is_null()) << kidnap;
  }
  EXPECT_EQ(summary["hand_overs"].size(), 4u) << summary["hand_overs"];
  for (const auto & passing : summary["hand_overs"]) {
    EXPECT_LE(passing["jump_m"], 0.01) << passing;
  }
  const std::string checks = demo.file("checks.csv");
  EXPECT_GT(std::count(checks.begin(), checks.end(), '\n'), 50) << checks;
}

}  // namespace stetro_tests
