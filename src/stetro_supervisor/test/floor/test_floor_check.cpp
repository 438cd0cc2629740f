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

#include <optional>
#include <string>
#include <vector>

#include "stetro_site/frame_transform.hpp"
#include "stetro_supervisor/floor/floor_check.hpp"
#include "support/lidar_in_two_floors.hpp"

namespace stetro_supervisor
{

class FloorCheckTest : public LidarInTwoFloors
{
protected:
  /// A tick with a scan of a moment ago, and wheels that stand still.
  void tick(std::size_t floor, const FloorPlace & truth)
  {
    now += kTick;
    Observation seen;
    seen.odometry = OdometryPose{now, 0.0, 0.0, 0.0};
    if (scans_arrive) {
      auto scan = scan_at(floor, truth, crowd);
      scan->time = now - kTick;
      seen.scan = scan;
    }
    for (auto & range : seen.ranges) {
      range = Range{now, 0.5, RangeStatus::kValid, now};
    }
    CheckContext context;
    context.lost = true;
    context.lost_on = lost_on;
    check.tick(now, seen, context);
  }

  /// Two ticks: how fast the robot turned is known of a scan that lies between them.
  void begin_search(std::size_t floor, const FloorPlace & truth)
  {
    tick(floor, truth);
    tick(floor, truth);
  }

  /// The first report, or nothing after so many ticks.
  std::optional<CheckReport> report_within(int ticks, std::size_t floor, const FloorPlace & truth)
  {
    for (int i = 0; i < ticks && !check.report(); ++i) {
      tick(floor, truth);
    }
    return check.report();
  }

  static stetro_site::RobotGeometry robot_with(const stetro_site::Lidar & lidar)
  {
    stetro_site::RobotGeometry robot;
    robot.lidar = lidar;
    return robot;
  }

  static constexpr Time kTick = std::chrono::milliseconds{100};  // half the usual rate
  std::vector<const DrawnFloor *> all{floors[0].get(), floors[1].get(), floors[2].get()};
  stetro_site::RobotGeometry robot = robot_with(lidar);
  FloorCheck check{all, robot, params};
  Time now = std::chrono::seconds{1000};
  bool scans_arrive = true;
  std::vector<stetro_site::Segment> crowd;
  std::string lost_on;  // empty: it has never known
};

// The localizer takes no correction that is older than its window, 2 s, and a search on three
// floors takes longer at this rate.
TEST_F(FloorCheckTest, TellsWhereTheRobotIsAsOfNow)
{
  const FloorPlace truth{"landing", {11.2, 1.3}, 2.1, Eigen::Matrix3d::Zero()};
  const Time began = now;
  const auto report = report_within(200, 1, truth);
  ASSERT_TRUE(report && report->correction) << (report ? report->reason : "no report");
  EXPECT_GT(seconds_between(began, now), 2.0) << "no slower search than the window: no test";
  EXPECT_LE(seconds_between(report->correction->time, now), 0.2);
  EXPECT_EQ(report->floor_id, "landing");
  EXPECT_LT((report->correction->place.position_m - truth.position_m).norm(), 0.02);
}

TEST_F(FloorCheckTest, TellsNothingOfARobotThatWasCarriedOnMeanwhile)
{
  const FloorPlace first{"landing", {11.2, 1.3}, 2.1, Eigen::Matrix3d::Zero()};
  const FloorPlace then{"ground", {1.2, 1.3}, 2.1, Eigen::Matrix3d::Zero()};
  begin_search(1, first);
  const auto report = report_within(200, 0, then);
  ASSERT_TRUE(report);
  EXPECT_FALSE(report->correction);
  EXPECT_EQ(report->verdict, Verdict::kNoVerdict);
  EXPECT_NE(report->reason.find("newest scan"), std::string::npos) << report->reason;
}

TEST_F(FloorCheckTest, LooksOnTheOtherFloorsForARobotThatIsNotWhereItWas)
{
  lost_on = "ground";
  const FloorPlace truth{"landing", {11.2, 1.3}, 2.1, Eigen::Matrix3d::Zero()};
  begin_search(1, truth);
  const auto own = report_within(400, 1, truth);
  ASSERT_TRUE(own);
  EXPECT_FALSE(own->correction);
  EXPECT_EQ(own->verdict, Verdict::kNoVerdict) << own->reason;
  tick(1, truth);
  const auto others = report_within(400, 1, truth);
  ASSERT_TRUE(others && others->correction) << (others ? others->reason : "no report");
  EXPECT_EQ(others->correction->place.floor_id, "landing");
  EXPECT_NE(others->reason.find("on 'landing'"), std::string::npos) << others->reason;
  const Time found = now;
  tick(1, truth);
  const auto again = report_within(400, 1, truth);
  ASSERT_TRUE(again && again->correction) << "the localizer wants several that agree";
  EXPECT_EQ(again->correction->place.floor_id, "landing");
  EXPECT_LT(seconds_between(found, now), 2.0) << "of that floor alone";
}

// In a crowd no place explains the scan, on no floor: its own is looked at again.
TEST_F(FloorCheckTest, ComesBackToTheFloorWhereItWas)
{
  lost_on = "ground";
  const FloorPlace truth{"ground", {1.5, 2.4}, -0.7, Eigen::Matrix3d::Zero()};
  crowd = rectangle({1.2, 2.1}, {1.8, 2.7});
  begin_search(0, truth);
  for (int search = 0; search < 2; ++search) {
    const auto report = report_within(400, 0, truth);
    ASSERT_TRUE(report) << search;
    EXPECT_FALSE(report->correction) << search;
    tick(0, truth);
  }
  crowd.clear();
  const auto report = report_within(400, 0, truth);
  ASSERT_TRUE(report && report->correction) << (report ? report->reason : "no report");
  EXPECT_EQ(report->correction->place.floor_id, "ground");
}

// Two cupboards of the map have gone, and beams pass where it has walls.
TEST_F(FloorCheckTest, BearsThePoseOutOnAFloorThatHasChanged)
{
  stetro_site::SiteSpec spec;
  spec.name = "furnished";
  auto walls = std::get<stetro_site::PolygonWalls>(floors[0]->floor().drawing);
  walls.obstacles.push_back({{3.6, 2.6}, {4.6, 2.6}, {4.6, 3.4}, {3.6, 3.4}});
  walls.obstacles.push_back({{0.3, 1.8}, {0.7, 1.8}, {0.7, 2.8}, {0.3, 2.8}});
  spec.floors.push_back({"ground", {}, walls});
  const DrawnFloor mapped{stetro_site::Site{spec}, "ground", params.resolution_m};
  FloorCheck one{{&mapped}, robot, params};
  const FloorPlace truth{"ground", {1.8, 0.9}, 0.7, Eigen::Matrix3d::Zero()};
  FloorPlace told = truth;
  told.position_m.x() += 0.04;
  told.covariance.diagonal() << 4e-4, 4e-4, 1e-4;
  one.request();
  for (int i = 0; i < 4 && !one.report(); ++i) {
    now += kTick;
    Observation seen;
    seen.odometry = OdometryPose{now, 0.0, 0.0, 0.0};
    seen.pose = StairPose{};
    seen.pose->time = now;
    auto scan = scan_at(0, truth);
    scan->time = now - kTick;
    seen.scan = scan;
    CheckContext context;
    context.told = told;
    context.corrigible = true;
    one.tick(now, seen, context);
  }
  ASSERT_TRUE(one.report());
  const CheckReport & report = *one.report();
  ASSERT_TRUE(report.testimony.finding.by_ends) << report.reason;
  EXPECT_EQ(report.verdict, Verdict::kAgrees) << report.reason;
  ASSERT_TRUE(report.correction);
  EXPECT_LT((report.correction->place.position_m - truth.position_m).norm(), 0.05);
}

// The ranges say 0.5 m on four sides: many places do.
TEST_F(FloorCheckTest, SaysWhatTheRangesTellWithoutALidar)
{
  scans_arrive = false;
  const FloorPlace nowhere{"ground", {1.0, 1.0}, 0.0, Eigen::Matrix3d::Zero()};
  const Time began = now;
  const auto report = report_within(600, 0, nowhere);
  ASSERT_TRUE(report);
  EXPECT_GT(seconds_between(began, now), 3.0) << "a lidar may be late";
  EXPECT_FALSE(report->correction);
  EXPECT_NE(report->reason.find("4 ranges without a lidar"), std::string::npos) << report->reason;
}

TEST_F(FloorCheckTest, WaitsForAScanThatBearsItsAnswerOut)
{
  const FloorPlace truth{"landing", {11.6, 3.1}, -1.0, Eigen::Matrix3d::Zero()};
  begin_search(1, truth);
  scans_arrive = false;
  EXPECT_FALSE(report_within(200, 1, truth));
  scans_arrive = true;
  const auto report = report_within(3, 1, truth);
  ASSERT_TRUE(report && report->correction) << (report ? report->reason : "no report");
  EXPECT_LE(seconds_between(report->correction->time, now), 0.2);
}

}  // namespace stetro_supervisor
