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
#include <limits>

#include "buildings.hpp"
#include "pilot.hpp"
#include "stetro_driver/sim_robot.hpp"

namespace stetro_driver
{
namespace
{

using test::perfect;
using test::Pilot;
using test::two_floors;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
// Of 720 beams, the first at -pi.
constexpr std::size_t kBehind = 0;
constexpr std::size_t kRight = 180;
constexpr std::size_t kAhead = 360;
constexpr std::size_t kAheadLeft = 450;
constexpr std::size_t kLeft = 540;

SimOptions scanning(double x_m, double y_m, double yaw_rad)
{
  SimOptions options = perfect();
  options.lidar = true;
  options.start = SimStart{x_m, y_m, yaw_rad};
  return options;
}

/// A room of 4 m by 3 m; its stairs begin 20 m away, out of sight.
BuildingShape room()
{
  BuildingShape building = building_of(test::paper_stairs());
  building.floors.resize(2);
  building.floors[0] = {"room", {}, true, {test::rectangle(-24.0, 0.0, -20.0, 3.0)}};
  building.floors[1] = {"above", {0.0, 0.0, 2.24, 0.0}, false, {}};
  building.flights[0].lower = 0;
  building.flights[0].upper = 1;
  return building;
}

/// The first scan of a robot that stands still.
std::vector<float> scan_of(SimRobot & robot)
{
  Pilot pilot{robot};
  EXPECT_TRUE(pilot.until({}, 0.2, [](const SensorFrame & f) { return f.scan_complete; }));
  return pilot.frame().scan->ranges_m;
}

std::vector<float> scan_of(const BuildingShape & building, const SimOptions & options)
{
  SimRobot robot{building, {}, options};
  return scan_of(robot);
}

TEST(SimLidar, MeasuresARoomByHand)
{
  const auto ranges = scan_of(room(), scanning(-23.0, 1.0, 0.0));
  ASSERT_EQ(ranges.size(), 720u);
  EXPECT_NEAR(ranges[kBehind], 1.0, 1e-6);
  EXPECT_NEAR(ranges[kRight], 1.0, 1e-6);
  EXPECT_NEAR(ranges[kAhead], 3.0, 1e-6);
  EXPECT_NEAR(ranges[kLeft], 2.0, 1e-6);
  EXPECT_NEAR(ranges[kAheadLeft], 2.0 * std::sqrt(2.0), 1e-6);
}

TEST(SimLidar, TurnsWithTheRobot)
{
  const auto ranges = scan_of(room(), scanning(-23.0, 1.0, test::kHalfPi));
  EXPECT_NEAR(ranges[kAhead], 2.0, 1e-6);
  EXPECT_NEAR(ranges[kLeft], 1.0, 1e-6);
  EXPECT_NEAR(ranges[kRight], 3.0, 1e-6);
}

TEST(SimLidar, SitsWhereTheRobotFileSays)
{
  BodyShape body;
  body.lidar.x_m = 0.1;
  body.lidar.yaw_rad = test::kHalfPi;
  body.lidar.beams = 8;
  SimRobot robot{room(), body, scanning(-23.0, 1.0, 0.0)};
  const auto ranges = scan_of(robot);
  ASSERT_EQ(ranges.size(), 8u);
  EXPECT_NEAR(ranges[4], 2.0, 1e-6) << "its x axis looks to the left";
  EXPECT_NEAR(ranges[2], 2.9, 1e-6) << "and its right is ahead";
}

TEST(SimLidar, SpeaksAsRep117)
{
  BodyShape body;
  body.lidar.min_range_m = 1.5;
  body.lidar.max_range_m = 2.5;
  SimRobot robot{room(), body, scanning(-23.0, 1.0, 0.0)};
  const auto ranges = scan_of(robot);
  EXPECT_EQ(ranges[kAhead], kInfinity) << "3 m is out of reach";
  EXPECT_EQ(ranges[kRight], -kInfinity) << "1 m is too near";
  EXPECT_NEAR(ranges[kLeft], 2.0, 1e-6);
}

TEST(SimLidar, LooksThroughTheMouthOfTheStairs)
{
  // 1 m off the wall and 2 m before the foot: up to what is drawn as the riser at its height.
  const auto ranges = scan_of(two_floors(), scanning(-2.0, 1.0, 0.0));
  EXPECT_NEAR(ranges[kAhead], 2.96, 1e-6);
  EXPECT_NEAR(ranges[kBehind], 3.0, 1e-6);
  EXPECT_NEAR(ranges[kRight], 1.0, 1e-6);
}

/// A lidar high enough to look over block 1 on the tread above.
BodyShape tall()
{
  BodyShape body;
  body.lidar.height_m = 0.60;
  return body;
}

TEST(SimLidar, SeesRisersAboveItsPlaneAndTheFloorBelow)
{
  // On tread 1, plane at 0.14 + 0.60: it passes riser 5 (0.70) and meets riser 6 at x 1.60.
  SimRobot robot{two_floors(), tall(), scanning(0.235, 1.0, 0.0)};
  const auto ranges = scan_of(robot);
  EXPECT_NEAR(ranges[kAhead], 1.365, 1e-6);
  EXPECT_NEAR(ranges[kRight], 1.0, 1e-6);
  EXPECT_NEAR(ranges[kLeft], 1.05, 1e-6);
  EXPECT_NEAR(ranges[kBehind], 5.235, 1e-6) << "the far wall of the ground floor";
}

TEST(SimLidar, SeesTheLandingOverTheLastSteps)
{
  // On tread 13, plane at 1.82 + 0.60: above the landing, whose far wall is at x 7.6.
  SimRobot robot{two_floors(), tall(), scanning(12 * 0.32 + 0.235, 1.0, 0.0)};
  const auto ranges = scan_of(robot);
  EXPECT_NEAR(ranges[kAhead], 7.6 - 4.075, 1e-6);
  EXPECT_NEAR(ranges[kBehind], 4.075, 1e-6) << "the wall above the foot of the stairs";
}

TEST(SimLidar, HasItsOwnBlockBeforeItOnTheStairs)
{
  // Block 1 on the tread above is 0.14 + 0.40 high, the plane 0.45.
  const auto ranges = scan_of(two_floors(), scanning(0.235, 1.0, 0.0));
  EXPECT_EQ(ranges[kAhead], -kInfinity);
  EXPECT_NEAR(ranges[kRight], 1.0, 1e-6);
}

TEST(SimLidar, SeesItsOwnLiftedBlock)
{
  SimRobot robot{room(), {}, scanning(-23.0, 1.0, 0.0)};
  Pilot pilot{robot};
  ASSERT_TRUE(pilot.lift(1));
  pilot.until({}, 0.2, [](const SensorFrame & f) { return f.scan_complete; });
  EXPECT_EQ(pilot.frame().scan->ranges_m[kAhead], -kInfinity) << "7.5 cm ahead";
  EXPECT_NEAR(pilot.frame().scan->ranges_m[kLeft], 2.0, 1e-6);
}

TEST(SimLidar, TurnsTenTimesASecondAndAllocatesOnce)
{
  SimRobot robot{room(), {}, scanning(-23.0, 1.0, 0.0)};
  Pilot pilot{robot};
  const float * storage = pilot.frame().scan->ranges_m.data();
  int scans = 0;
  pilot.until({}, 5.0, [&](const SensorFrame & frame) {
    if (frame.scan_complete) {
      ++scans;
      EXPECT_EQ(frame.scan->stamp, frame.time);
    }
    EXPECT_EQ(frame.scan->ranges_m.data(), storage);
    return false;
  });
  EXPECT_EQ(scans, 50);
}

TEST(SimLidar, IsNotThereUnlessWanted)
{
  SimRobot robot{room(), {}, [] {
                   SimOptions options = perfect();
                   options.start = SimStart{-23.0, 1.0, 0.0};
                   return options;
                 }()};
  Pilot pilot{robot};
  pilot.until({}, 0.5, [](const SensorFrame & frame) {
    EXPECT_EQ(frame.scan, nullptr);
    EXPECT_FALSE(frame.scan_complete);
    return false;
  });
}

TEST(SimLidar, OnStairsAloneSeesTheStairs)
{
  SimRobot robot{test::paper_stairs(), tall(), scanning(0.235, 1.025, 0.0)};
  const auto ranges = scan_of(robot);
  EXPECT_NEAR(ranges[kAhead], 1.365, 1e-6);
  EXPECT_NEAR(ranges[kLeft], 1.025, 1e-6);
  EXPECT_EQ(ranges[kBehind], kInfinity) << "nobody knows what is there";
}

TEST(SimLidar, HasTheNoiseAndTheLossesThatItIsGiven)
{
  SimOptions options = scanning(-23.0, 1.0, 0.0);
  options.errors.lidar_std_m = 0.01;
  options.errors.lidar_dropout_share = 0.03;
  SimRobot robot{room(), {}, options};
  Pilot pilot{robot};
  int beams = 0;
  int lost = 0;
  double squares = 0.0;
  pilot.until({}, 10.0, [&](const SensorFrame & frame) {
    if (frame.scan_complete) {
      for (const float range : frame.scan->ranges_m) {
        ++beams;
        lost += range == kInfinity ? 1 : 0;
      }
      const float right = frame.scan->ranges_m[kRight];
      squares += std::isinf(right) ? 1e-4 : (right - 1.0) * (right - 1.0);
    }
    return false;
  });
  EXPECT_EQ(beams, 72'000);
  EXPECT_NEAR(lost / 72'000.0, 0.03, 0.003);              // 5 standard deviations
  EXPECT_NEAR(std::sqrt(squares / 100.0), 0.01, 0.0035);  // 5 standard deviations
}

TEST(SimLidar, SeesBoxesAndPeopleThatTheDrawingDoesNotShow)
{
  SimOptions options = scanning(-2.0, 1.0, 0.0);
  const auto empty = scan_of(two_floors(), options);
  options.unmapped_boxes = 3;
  options.people = 2;
  const auto full = scan_of(two_floors(), options);
  int shorter = 0;
  for (std::size_t i = 0; i < empty.size(); ++i) {
    EXPECT_LE(full[i], empty[i]);
    shorter += full[i] < empty[i] - 0.05F ? 1 : 0;
  }
  EXPECT_GT(shorter, 20);
}

}  // namespace
}  // namespace stetro_driver
