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
#include <string>

#include "support/bias_named.hpp"
#include "support/two_floors.hpp"

namespace stetro_localizer
{
namespace
{

// The hand-over itself: estimators side by side, no sample between.
class CrossingTest : public testing::TestWithParam<const char *>
{
protected:
  CrossingTest() : site(two_floors()), floor(LocalizerParams{}, site) {}

  void expect_same_place(const SegmentEstimator & before, const SegmentEstimator & after)
  {
    const stetro_site::Pose a = in_map(before);
    const stetro_site::Pose b = in_map(after);
    EXPECT_NEAR(a.x_m, b.x_m, 1e-12);
    EXPECT_NEAR(a.y_m, b.y_m, 1e-12);
    EXPECT_NEAR(a.z_m, b.z_m, 1e-12);
    EXPECT_NEAR(std::remainder(a.yaw_rad - b.yaw_rad, 2.0 * M_PI), 0.0, 1e-12);
    const auto doubt = [](const SegmentEstimator & one) {
      return one.segment().T_map_segment.to_map(one.estimate().covariance);
    };
    for (const int i : {0, 1, 5}) {
      for (const int j : {0, 1, 5}) {
        EXPECT_NEAR(doubt(before)(i, j), doubt(after)(i, j), 1e-15) << i << ", " << j;
      }
    }
    EXPECT_EQ(before.estimate().stamp, after.estimate().stamp);
    EXPECT_EQ(before.estimate().reset_counter, after.estimate().reset_counter);
    EXPECT_NEAR(bias_named(before, "gyro").value, bias_named(after, "gyro").value, 1e-15);
    EXPECT_NEAR(bias_named(before, "gyro").variance, bias_named(after, "gyro").variance, 1e-18);
  }

  stetro_site::Site site;
  FloorEstimator floor;
};

TEST_P(CrossingTest, ThePoseInMapGoesOnAtBothEnds)
{
  const stetro_site::Flight & flight = site.flight(GetParam());
  const auto fused = make_estimator(LocalizerParams{}, stetro_site::RobotGeometry{}, flight);
  const bool first = flight.id() == "lower";

  // On the floor below, having driven: everything depends on everything.
  floor.choose(first ? 0 : 1);
  floor.begin({});
  LevelRobot robot(floor);
  robot.gyro_bias_radps = 0.002;
  robot.drive(0.2, 0.0);
  const stetro_site::Pose foot =
    flight.T_map_flight().to_map(stetro_site::Pose{-1.2, 0.9, 0.004, 0.05});
  stetro_site::Covariance told = stetro_site::Covariance::Zero();
  told.diagonal() << 9e-4, 4e-4, 1e-6, 1e-4, 1e-4, 4e-4;
  ASSERT_FALSE(floor.tell_pose(floor.segment().T_map_segment.to_frame(foot), told));
  robot.drive(2.0, 0.15, 0.0);
  LastSamples last;
  for (int i = 5; i >= 0; --i) {
    last.note(LevelRobot::level(robot.now - i * std::chrono::milliseconds(33)));
  }
  last.note(OdometrySample{robot.now, 0.15, 0.0, 0.0});
  last.note(GyroSample{robot.now, 0.002});

  const auto up = floor.leave();
  ASSERT_TRUE(up);
  fused->enter(*up, last);
  EXPECT_EQ(fused->estimate().step, 0);
  EXPECT_NEAR(fused->estimate().pose.x_m, -0.9, 0.01) << "by hand: -1.2 + 0.3";
  expect_same_place(floor, *fused);

  // And back again.
  FloorEstimator back(LocalizerParams{}, site);
  back.choose(first ? 0 : 1);
  const auto down = fused->leave();
  ASSERT_TRUE(down);
  back.enter(*down, last);
  expect_same_place(*fused, back);
  expect_same_place(floor, back);
}

TEST_P(CrossingTest, TheTopIsTheFloorAbove)
{
  const stetro_site::Flight & flight = site.flight(GetParam());
  const auto fused = make_estimator(LocalizerParams{}, stetro_site::RobotGeometry{}, flight);
  fused->begin({});
  LevelRobot robot(*fused);
  robot.drive(0.3, 0.0);
  stetro_site::Covariance told = stetro_site::Covariance::Zero();
  told.diagonal() << 9e-4, 4e-4, 1e-6, 1e-4, 1e-4, 4e-4;
  ASSERT_FALSE(
    fused->tell_pose({flight.total_run_m() - 0.085, 1.2, flight.total_rise_m(), -0.04}, told));
  robot.drive(0.8, 0.05);
  floor.choose(flight.id() == "lower" ? 1 : 2);
  const auto up = fused->leave();
  ASSERT_TRUE(up);
  floor.enter(*up, {});
  expect_same_place(*fused, floor);
  EXPECT_NE(floor.estimate().integrity, Integrity::kLost);
}

// Upper's foot is (10.12, 4.6), facing -x: 0.5 m before it and 1 m from its right wall is
// (10.62, 3.6) in map. The landing, at (1, 2) and turned by a quarter, has that at (1.6, -9.62),
// and +y there is -x in map.
TEST_P(CrossingTest, FramesByHand)
{
  Crossing crossing;
  crossing.time = std::chrono::seconds(1000);
  crossing.pose = {10.62, 3.6, 2.24, M_PI};
  crossing.state << 10.62, 3.6, M_PI, 0.001, 0.01;
  crossing.covariance.diagonal() << 4e-4, 1e-4, 1e-4, 1e-8, 1e-4;
  floor.choose(1);
  floor.enter(crossing, {});
  EXPECT_NEAR(floor.estimate().pose.x_m, 1.6, 1e-12);
  EXPECT_NEAR(floor.estimate().pose.y_m, -9.62, 1e-12);
  EXPECT_NEAR(floor.estimate().pose.yaw_rad, M_PI / 2.0, 1e-12);
  EXPECT_NEAR(floor.estimate().covariance(0, 0), 1e-4, 1e-15) << "map's x is the floor's -y";
  EXPECT_NEAR(floor.estimate().covariance(1, 1), 4e-4, 1e-15);
  const auto fused =
    make_estimator(LocalizerParams{}, stetro_site::RobotGeometry{}, site.flight("upper"));
  fused->enter(*floor.leave(), {});
  EXPECT_NEAR(fused->estimate().pose.x_m, -0.5, 1e-12);
  EXPECT_NEAR(fused->estimate().pose.y_m, 1.0, 1e-12);
  EXPECT_NEAR(fused->estimate().pose.yaw_rad, 0.0, 1e-12);
  EXPECT_NEAR(fused->estimate().covariance(0, 0), 4e-4, 1e-15);
}

// The papers' estimator has no filter: position and heading go on, and so do their variances.
TEST_P(CrossingTest, ThePapersEstimatorBeginsWhereTheFloorEnds)
{
  LocalizerParams params;
  params.estimator = "paper";
  const stetro_site::Flight & flight = site.flight(GetParam());
  const auto paper = make_estimator(params, stetro_site::RobotGeometry{}, flight);
  Crossing crossing;
  crossing.time = std::chrono::seconds(1000);
  crossing.pose = flight.T_map_flight().to_map(stetro_site::Pose{-0.5, 1.2, 0.0, 0.1});
  crossing.state << crossing.pose.x_m, crossing.pose.y_m, crossing.pose.yaw_rad, 0.001, 0.01;
  crossing.covariance.diagonal() << 4e-4, 1e-4, 9e-5, 1e-8, 1e-4;
  crossing.legacy.reset_counter = 7;
  paper->enter(crossing, {});
  const StairEstimate & estimate = paper->estimate();
  EXPECT_EQ(estimate.step, 0);
  EXPECT_NEAR(estimate.pose.x_m, -0.5, 1e-12);
  EXPECT_NEAR(estimate.pose.y_m, 1.2, 1e-12);
  EXPECT_NEAR(estimate.pose.yaw_rad, 0.1, 1e-12);
  EXPECT_NEAR(estimate.covariance(5, 5), 9e-5, 1e-12);
  EXPECT_EQ(estimate.reset_counter, 7u);
}

INSTANTIATE_TEST_SUITE_P(BothFlights, CrossingTest, testing::Values("lower", "upper"));

}  // namespace
}  // namespace stetro_localizer
