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
// Every printed fault of Pseudocode 2 (S-P), by its number in D3.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "stetro_supervisor/mission.hpp"
#include "support/toy_robot.hpp"

namespace stetro_supervisor
{

class PseudocodeFaults : public testing::Test
{
protected:
  void start()
  {
    climb.tick(robot.now, robot.look());
    const auto answer = mission.request({"1", "test", RequestKind::kCleanFlight, "flight"});
    ASSERT_TRUE(answer.accepted) << answer.reason;
  }

  void run_to(State state, int step)
  {
    start();
    const auto there = [&] { return climb.state() == state && climb.record().step == step; };
    ASSERT_TRUE(run_until(climb, robot, 600.0, there)) << where(climb, robot);
  }

  void expect_fault(Fault fault, double within_s = 200.0)
  {
    EXPECT_TRUE(run_to_state(climb, robot, State::kFault, within_s)) << where(climb, robot);
    EXPECT_EQ(climb.fault(), fault) << where(climb, robot);
  }

  static void set(Observation & o, Place place, RangeStatus status, double range_m = 0.0)
  {
    o.ranges[static_cast<std::size_t>(place)]->status = status;
    o.ranges[static_cast<std::size_t>(place)]->range_m = range_m;
  }

  ToyRobot robot{stairs(3)};
  Climb climb{ClimbParams{}, stairs(3)};
  Mission mission{climb, flight_of(climb.geometry())};
};

TEST_F(PseudocodeFaults, D3_1_CorrectsBelowMinusThreeDegreesToo)
{
  start();
  for (const State leg : {State::kSweepLeft, State::kSweepRight}) {
    ASSERT_TRUE(run_to_state(climb, robot, leg)) << where(climb, robot);
    robot.heading_rad = -4.0 * kRadPerDeg;
    EXPECT_GT(climb.tick(robot.now, robot.look()).wz_rps, 0.0) << to_string(leg);
  }
}

TEST_F(PseudocodeFaults, D3_2_LowersBlock1UntilItTouchesNotWhile)
{
  run_to(State::kLowerBlock1, 1);
  const double before = robot.z_m[0];
  EXPECT_EQ(climb.tick(robot.now, robot.look()).kind, MotionCommand::Kind::kLower);
  ASSERT_TRUE(run_to_state(climb, robot, State::kLowerBlock3, 10.0)) << where(climb, robot);
  EXPECT_NEAR(robot.z_m[0], before - 0.04, 1e-3) << "18 cm above tread 1, 14 cm risers";
}

TEST_F(PseudocodeFaults, D3_3_LowersBlock2UntilItTouchesNotWhile)
{
  run_to(State::kLowerBlock2, 0);
  ASSERT_TRUE(run_to_state(climb, robot, State::kConfirmStep, 10.0)) << where(climb, robot);
  EXPECT_NEAR(robot.z_m[1], 0.14, 1e-6);
}

TEST_F(PseudocodeFaults, D3_4_StopsForBothSwitchesAndRealignsWhenOneIsMissing)
{
  run_to(State::kRollToRiser, 1);
  robot.pivots = false;
  robot.heading_rad = 1.5 * kRadPerDeg;
  ASSERT_TRUE(run_to_state(climb, robot, State::kRealignBackOff, 30.0)) << where(climb, robot);
  ASSERT_TRUE(run_to_state(climb, robot, State::kLowerBlock1, 120.0)) << where(climb, robot);
  EXPECT_LT(std::abs(robot.heading_rad), 0.5 * kRadPerDeg) << "both switches: square";
}

TEST_F(PseudocodeFaults, D3_4_OneSwitchThatNeverClosesIsAFault)
{
  run_to(State::kRollToRiser, 1);
  robot.meddle = [](Observation & o) { o.contacts->riser_left.state = ContactState::kOpen; };
  expect_fault(Fault::kSkewed, 300.0);
}

TEST_F(PseudocodeFaults, D3_5_LowersBlock3ByItsOwnEvidence)
{
  run_to(State::kLowerBlock3, 1);
  EXPECT_NEAR(robot.z_m[2], 0.14 + 0.04, 1e-3) << "hangs 4 cm over the tread, as printed";
  ASSERT_TRUE(run_to_state(climb, robot, State::kBackOff, 10.0)) << where(climb, robot);
  EXPECT_NEAR(robot.z_m[2], 0.14, 1e-6);
}

TEST_F(PseudocodeFaults, D3_5_ABlock3ThatBearsNothingIsNotDown)
{
  run_to(State::kLowerBlock3, 1);
  robot.meddle = [](Observation & o) { o.blocks->block[2].load = 0.0; };
  expect_fault(Fault::kTouchDownUnconfirmed);
}

TEST_F(PseudocodeFaults, D3_6_ThresholdsAreMetres)
{
  const ClimbParams params;  // 5 mm, 1 cm, 18 cm and 1.5 m as printed, or what sensors resolve
  EXPECT_DOUBLE_EQ(params.touch_down_gap_m, 0.01);
  EXPECT_DOUBLE_EQ(params.block3_gap_m, 0.005);
  EXPECT_LE(params.stair_seen_m, 1.2);
}

TEST_F(PseudocodeFaults, D3_7_ARangeAloneDoesNotConfirmATouchDown)
{
  run_to(State::kLowerBlock1, 1);
  robot.meddle = [](Observation & o) { set(o, Place::kBlock1Down, RangeStatus::kTooNear); };
  const double load_comes_s = 0.5;
  EXPECT_FALSE(run_to_state(climb, robot, State::kLowerBlock3, load_comes_s))
    << "the sensor says contact, but nothing bears yet";
  EXPECT_TRUE(run_to_state(climb, robot, State::kLowerBlock3, 10.0)) << where(climb, robot);
}

TEST_F(PseudocodeFaults, D3_7_ABlock1ThatBearsNothingIsNotDownHoweverLongItRests)
{
  run_to(State::kLowerBlock1, 1);
  robot.meddle = [](Observation & o) { o.blocks->block[0].load = 0.0; };
  EXPECT_FALSE(run_to_state(climb, robot, State::kLowerBlock3, 3.0 * climb.params().stall_s))
    << "at rest close above the tread, but block 2 carries the robot alone";
  expect_fault(Fault::kTouchDownUnconfirmed);
}

TEST_F(PseudocodeFaults, D3_7_ABlock1OfUnknownLoadIsDownWhenItRests)
{
  run_to(State::kLowerBlock1, 1);
  robot.meddle = [](Observation & o) {
    o.blocks->block[0].load = kNan;
    set(o, Place::kBlock1Down, RangeStatus::kValid, 0.035 + 0.015);  // biased by 1.5 cm
  };
  EXPECT_TRUE(run_to_state(climb, robot, State::kLowerBlock3, 8.0)) << where(climb, robot);
}

TEST_F(PseudocodeFaults, D3_7_Block2IsNotLiftedWhileAnotherBlockBearsNothing)
{
  run_to(State::kSquare, 1);
  robot.meddle = [](Observation & o) { o.blocks->block[0].load = 0.0; };
  EXPECT_FALSE(run_to_state(climb, robot, State::kLiftBlock2, 20.0)) << "block 3 stood alone then";
  EXPECT_EQ(climb.fault(), Fault::kTouchDownUnconfirmed) << where(climb, robot);
}

TEST_F(PseudocodeFaults, D3_8_AFreeFrontBelowTheTopIsNotTheEnd)
{
  run_to(State::kSweepToMiddle, 1);
  robot.meddle = [](Observation & o) {
    for (const Place place : {Place::kStairFront, Place::kFrontLeft, Place::kFrontRight}) {
      set(o, place, RangeStatus::kNoTarget);
    }
  };
  expect_fault(Fault::kRiserMissing);
}

TEST_F(PseudocodeFaults, D3_8_ADeadSensorOnTheTopIsNotTheEnd)
{
  run_to(State::kSweepToMiddle, 3);
  robot.meddle = [](Observation & o) { set(o, Place::kStairFront, RangeStatus::kFault); };
  expect_fault(Fault::kTopBlocked);
}

TEST_F(PseudocodeFaults, D3_8_APersonOnTheLandingIsNoRiserAndNotTheEnd)
{
  run_to(State::kSweepToMiddle, 3);
  robot.meddle = [](Observation & o) { set(o, Place::kStairFront, RangeStatus::kValid, 0.3); };
  expect_fault(Fault::kTopBlocked);
  EXPECT_EQ(climb.record().step, 3);
}

TEST_F(PseudocodeFaults, D3_9_ApproachesFromFartherThanTheSensorsReach)
{
  robot.x_m = -2.0;
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kApproach, 60.0)) << where(climb, robot);
  ASSERT_TRUE(run_to_state(climb, robot, State::kLiftBlock1, 80.0)) << where(climb, robot);
}

TEST_F(PseudocodeFaults, D3_10_TurningWithoutSeeingStairsEndsInAFault)
{
  robot.heading_rad = 3.0;
  start();
  robot.meddle = [](Observation & o) {
    set(o, Place::kStairFront, RangeStatus::kNoTarget);
    o.pose->heading_rad = 3.0;
  };
  expect_fault(Fault::kStairNotFound);
}

TEST_F(PseudocodeFaults, D3_11_TurnsByTheBodyNotByTheTravel)
{
  run_to(State::kSweepRight, 1);
  robot.heading_rad = 4.0 * kRadPerDeg;
  const MotionCommand command = climb.tick(robot.now, robot.look());
  EXPECT_LT(command.wz_rps, 0.0);
  EXPECT_LT(command.vy_mps, 0.0);
}

TEST_F(PseudocodeFaults, D3_12_LeavesTheWallByYNotByTime)
{
  run_to(State::kSquare, 1);
  EXPECT_NEAR(robot.y_m, 2.05 / 2.0, climb.params().middle_tolerance_m + 0.005);
}

TEST_F(PseudocodeFaults, D3_13_AnyBumperIsAContact)
{
  run_to(State::kSweepLeft, 1);
  robot.heading_rad = 1.0 * kRadPerDeg;  // one corner touches first
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepRight, 60.0)) << where(climb, robot);
  EXPECT_GT(robot.y_m, 1.8);
}

TEST_F(PseudocodeFaults, D3_13_ABumperClosedAtTheStartIsAFault)
{
  run_to(State::kSteerAcross, 1);
  robot.meddle = [](Observation & o) { o.contacts->left[1].state = ContactState::kClosed; };
  expect_fault(Fault::kBumperStuck, 5.0);
}

TEST_F(PseudocodeFaults, D3_13_NoContactWithinTheWidthIsAFault)
{
  run_to(State::kSweepLeft, 1);
  const auto spin = std::make_shared<double>(0.0);
  robot.meddle = [spin](Observation & o) {  // the wheels turn, the bumpers are dead
    for (Contact & contact : o.contacts->left) {
      contact.state = ContactState::kOpen;
    }
    *spin += 0.0075;
    o.odometry->y_m += *spin;
  };
  expect_fault(Fault::kNoWallContact);
}

TEST_F(PseudocodeFaults, D3_14_CountsAStepOnlyWhenTheLocalizerAgrees)
{
  run_to(State::kLowerBlock2, 0);
  robot.counts = false;  // the localizer misses it, and misses it when it is shown again
  expect_fault(Fault::kStepContradiction);
  EXPECT_EQ(climb.record().step, 0);
}

TEST_F(PseudocodeFaults, D3_14_AStepTheBodyDidNotTakeStopsTheClimb)
{
  run_to(State::kSweepLeft, 1);
  robot.meddle = [](Observation & o) { o.pose->step = 2; };
  expect_fault(Fault::kStepContradiction, 1.0);
}

TEST_F(PseudocodeFaults, D3_14_ATouchDownOnTheOldTreadIsNoStep)
{
  run_to(State::kLowerBlock2, 0);
  robot.x_m -= 0.16;  // slipped back: block 2 is over the floor again
  ASSERT_TRUE(run_to_state(climb, robot, State::kLiftBlock2, 20.0)) << where(climb, robot);
  EXPECT_EQ(climb.record().step, 0);
  EXPECT_TRUE(run_to_state(climb, robot, State::kConfirmStep, 60.0)) << "lifted again, rolled on";
}

// The other half of D3-15, the restart of the process, is tested in test_rejoin.cpp.
TEST_F(PseudocodeFaults, D3_15_AMissionCanBePausedResumedAndAborted)
{
  run_to(State::kLiftBlock2, 1);
  EXPECT_TRUE(mission.request({"2", "test", RequestKind::kPause, ""}).accepted);
  EXPECT_TRUE(run_to_state(climb, robot, State::kPaused, 1.0));
  EXPECT_TRUE(mission.request({"3", "test", RequestKind::kResume, ""}).accepted);
  EXPECT_TRUE(run_to_state(climb, robot, State::kLiftBlock2, 5.0)) << where(climb, robot);
  EXPECT_TRUE(mission.request({"4", "test", RequestKind::kAbort, ""}).accepted);
  EXPECT_TRUE(run_to_state(climb, robot, State::kAborted, 1.0));
}

TEST_F(PseudocodeFaults, D3_16_Block1StandsOneStepAheadWhileSweeping)
{
  run_to(State::kSweepLeft, 1);
  EXPECT_NEAR(robot.z_m[0], 2 * 0.14, 1e-6);
  EXPECT_NEAR(robot.z_m[1], 1 * 0.14, 1e-6);
  EXPECT_NEAR(robot.z_m[2], 1 * 0.14, 1e-6);
}

}  // namespace stetro_supervisor
