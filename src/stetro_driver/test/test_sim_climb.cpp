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

#include "buildings.hpp"
#include "pilot.hpp"

namespace stetro_driver
{
namespace
{

using test::kHalfPi;
using test::paper_stairs;
using test::perfect;
using test::Pilot;

bool both_switches(const SensorFrame & frame)
{
  return frame.contact(ContactPlace::kRiserLeft).closed &&
         frame.contact(ContactPlace::kRiserRight).closed;
}

/// Floor to tread 1 under block 1: what S-P calls step 1.
void approach(Pilot & pilot)
{
  ASSERT_TRUE(pilot.until(Pilot::twist(0.05, 0.0, 0.0), 20.0, [](const SensorFrame & f) {
    return f.range(RangePlace::kStairFront).range_m < 0.055;
  }));
  ASSERT_TRUE(pilot.lift(1));
  ASSERT_TRUE(pilot.until(Pilot::twist(0.05, 0.0, 0.0), 10.0, both_switches));
  ASSERT_TRUE(pilot.lower(1));
  pilot.roll(-0.02, 0.5);
}

/// One step up, open loop but for what ends each motion.
void climb(Pilot & pilot, bool riser_follows)
{
  const JointCommand forward = Pilot::twist(0.05, 0.0, 0.0);
  ASSERT_TRUE(pilot.lift(2));
  ASSERT_TRUE(pilot.until(forward, 6.0, [](const SensorFrame & f) {
    return f.range(RangePlace::kBlock3Front).range_m < 0.040;
  }));
  ASSERT_TRUE(pilot.lower(2));
  ASSERT_TRUE(pilot.lift(3));
  ASSERT_TRUE(pilot.lift(1));
  if (riser_follows) {
    ASSERT_TRUE(pilot.until(forward, 6.0, both_switches));
  } else {
    pilot.roll(0.05, 3.4);
    EXPECT_FALSE(both_switches(pilot.frame())) << "there is no riser to meet";
  }
  ASSERT_TRUE(pilot.lower(1));
  ASSERT_TRUE(pilot.lower(3));
  pilot.roll(-0.02, 0.5);
}

TEST(SimClimb, TwoStepsOpenLoop)
{
  SimRobot robot{paper_stairs(), {}, perfect()};
  Pilot pilot{robot};
  approach(pilot);
  EXPECT_EQ(robot.truth().step, 0);
  EXPECT_NEAR(robot.truth().x_m, -0.085, 0.002);
  climb(pilot, true);
  EXPECT_EQ(robot.truth().step, 1);
  EXPECT_NEAR(robot.truth().tread_x_m, 0.235, 0.002);
  EXPECT_NEAR(robot.truth().block_heights_m[0], 0.28, 1e-9);
  climb(pilot, true);
  EXPECT_EQ(robot.truth().step, 2);
  EXPECT_NEAR(robot.truth().tread_x_m, 0.235, 0.002);
  EXPECT_NEAR(robot.truth().z_m, 0.28, 1e-9);
  EXPECT_FALSE(robot.truth().fallen);
}

TEST(SimClimb, ToTheTop)
{
  SimRobot robot{paper_stairs(2), {}, perfect()};
  Pilot pilot{robot};
  approach(pilot);
  climb(pilot, true);
  climb(pilot, false);
  EXPECT_EQ(robot.truth().step, 2);
  EXPECT_FALSE(robot.truth().fallen);
  pilot.during({}, 0.2);
  EXPECT_EQ(pilot.frame().range(RangePlace::kStairFront).status, RangeStatus::kNoTarget);
  for (int block = 1; block <= 3; ++block) {
    EXPECT_NEAR(pilot.frame().block(block).height_m, 0.0, 1e-9) << "flush with the landing";
  }
}

// Ground floor, 16 steps, landing, 8 steps, first floor, each flight in its own frame.
TEST(SimClimb, ThroughABuilding)
{
  SimOptions options = perfect();
  options.start = SimStart{-1.0, 1.0, 0.0};
  SimRobot robot{test::two_floors(), {}, options};
  Pilot pilot{robot};
  const auto climb_flight = [&](int steps, const char * flight) {
    approach(pilot);
    for (int step = 1; step <= steps; ++step) {
      climb(pilot, step < steps);
      ASSERT_EQ(robot.truth().segment, flight);
      ASSERT_EQ(robot.truth().step, step);
      ASSERT_FALSE(robot.truth().fallen);
    }
  };
  climb_flight(16, "lower");
  pilot.roll(0.1, 10.0);
  EXPECT_EQ(robot.truth().segment, "landing");
  pilot.steer(test::kHalfPi);
  pilot.during(Pilot::twist(0.0, 0.1, 0.0), 25.0);
  pilot.during(Pilot::twist(0.0, 0.0, 0.1), 31.416);
  pilot.steer(0.0);
  climb_flight(8, "upper");
  pilot.roll(0.1, 5.0);
  const GroundTruth truth = robot.truth();
  EXPECT_EQ(truth.segment, "first");
  EXPECT_EQ(truth.z_m, 0.0);
  EXPECT_NEAR(truth.in_map.z_m, 3.36, 1e-9);
  EXPECT_NEAR(truth.in_map.x_m, 10.12 - 2.56 + 0.085 - 0.5, 0.01);
  EXPECT_NEAR(truth.in_map.y_m, 3.5, 0.01);
}

// With every error at its default, on stairs as built, from ten seeds.
TEST(SimClimb, TwoStepsWithAllErrors)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    SimOptions options;
    options.seed = seed;
    options.start = SimStart{-0.5, 1.0, 0.02};
    options.errors.tof_gain_std = 0.0;  // open loop: nobody calibrates the sensor under the edge
    options.errors.tof_offset_std_m = 0.0;
    options.errors.tof_white_std_m = 0.0;
    options.errors.tof_slow_std_m = 0.0;
    options.errors.tof_flicker_std_m = 0.0;
    SimRobot robot{paper_stairs(), {}, options};
    Pilot pilot{robot};
    approach(pilot);
    climb(pilot, true);
    climb(pilot, true);
    EXPECT_EQ(robot.truth().step, 2);
    EXPECT_FALSE(robot.truth().fallen);
    EXPECT_LT(std::abs(robot.truth().heading_rad), 0.02) << "the riser squared it";
  }
}

TEST(SimClimb, SweepsFromWallToWall)
{
  SimOptions options = perfect();
  options.start = SimStart{0.235, 1.025, 0.0};
  SimRobot robot{paper_stairs(), {}, options};
  Pilot pilot{robot};
  pilot.steer(kHalfPi);
  const auto bumps = [](ContactPlace place) {
    return [place](const SensorFrame & f) { return f.contact(place).closed; };
  };
  ASSERT_TRUE(pilot.until(Pilot::twist(0.0, 0.15, 0.0), 10.0, bumps(ContactPlace::kLeftMiddle)));
  EXPECT_NEAR(robot.truth().y_m, 2.05 - 0.115, 0.0016);  // one tick at 0.15 m/s
  EXPECT_NEAR(pilot.frame().range(RangePlace::kSideLeft).range_m, 0.066, 0.01);
  ASSERT_TRUE(pilot.until(Pilot::twist(0.0, -0.15, 0.0), 20.0, bumps(ContactPlace::kRightMiddle)));
  EXPECT_NEAR(robot.truth().y_m, 0.115, 0.0016);
  EXPECT_NEAR(pilot.frame().odometry.y_m, 0.115 - 1.025, 0.0016);
}

}  // namespace
}  // namespace stetro_driver
