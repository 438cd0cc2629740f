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
// Range sensors that were never calibrated: what they alone disagree with, and what they cannot.

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

#include "stetro_supervisor/mission.hpp"
#include "stetro_supervisor/rejoin.hpp"
#include "support/toy_robot.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kLong_m = 0.028;     // 2.8 standard deviations of an uncalibrated offset
constexpr double kTooLong_m = 0.045;  // no offset: something keeps the block away

}  // namespace

class UncalibratedRanges : public testing::Test
{
protected:
  void run_to(State state, int step)
  {
    climb.tick(robot.now, robot.look());
    const auto answer = mission.request({"1", "test", RequestKind::kCleanFlight, "flight"});
    ASSERT_TRUE(answer.accepted) << answer.reason;
    const auto there = [&] { return climb.state() == state && climb.record().step == step; };
    ASSERT_TRUE(run_until(climb, robot, 600.0, there)) << where(climb, robot);
  }

  void reads_long(std::initializer_list<Place> places, double by_m)
  {
    const std::vector<Place> sensors{places};
    robot.meddle = [sensors, by_m](Observation & o) {
      for (const Place place : sensors) {
        o.ranges[stetro_site::index_of(place)]->range_m += by_m;
        o.ranges[stetro_site::index_of(place)]->status = RangeStatus::kValid;
      }
    };
  }

  void expect_fault(Fault fault)
  {
    EXPECT_TRUE(run_to_state(climb, robot, State::kFault, 200.0)) << where(climb, robot);
    EXPECT_EQ(climb.fault(), fault) << where(climb, robot);
  }

  ToyRobot robot{stairs(2)};
  Climb climb{ClimbParams{}, stairs(2)};
  Mission mission{climb, flight_of(climb.geometry())};
};

TEST_F(UncalibratedRanges, DoubtIsThreeAndAHalfDeviationsOfOffsetGainAndNoise)
{
  // 3.5 sqrt(10^2 + (0.03 * 35)^2 + 2.1^2) mm, by hand
  const ClimbGeometry geometry = stairs(2);
  EXPECT_NEAR(geometry.contact_doubt_m(Place::kBlock3Front, ClimbParams{}), 0.03595, 1e-5);
}

TEST_F(UncalibratedRanges, Block3ThatPushesIsAtTheRiserThoughItsSensorReadsLong)
{
  run_to(State::kRollBlock3ToRiser, 0);
  robot.spins = true;
  reads_long({Place::kBlock3Front}, kLong_m);
  ASSERT_TRUE(run_to_state(climb, robot, State::kLowerBlock2, 20.0)) << where(climb, robot);
  EXPECT_NEAR(robot.x_m, 0.075, 0.001) << "block 3's face on riser 1";
  EXPECT_TRUE(run_to_state(climb, robot, State::kLiftBlock3, 20.0)) << where(climb, robot);
}

TEST_F(UncalibratedRanges, AReadingBeyondTheDoubtIsNoContactHoweverLongBlock3Pushes)
{
  run_to(State::kRollBlock3ToRiser, 0);
  robot.spins = true;
  reads_long({Place::kBlock3Front}, kTooLong_m);
  expect_fault(Fault::kRiserMissing);
}

/// A sensor of block 3 that says too early that it has arrived, and a pose that knows better.
class DeceivedBlock3 : public UncalibratedRanges
{
protected:
  void deceive(double from_x_m, double pose_long_by_m)
  {
    robot.meddle = [this, from_x_m, pose_long_by_m](Observation & o) {
      o.pose->x_m = robot.x_m + pose_long_by_m;
      o.pose->protection_along_m = 0.01;
      if (robot.x_m > from_x_m && !robot_told_) {
        o.ranges[stetro_site::index_of(Place::kBlock3Front)]->range_m = 0.035;
      }
    };
  }

  bool robot_told_ = false;
};

TEST_F(DeceivedBlock3, DoesNotLowerBlock2OverTheEdge)
{
  run_to(State::kRollBlock3ToRiser, 0);
  deceive(-0.03, 0.0);
  expect_fault(Fault::kStepContradiction);
  EXPECT_GT(robot.z_m[1], 0.15) << "block 2 is still up";
}

TEST_F(DeceivedBlock3, LandsOnTheOldTreadAndTriesAgainFromFurtherBack)
{
  run_to(State::kRollBlock3ToRiser, 0);
  deceive(-1.0, 0.0);
  ASSERT_TRUE(run_to_state(climb, robot, State::kLowerBlock2, 20.0)) << where(climb, robot);
  EXPECT_LT(robot.x_m, -0.055);
  ASSERT_TRUE(run_to_state(climb, robot, State::kLiftBlock2, 20.0)) << where(climb, robot);
  robot_told_ = true;
  ASSERT_TRUE(run_to_state(climb, robot, State::kLowerBlock2, 20.0)) << where(climb, robot);
  EXPECT_NEAR(robot.x_m, 0.075, 0.01);
}

TEST_F(DeceivedBlock3, IsBelievedWhenThePoseMayBeAsFar)
{
  run_to(State::kRollBlock3ToRiser, 0);
  deceive(-0.03, 0.07);
  EXPECT_TRUE(run_to_state(climb, robot, State::kLowerBlock2, 20.0)) << where(climb, robot);
}

TEST_F(UncalibratedRanges, StandingStillInDoubtIsNoPush)
{
  run_to(State::kRollBlock3ToRiser, 0);
  reads_long({Place::kBlock3Front}, kLong_m);  // the wheels do not turn against the riser
  expect_fault(Fault::kRollTimeout);
}

TEST_F(UncalibratedRanges, ASensorStuckAtWhatItReadBehindBlock2IsNoWitnessOfAPush)
{
  run_to(State::kLiftBlock2, 0);
  robot.meddle = [](Observation & o) {
    o.ranges[stetro_site::index_of(Place::kBlock3Front)]->range_m = 0.035 + kLong_m;
    o.ranges[stetro_site::index_of(Place::kBlock3Front)]->status = RangeStatus::kValid;
  };
  robot.spins = true;
  expect_fault(Fault::kRiserMissing);
}

TEST_F(UncalibratedRanges, Block1ThatPushesIsAtTheRiserThoughTheFrontReadsLong)
{
  run_to(State::kApproach, 0);
  robot.spins = true;
  reads_long({Place::kFrontLeft, Place::kFrontRight, Place::kStairFront}, kLong_m);
  ASSERT_TRUE(run_to_state(climb, robot, State::kLiftBlock1, 60.0)) << where(climb, robot);
  EXPECT_NEAR(robot.x_m, -0.225, 0.001) << "block 1's face on riser 1";
}

TEST_F(UncalibratedRanges, ABlockThatBearsIsDownThoughTheRangeBelowItReadsLong)
{
  run_to(State::kLowerBlock1, 0);
  reads_long({Place::kBlock1Down, Place::kBlock2Down}, kLong_m);
  ASSERT_TRUE(run_to_state(climb, robot, State::kBackOff, 8.0)) << where(climb, robot);
  EXPECT_NEAR(robot.z_m[0], 0.14, 1e-6);
  ASSERT_TRUE(run_to_state(climb, robot, State::kConfirmStep, 60.0)) << where(climb, robot);
  EXPECT_NEAR(robot.z_m[1], 0.14, 1e-6);
}

TEST_F(UncalibratedRanges, WithoutKnownLoadAReadingThatLongIsNoTouchDown)
{
  run_to(State::kLowerBlock1, 0);
  reads_long({Place::kBlock1Down}, kLong_m);
  const auto longer = robot.meddle;
  robot.meddle = [longer](Observation & o) {
    longer(o);
    o.blocks->block[0].load = kNan;
  };
  expect_fault(Fault::kTouchDownUnconfirmed);
}

TEST_F(UncalibratedRanges, ABlockThatBearsFarAboveTheTreadBelowItsSensorIsNotDown)
{
  run_to(State::kLowerBlock1, 0);
  reads_long({Place::kBlock1Down}, kTooLong_m);  // its edge hangs on something
  expect_fault(Fault::kTouchDownUnconfirmed);
}

TEST_F(UncalibratedRanges, ABlock2ThatBearsIsFoundDownAgainAfterAStop)
{
  run_to(State::kConfirmStep, 0);
  reads_long({Place::kBlock2Down}, kLong_m);
  for (int i = 0; i < 3; ++i) {
    climb.tick(robot.now, robot.look());
    robot.act(hold(), 0.05);
  }
  EXPECT_EQ(posture_of(climb.situation()), Posture::kStraddle);
}

}  // namespace stetro_supervisor
