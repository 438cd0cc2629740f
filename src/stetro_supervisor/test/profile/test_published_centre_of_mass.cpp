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

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "stetro_supervisor/profile/published_centre_of_mass.hpp"
#include "support/wall_caster.hpp"

namespace stetro_supervisor
{
namespace
{

using Eigen::Vector2d;

// The example of S-C: a room with its centre of mass at (50, 50), the supervisor's scanner at
// (10, 20), the robot's at (20, 60). The paper gives no unit.
const Vector2d kExpected(10.0, 20.0);
const Vector2d kRobot(20.0, 60.0);
constexpr double kReach = 300.0;

std::vector<stetro_site::Segment> room() { return rectangle({0.0, 0.0}, {100.0, 100.0}); }

Beams scanned(const WallCaster & world, const ScannerPose & pose)
{
  RangeProfile scan;
  scan.fan = {0.0, 6.283185307179586 / 720.0, 720};
  world.cast(pose.position_m, {pose.yaw_rad, scan.fan.step_rad, 720}, kReach, scan.ranges_m);
  return Beams(scan);
}

Vector2d centroid_from(const WallCaster & world, const ScannerPose & pose)
{
  const Beams scan = scanned(world, pose);
  return moments_of(scan, scan.ranges_m())->centroid_m;
}

TEST(PublishedCentreOfMass, Equation8FindsTheRobotInOneStep)
{
  const WallCaster world(room());
  const Vector2d model = centroid_from(world, {kExpected, 0.0});
  EXPECT_NEAR(model.x(), 39.99, 0.02) << "the paper's x_CS";
  EXPECT_NEAR(model.y(), 29.99, 0.02) << "the paper's y_CS";
  const Vector2d robot = centroid_from(world, {kRobot, 0.0});
  EXPECT_NEAR(robot.x(), 29.95, 0.1) << "the paper's x_CR, 29.25 in its equation (D5-1)";
  EXPECT_NEAR(robot.y(), -10.05, 0.1) << "the paper's y_CR";
  const Vector2d found = corrected_position({kExpected, 0.0}, model, robot);
  EXPECT_NEAR(found.x(), 20.0, 0.1);
  EXPECT_NEAR(found.y(), 60.0, 0.1);
}

TEST(PublishedCentreOfMass, Equation9IsWrongWhenTheRobotIsTurned)
{
  const WallCaster world(room());
  const Vector2d robot = centroid_from(world, {kRobot, 1.0});
  EXPECT_NEAR(robot.x(), 7.70, 0.1);
  EXPECT_NEAR(robot.y(), -30.66, 0.1);
  const Vector2d found =
    corrected_position({kExpected, 0.0}, centroid_from(world, {kExpected, 0.0}), robot);
  EXPECT_NEAR(found.x(), 42.29, 0.15) << "the paper's wrong answer";
  EXPECT_NEAR(found.y(), 80.65, 0.15);
}

TEST(PublishedCentreOfMass, Equation10TurnedTheRightWayFindsTheRobot)
{
  const WallCaster world(room());
  const ScannerPose expected{kExpected, 1.0};  // the model is scanned at the robot's heading
  const Vector2d found = corrected_position(
    expected, centroid_from(world, expected), centroid_from(world, {kRobot, 1.0}));
  EXPECT_NEAR(found.x(), 20.0, 0.1);
  EXPECT_NEAR(found.y(), 60.0, 0.1);
}

TEST(PublishedCentreOfMass, Equation10AsPrintedTurnsTheWrongWay)
{
  const Vector2d robot(7.70, -30.66);  // eq. (9)
  const double length = robot.norm();
  const double angle = std::atan(robot.y() / robot.x());
  const Vector2d printed(length * std::cos(angle - 1.0), length * std::sin(angle - 1.0));
  const Vector2d model(39.99, 29.99);
  const Vector2d found = model - printed + kExpected;
  EXPECT_NEAR(found.x(), 71.6, 0.1) << "not 20 (D5-4)";
  EXPECT_NEAR(found.y(), 73.0, 0.1) << "not 60";
}

TEST(PublishedCentreOfMass, Equation11ConvergesBesideAnObstacle)
{
  auto walls = room();
  const auto box = rectangle({55.0, 35.0}, {65.0, 45.0});
  walls.insert(walls.end(), box.begin(), box.end());
  const WallCaster world(walls);
  PublishedLimits limits;
  limits.reach_m = kReach;
  const auto search =
    published_search(world, scanned(world, {kRobot, 0.0}), {kExpected, 0.0}, limits);
  ASSERT_GE(search.positions_m.size(), 2u);
  EXPECT_TRUE(search.settled);
  const double first = (search.positions_m.front() - kRobot).norm();
  EXPECT_GT(first, 0.5) << "the obstacle hides other parts of the room from either scanner";
  EXPECT_LT(first, 8.0);
  const std::size_t fourth = std::min<std::size_t>(4, search.positions_m.size()) - 1;
  EXPECT_LT((search.positions_m[fourth] - kRobot).norm(), 0.35) << "the paper's fourth: 0.28";
  EXPECT_LT((search.positions_m.back() - kRobot).norm(), 0.01);
}

TEST(PublishedCentreOfMass, ScannerAndHeadingOfTheRoomDoNotMatter)
{
  // The room and both scanners turned by 0.6 rad about the origin: the answer turns with them.
  const Eigen::Matrix2d turn = rotation(0.6);
  std::vector<stetro_site::Segment> turned;
  for (const auto & wall : room()) {
    turned.push_back({turn * wall.from_m, turn * wall.to_m});
  }
  const WallCaster world(turned);
  PublishedLimits limits;
  limits.reach_m = kReach;
  const ScannerPose robot{turn * kRobot, 0.6 + 1.0};
  const auto search =
    published_search(world, scanned(world, robot), {turn * kExpected, 0.6 + 1.0}, limits);
  ASSERT_FALSE(search.positions_m.empty());
  EXPECT_LT((search.positions_m.back() - turn * kRobot).norm(), 0.01);
}

TEST(PublishedCentreOfMass, GivesUpWhereTheMapHasNoProfile)
{
  const WallCaster nothing({});
  const WallCaster world(room());
  const auto search =
    published_search(nothing, scanned(world, {kRobot, 0.0}), {kExpected, 0.0}, PublishedLimits{});
  EXPECT_TRUE(search.positions_m.empty());
  EXPECT_FALSE(search.settled);
}

}  // namespace
}  // namespace stetro_supervisor
