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

#include <filesystem>
#include <fstream>
#include <string>

#include "accuracy/accuracy_report.hpp"
#include "accuracy/campaign.hpp"
#include "accuracy/closed_loop.hpp"
#include "nlohmann/json.hpp"

namespace stetro_bringup
{
namespace
{

/// Three steps of the papers' staircase: a climb of some 170 s.
class ClosedLoopTest : public testing::Test
{
protected:
  static RobotSetup three_steps()
  {
    const auto folder = std::filesystem::path(testing::TempDir());
    const std::string site = folder / "test_closed_loop_site.yaml";
    std::ofstream(site) << R"(name: three_steps
floors:
  - {id: ground, elevation_m: 0.0}
  - {id: landing, elevation_m: 0.42}
flights:
  - id: stairs
    joins: [ground, landing]
    steps: 3
    riser_m: 0.14
    tread_m: 0.32
    width_m: 2.05
    sides: {right: walled, left: walled}
    wall_overrun_m: 1.0
    pose: {x_m: 0.0, y_m: 0.0, z_m: 0.0, yaw_rad: 0.0}
)";
    return read_robot_setup({site, STETRO_ROBOT_FILE});
  }

  const RobotSetup setup_ = three_steps();

  std::string summary_of(unsigned jobs, const std::string & faults) const
  {
    std::vector<ClimbOrder> orders(3);
    for (std::size_t i = 0; i < orders.size(); ++i) {
      orders[i].seed = 1 + i;
      orders[i].faults = faults;
    }
    AccuracyReport report{3, 1,         "as-built",        "factory", "stairs",
                          3, {"paper"}, {"overall", 3, 1}, {}};
    run_campaign(setup_, orders, jobs, [&](const ClimbOrder & order, const ClimbRecord & record) {
      EXPECT_EQ(order.seed, record.seed);
      report.overall.add(record);
    });
    return summary_json(report);
  }
};

TEST_F(ClosedLoopTest, ClimbsToTheTop)
{
  const ClimbRecord record = climb(setup_, ClimbOrder{});
  ASSERT_EQ(record.end, ClimbEnd::kFinished) << to_string(record.end) << ": " << record.detail;
  EXPECT_EQ(record.last_step, 3);
  const ClimbScore & score = record.scores.front();
  EXPECT_GT(score.samples.size(), 2000u) << "30 a second for some 50 s a tread";
  EXPECT_EQ(score.treads, 3u);
  EXPECT_EQ(score.steps.checks, 3u) << "block 2 is lifted on the floor, on tread 1 and on tread 2";
  EXPECT_EQ(score.steps.undetected, 0u);
  EXPECT_EQ(score.closures_m.size(), 2u);
  EXPECT_EQ(score.first_closures_m.size(), 1u);
  EXPECT_EQ(score.out_of_truth, 0u);
  EXPECT_TRUE(score.samples.front().first_tread);
  EXPECT_FALSE(score.samples.back().first_tread);
  EXPECT_LT(score.longest_confirmation_s, 0.5);
}

TEST_F(ClosedLoopTest, TheSameSeedsGiveTheSameBytesOnAnyNumberOfThreads)
{
  const std::string once = summary_of(1, "");
  EXPECT_EQ(once, summary_of(2, ""));
  const auto json = nlohmann::json::parse(once);
  EXPECT_EQ(json["climbs"]["finished"], 3);
  EXPECT_GT(json["paper"]["samples"], 6000);
  EXPECT_GT(json["paper"]["y"]["rmse_m"], 0.0);
  EXPECT_GE(json["paper"]["y"]["p999_m"], json["paper"]["y"]["p95_m"]);
  EXPECT_EQ(json["paper"]["undetected_step_errors"], 0);
  EXPECT_TRUE(json["paper"]["protection"]["across_median_m"].is_null()) << "the papers give none";
}

// A climb that ends before the top is no error of the tool, and is told with its reason.
TEST_F(ClosedLoopTest, AClimbThatStopsIsReported)
{
  const auto json = nlohmann::json::parse(summary_of(1, "estop@40"));
  EXPECT_EQ(json["climbs"]["finished"], 0);
  ASSERT_EQ(json["climbs"]["unfinished"].size(), 3u);
  EXPECT_EQ(json["climbs"]["unfinished"][0]["end"], "fault");
  EXPECT_NE(
    json["climbs"]["unfinished"][0]["detail"].get<std::string>().find("emergency_stop"),
    std::string::npos);
}

TEST_F(ClosedLoopTest, AListenerDoesNotChangeTheClimb)
{
  ClimbOrder alone;
  ClimbOrder heard;
  heard.estimators = {"paper", "paper"};
  const ClimbRecord a = climb(setup_, alone);
  const ClimbRecord b = climb(setup_, heard);
  ASSERT_EQ(b.scores.size(), 2u);
  EXPECT_EQ(a.simulated_s, b.simulated_s);
  ASSERT_EQ(a.scores[0].samples.size(), b.scores[1].samples.size());
  EXPECT_EQ(a.scores[0].samples.back().errors.y_m, b.scores[1].samples.back().errors.y_m);
}

// A dead side sensor is noticed only beyond the reach of the other one: after some way.
TEST_F(ClosedLoopTest, AFaultIsTimedFromItsOnset)
{
  ClimbOrder order;
  order.faults = "dead:side_left@100,dead:side_right@100";
  order.onset = FaultOnset{100.0, TellingMotion::kAny};
  const ClimbRecord record = climb(setup_, order);
  ASSERT_TRUE(record.scores.front().detection);
  const Detection & detection = *record.scores.front().detection;
  EXPECT_TRUE(detection.struck);
  EXPECT_TRUE(detection.detected);
  EXPECT_LE(detection.motion_s, 1.0);
  EXPECT_LE(detection.motion_s, detection.time_s);
}

TEST_F(ClosedLoopTest, AnEstimatorThatDoesNotExistIsRefused)
{
  ClimbOrder order;
  order.estimators = {"guessed"};
  EXPECT_THROW(static_cast<void>(climb(setup_, order)), std::invalid_argument);
  EXPECT_THROW(
    run_campaign(setup_, {order}, 2, [](const ClimbOrder &, const ClimbRecord &) {}),
    std::invalid_argument);
}

}  // namespace
}  // namespace stetro_bringup
