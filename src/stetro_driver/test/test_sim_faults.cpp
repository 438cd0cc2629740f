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
#include <stdexcept>

#include "pilot.hpp"
#include "stetro_driver/sim_faults.hpp"

namespace stetro_driver
{
namespace
{

using test::paper_stairs;
using test::perfect;
using test::Pilot;

SimOptions with(const char * faults)
{
  SimOptions options = perfect();
  options.faults = parse_sim_faults(faults);
  return options;
}

TEST(SimFaults, ReadsTheGrammar)
{
  const auto faults = parse_sim_faults("dead:front_left@120, spike:gyro@3-5.5=0.4 ,kidnap@7=-0.5");
  ASSERT_EQ(faults.size(), 3u);
  EXPECT_EQ(faults[0].kind, SimFaultKind::kDead);
  EXPECT_EQ(faults[0].device, "front_left");
  EXPECT_EQ(faults[0].from_s, 120.0);
  EXPECT_TRUE(std::isinf(faults[0].until_s));
  EXPECT_EQ(faults[1].until_s, 5.5);
  EXPECT_EQ(faults[1].value, 0.4);
  EXPECT_EQ(faults[2].value, -0.5);
  EXPECT_TRUE(parse_sim_faults("  ").empty());
}

TEST(SimFaults, AKidnapMayBeOfOneFloor)
{
  const auto faults = parse_sim_faults("kidnap:landing@2.5,kidnap@7");
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_TRUE(faults[0].is_on_floor());
  EXPECT_EQ(faults[0].device, "landing");
  EXPECT_EQ(faults[0].from_s, 2.5);
  EXPECT_FALSE(faults[1].is_on_floor());
}

TEST(SimFaults, RefusesWhatItDoesNotKnowAndListsWhatItDoes)
{
  const char * const wrong[] = {
    "melt@3",
    "dead@3",
    "dead:front@3",
    "late:gyro@3",
    "late:side_left@3=0.7",
    "offset_jump:gyro@3",
    "gain_change:riser_left@3",
    "drift@3",
    "bias_jump:side_left@3",
    "slip",
    "slip@x",
    "slip@-1",
    "stuck:gyro@5-4",
    "spike:gyro@3=2",
    "estop@3=1",
    "dead:emergency_stop@3",
    "slip:gyro@3"};
  for (const char * text : wrong) {
    try {
      static_cast<void>(parse_sim_faults(text));
      FAIL() << text;
    } catch (const std::invalid_argument & error) {
      EXPECT_NE(std::string(error.what()).find("old_tread"), std::string::npos) << error.what();
    }
  }
}

TEST(SimFaults, ADeadSensorSaysNothing)
{
  SimRobot robot{paper_stairs(), {}, with("dead:side_left@0.5-1")};
  Pilot pilot{robot};
  pilot.during({}, 0.3);
  EXPECT_EQ(pilot.frame().range(RangePlace::kSideLeft).status, RangeStatus::kValid);
  pilot.during({}, 0.4);
  EXPECT_EQ(pilot.frame().range(RangePlace::kSideLeft).status, RangeStatus::kFault);
  EXPECT_TRUE(std::isnan(pilot.frame().range(RangePlace::kSideLeft).range_m));
  pilot.during({}, 0.5);
  EXPECT_EQ(pilot.frame().range(RangePlace::kSideLeft).status, RangeStatus::kValid) << "it is back";
}

TEST(SimFaults, AStuckSensorRepeatsItself)
{
  SimRobot robot{paper_stairs(), {}, with("stuck:stair_front@0.5")};
  Pilot pilot{robot};
  pilot.during({}, 0.5);
  const RangeReading before = pilot.frame().range(RangePlace::kStairFront);
  pilot.roll(0.05, 2.0);
  const RangeReading after = pilot.frame().range(RangePlace::kStairFront);
  EXPECT_EQ(after.range_m, before.range_m);
  EXPECT_GT(after.stamp, before.stamp) << "and looks fresh";
}

TEST(SimFaults, ALateSensorArrivesLate)
{
  SimRobot robot{paper_stairs(), {}, with("late:side_left@0=0.2")};
  Pilot pilot{robot};
  pilot.during({}, 1.0);
  const SensorFrame frame = pilot.frame();
  EXPECT_GE(frame.time - frame.range(RangePlace::kSideLeft).stamp, std::chrono::milliseconds{220});
  EXPECT_LE(frame.time - frame.range(RangePlace::kSideRight).stamp, std::chrono::milliseconds{60});
}

TEST(SimFaults, ASensorMayBeLateByMoreThanHalfASecond)
{
  SimRobot robot{paper_stairs(), {}, with("late:side_left@1=0.6")};
  Pilot pilot{robot};
  pilot.during({}, 2.0);
  const SensorFrame frame = pilot.frame();
  const auto age = frame.time - frame.range(RangePlace::kSideLeft).stamp;
  EXPECT_GE(age, std::chrono::milliseconds{620});
  EXPECT_LE(age, std::chrono::milliseconds{660}) << "one cycle more at most";
}

// The perfect side sensor reads the same at rest: what it reads more is the fault's.
TEST(SimFaults, OffsetGainAndDriftBendAReading)
{
  const auto reads_m = [](const char * faults, double at_s) {
    SimRobot robot{paper_stairs(), {}, with(faults)};
    Pilot pilot{robot};
    pilot.during({}, at_s);
    return pilot.frame().range(RangePlace::kSideLeft).range_m;
  };
  const double straight_m = reads_m("", 2.0);
  constexpr double kMillimetre = 0.001;  // readings come in whole ones
  EXPECT_NEAR(reads_m("offset_jump:side_left@1=0.05", 0.9), straight_m, 1e-9) << "not begun";
  EXPECT_NEAR(reads_m("offset_jump:side_left@1=0.05", 2.0), straight_m + 0.05, kMillimetre);
  EXPECT_NEAR(reads_m("offset_jump:side_left@1=-0.05", 2.0), straight_m - 0.05, kMillimetre);
  EXPECT_NEAR(reads_m("gain_change:side_left@1=0.1", 2.0), 1.1 * straight_m, kMillimetre);
  EXPECT_NEAR(reads_m("drift:side_left@1=0.02", 2.0), straight_m + 0.02, 2 * kMillimetre);
  EXPECT_NEAR(reads_m("drift:side_left@1=0.02", 3.0), straight_m + 0.04, 2 * kMillimetre);
}

TEST(SimFaults, ABentReadingBelowTheMinimumIsTooNear)
{
  SimRobot robot{
    paper_stairs(), {}, with("drift:stair_front@0.5=-0.05,offset_jump:stair_front@0.5=-0.3")};
  Pilot pilot{robot};
  pilot.during({}, 3.0);
  const RangeReading reading = pilot.frame().range(RangePlace::kStairFront);
  EXPECT_EQ(reading.status, RangeStatus::kTooNear);
  EXPECT_TRUE(std::isinf(reading.range_m));
  EXPECT_LT(reading.range_m, 0.0);
}

TEST(SimFaults, TheGyroscopesBiasJumps)
{
  SimRobot robot{paper_stairs(), {}, with("bias_jump:gyro@0.5-1=0.02")};
  Pilot pilot{robot};
  pilot.during({}, 0.4);
  EXPECT_EQ(pilot.frame().gyro.rate_rad_s[2], 0.0);
  pilot.during({}, 0.3);
  EXPECT_NEAR(pilot.frame().gyro.rate_rad_s[2], 0.02, 1e-12);
  EXPECT_EQ(pilot.frame().gyro.rate_rad_s[0], 0.0);
  pilot.during({}, 0.5);
  EXPECT_EQ(pilot.frame().gyro.rate_rad_s[2], 0.0) << "it is back";
}

TEST(SimFaults, ASlipOnDemandMovesTruthButNotOdometry)
{
  SimRobot robot{paper_stairs(), {}, with("slip@0.5=-0.02")};
  Pilot pilot{robot};
  pilot.roll(0.05, 2.0);
  EXPECT_NEAR(robot.truth().x_m, -0.5 + 0.1 - 0.02, 1e-9);
  EXPECT_NEAR(pilot.frame().odometry.x_m, 0.1, 1e-9);
}

TEST(SimFaults, AKidnapIsSeenByNoOdometryAndNoGyro)
{
  SimRobot robot{paper_stairs(), {}, with("kidnap@0.5=0.4")};
  Pilot pilot{robot};
  pilot.during({}, 1.0);
  EXPECT_NEAR(robot.truth().y_m, 1.425, 1e-9);
  EXPECT_EQ(pilot.frame().odometry.y_m, 0.0);
  EXPECT_EQ(pilot.frame().gyro.rate_rad_s[2], 0.0);
}

TEST(SimFaults, TheEmergencyStopLatches)
{
  SimRobot robot{paper_stairs(), {}, with("estop@0.5-1")};
  Pilot pilot{robot};
  pilot.roll(0.05, 2.0);
  EXPECT_NEAR(robot.truth().x_m, -0.475, 0.001);
  for (int tick = 0; tick < 100; ++tick) {
    robot.step();
  }
  EXPECT_FALSE(pilot.frame().contact(ContactPlace::kEmergencyStop).closed) << "the button is out";
  EXPECT_TRUE(pilot.frame().emergency_stop_latched);
  EXPECT_EQ(robot.write({})->kind, IoFaultKind::kEmergencyStop);
  robot.deactivate();
  EXPECT_THROW(robot.activate(), HardwareError) << "power alone resets nothing";
  robot.reset_emergency_stop();
  EXPECT_FALSE(pilot.frame().emergency_stop_latched);
  robot.activate();
  EXPECT_FALSE(robot.write({}));
}

TEST(SimFaults, APressedEmergencyStopCannotBeReset)
{
  SimRobot robot{paper_stairs(), {}, with("estop@0.5-1")};
  Pilot pilot{robot};
  pilot.roll(0.05, 2.0);
  robot.step();
  ASSERT_TRUE(pilot.frame().contact(ContactPlace::kEmergencyStop).closed);
  EXPECT_THROW(robot.reset_emergency_stop(), HardwareError);
  EXPECT_TRUE(pilot.frame().emergency_stop_latched);
}

/// Brings a robot on tread 1 to where block 2 hangs in front of tread 2.
void roll_block_two_over_the_next_tread(Pilot & pilot)
{
  ASSERT_TRUE(pilot.lift(2));
  pilot.roll(0.05, 3.4);
}

TEST(SimFaults, AMissedTouchdownShowsNoEvidence)
{
  SimOptions options = with("missed_touchdown@1");
  options.start = SimStart{0.235, 1.025, 0.0};
  SimRobot robot{paper_stairs(), {}, options};
  Pilot pilot{robot};
  roll_block_two_over_the_next_tread(pilot);
  EXPECT_FALSE(pilot.lower(2));
  EXPECT_EQ(robot.truth().step, 2) << "and yet it stands there";
  EXPECT_EQ(pilot.frame().block(2).load, 0.0);
}

TEST(SimFaults, ADoubledTouchdownShowsTwice)
{
  SimOptions options = with("double_touchdown@1");
  options.start = SimStart{0.235, 1.025, 0.0};
  SimRobot robot{paper_stairs(), {}, options};
  Pilot pilot{robot};
  roll_block_two_over_the_next_tread(pilot);
  ASSERT_TRUE(pilot.lower(2));
  const auto shows = [](bool locked) {
    return [locked](const SensorFrame & f) { return f.block(2).at_lower_lock == locked; };
  };
  EXPECT_TRUE(pilot.until({}, 1.0, shows(false)));
  EXPECT_TRUE(pilot.until({}, 1.0, shows(true)));
}

TEST(SimFaults, TheOldTreadIsMistakenForTheNewOne)
{
  SimOptions options = with("old_tread@1");
  options.start = SimStart{0.235, 1.025, 0.0};
  SimRobot robot{paper_stairs(), {}, options};
  Pilot pilot{robot};
  roll_block_two_over_the_next_tread(pilot);
  EXPECT_NEAR(pilot.frame().range(RangePlace::kBlock3Front).range_m, 0.035, 0.01);
  EXPECT_TRUE(pilot.lower(2));
  EXPECT_EQ(robot.truth().step, 1);
  EXPECT_NEAR(pilot.frame().block(2).height_m, 0.0, 1e-9) << "the heights tell";
  EXPECT_NEAR(pilot.frame().odometry.x_m, 0.17, 1e-9);
}

}  // namespace
}  // namespace stetro_driver
