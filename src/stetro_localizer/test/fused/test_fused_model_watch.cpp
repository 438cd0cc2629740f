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

#include <limits>

#include "support/standing_robot.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kAtWall = 0.115;  // y when the right bumper touches, half of 23 cm [m]

/// Knows all but where a slip will take it: the right sensor is 0.25 m from its wall.
void calibrate(StandingRobot & robot)
{
  robot.core.rolled_at = robot.core.time;
  robot.know(kStateY, 0.3, 0.001);
  robot.know(kStateYaw, 0.0, 0.002);
  robot.know(offset_index(Ranger::kSideRight), 0.0, 0.0005);
  robot.know(gain_index(Ranger::kSideRight), 0.0, 0.002);
}

/// In the middle, all known as after a contact with both walls and a riser.
void know_all(StandingRobot & robot)
{
  robot.know(kStateY, kWidth / 2.0, 0.002);
  robot.know(kStateWidth, kWidth, 0.001);
  robot.know(kStateYaw, 0.0, 0.002);
  for (int i = 0; i < static_cast<int>(kRangerCount); ++i) {
    robot.know(offset_index(static_cast<Ranger>(i)), 0.0, 0.001);
    robot.know(gain_index(static_cast<Ranger>(i)), 0.0, 0.002);
  }
}

// The left sensor has jumped by 50 mm: the sum is too long by it, whatever y is.
TEST(FusedModelWatch, DoubtsYWhereBothSidesDoNotAddUp)
{
  StandingRobot robot;
  know_all(robot);
  const double range_m = robot.stretch() * (kWidth / 2.0 - kMount);
  for (int i = 0; i < 60; ++i) {
    robot.read_pair(Place::kSideLeft, range_m, Place::kSideRight, range_m);
  }
  EXPECT_FALSE(robot.core.doubted[1]);
  for (int i = 0; i < 30 && !robot.core.doubted[1]; ++i) {
    robot.read_pair(Place::kSideLeft, range_m + 0.05, Place::kSideRight, range_m);
  }
  EXPECT_TRUE(robot.core.doubted[1]) << "within a second";
  EXPECT_GT(robot.core.filter.variance(offset_index(Ranger::kSideLeft)), 0.02 * 0.02);
}

// At a stand no wall moves by 30 mm.
TEST(FusedModelWatch, DoubtsYWhereARangeJumpsAtAStand)
{
  StandingRobot robot;
  know_all(robot);
  robot.know(kStateY, 0.3, 0.002);
  const double range_m = robot.stretch() * 0.25;
  for (int i = 0; i < 30 && !robot.core.doubted[1]; ++i) {
    robot.read(Place::kSideRight, range_m + 0.03);
  }
  EXPECT_TRUE(robot.core.doubted[1]);
  EXPECT_GT(robot.core.filter.variance(kStateY), 0.01 * 0.01);
}

// One front range has grown by 20 mm, or the gyroscope has turned the heading by 0.1 rad unseen.
TEST(FusedModelWatch, DoubtsTheHeadingWhereTheFrontPairTurnsAlone)
{
  StandingRobot robot;
  know_all(robot);
  put_before_riser(robot, 0.15, 0.002);
  const double range_m = robot.stretch() * 0.15;
  for (int i = 0; i < 60; ++i) {
    robot.read_pair(Place::kFrontLeft, range_m, Place::kFrontRight, range_m);
  }
  EXPECT_FALSE(robot.core.doubted[2]);
  for (int i = 0; i < 30 && !robot.core.doubted[2]; ++i) {
    robot.read_pair(Place::kFrontLeft, range_m + 0.02, Place::kFrontRight, range_m);
  }
  EXPECT_TRUE(robot.core.doubted[2]);
  EXPECT_GT(robot.core.filter.variance(kStateYaw), 0.02 * 0.02);
}

// Readings 10 ms apart: 0.5 s of the same reading while the wheels turn.
TEST(FusedModelWatch, AGyroscopeThatRepeatsItselfInMotionIsStuck)
{
  StandingRobot robot;
  const auto read = [&robot](double rate_radps, double vy_mps) {
    const Nanoseconds stamp = robot.core.time + std::chrono::milliseconds(10);
    robot.take(OdometrySample{stamp, 0.0, vy_mps, 0.0});
    robot.take(GyroSample{stamp, rate_radps});
  };
  for (int i = 0; i < 100; ++i) {
    read(0.001, 0.0);
  }
  EXPECT_FALSE(robot.stuck_gyro()) << "at a stand some say the same for long";
  for (int i = 0; i < 50; ++i) {
    read(0.001, 0.1);
  }
  EXPECT_FALSE(robot.stuck_gyro());
  const double variance = robot.core.filter.variance(kStateYaw);
  for (int i = 0; i < 10; ++i) {
    read(0.001, 0.1);
  }
  EXPECT_TRUE(robot.stuck_gyro());
  EXPECT_GT(robot.core.filter.variance(kStateYaw), variance + 1e-4) << "it may turn unseen";
  read(0.0011, 0.1);
  EXPECT_FALSE(robot.stuck_gyro());
}

// Half a metre away a wall is not missed half a second long; what is out of reach may be.
TEST(FusedModelWatch, ASideSensorThatMissesItsWallIsBlind)
{
  StandingRobot robot;
  know_all(robot);
  robot.know(kStateY, 0.5, 0.002);
  const auto miss_both = [&robot] {
    RangeSample none;
    none.stamp = robot.core.time;
    none[Place::kSideLeft] = none[Place::kSideRight] = {
      robot.core.time, std::numeric_limits<double>::infinity(), 0.0, RangeStatus::kNoTarget};
    robot.take(none);
  };
  const auto blind = [&robot](Ranger ranger) {
    return robot.core.monitors[static_cast<std::size_t>(ranger)].blind();
  };
  for (int i = 0; i < 14; ++i) {
    miss_both();
  }
  EXPECT_FALSE(blind(Ranger::kSideRight));
  miss_both();
  EXPECT_TRUE(blind(Ranger::kSideRight));
  EXPECT_FALSE(blind(Ranger::kSideLeft)) << "1.5 m away";
  robot.read(Place::kSideRight, robot.noisy(0.45));
  EXPECT_FALSE(blind(Ranger::kSideRight));
}

// One reading knows 4.3 mm: with 1 mm of doubt in y the filter by itself would follow in some 20.
TEST(FusedModelWatch, FollowsASlip)
{
  constexpr unsigned kRobots = 200;
  for (const double slip_m : {0.012, -0.012}) {
    int found = 0;
    double sum_m = 0.0;
    for (unsigned seed = 1; seed <= kRobots; ++seed) {
      StandingRobot robot(seed);
      calibrate(robot);
      for (int i = 0; i < 15 && robot.core.slipping_until < robot.core.time; ++i) {
        robot.read(Place::kSideRight, robot.noisy(0.25 + slip_m));
      }
      if (robot.core.slipping_until > robot.core.time) {
        sum_m += robot.core.filter[kStateY] - (0.3 + slip_m);
        ++found;
      }
    }
    EXPECT_GT(found, 0.9 * kRobots);
    EXPECT_NEAR(sum_m / found, 0.0, 0.002);
  }
}

// Something a third of a metre before the wall, for a tenth of a second: farther than any slip.
TEST(FusedModelWatch, AnObjectInTheBeamIsNoSlip)
{
  for (const bool is_calibrated : {true, false}) {
    StandingRobot robot;
    calibrate(robot);
    if (!is_calibrated) {
      robot.know(kStateY, 0.3, 0.015);
      robot.know(offset_index(Ranger::kSideRight), 0.0, 0.010);
    }
    robot.read(Place::kSideRight, robot.noisy(0.55));
    robot.know(kStateY, 0.6, is_calibrated ? 0.001 : 0.015);
    for (int i = 0; i < 5; ++i) {
      robot.read(Place::kSideRight, robot.noisy(0.25));
    }
    EXPECT_NEAR(robot.core.filter[kStateY], 0.6, 0.02);
    EXPECT_FALSE(robot.core.doubted[kStateY]);
  }
}

/// Block 2's right bumper closes; the other switches are known and open.
void touch_right(StandingRobot & robot)
{
  ContactSample contacts;
  for (auto * side : {&contacts.left, &contacts.right}) {
    for (Switch & bumper : *side) {
      bumper = {true, false};
    }
  }
  contacts.stamp = robot.core.time;
  robot.take(contacts);
  contacts.right[1].closed = true;
  robot.take(contacts);
}

// What looks like a slip to one sensor may be a fault of its own: until a contact has told.
TEST(FusedModelWatch, ASlipThatOneSensorTellsIsUnconfirmed)
{
  StandingRobot robot;
  calibrate(robot);
  robot.know(kStateY, 0.13, 0.001);
  for (int i = 0; i < 15 && robot.core.slipping_until < robot.core.time; ++i) {
    robot.read(Place::kSideRight, robot.stretch() * (0.08 + 0.015));
  }
  EXPECT_NEAR(robot.core.unconfirmed_m[kStateY], 0.015, 0.004);
  touch_right(robot);
  EXPECT_EQ(robot.core.unconfirmed_m[kStateY], 0.0);
}

TEST(FusedModelWatch, ASlipThatBothSidesTellIsBelieved)
{
  StandingRobot robot;
  know_all(robot);
  robot.core.rolled_at = robot.core.time;
  const double range_m = robot.stretch() * (kWidth / 2.0 - kMount);
  robot.read_pair(Place::kSideLeft, range_m, Place::kSideRight, range_m);
  for (int i = 0; i < 40 && robot.core.slipping_until < robot.core.time; ++i) {
    robot.read_pair(Place::kSideLeft, range_m - 0.02, Place::kSideRight, range_m + 0.02);
  }
  EXPECT_GT(robot.core.slipping_until, robot.core.time) << "it has been found";
  EXPECT_EQ(robot.core.unconfirmed_m[kStateY], 0.0);
}

// The pair turns by 1.7 deg: less than it takes to doubt the heading, enough to allow for it.
TEST(FusedModelWatch, AllowsForATurnThatTheFrontPairSuspects)
{
  StandingRobot robot;
  know_all(robot);
  put_before_riser(robot, 0.15, 0.002);
  const double range_m = robot.stretch() * 0.15;
  for (int i = 0; i < 60; ++i) {
    robot.read_pair(Place::kFrontLeft, range_m, Place::kFrontRight, range_m);
  }
  EXPECT_EQ(robot.suspected_turn_rad(), 0.0);
  for (int i = 0; i < 30 && robot.suspected_turn_rad() == 0.0; ++i) {
    robot.read_pair(Place::kFrontLeft, range_m + 0.008, Place::kFrontRight, range_m);
  }
  EXPECT_GT(robot.suspected_turn_rad(), 0.02);
  EXPECT_FALSE(robot.core.doubted[kStateYaw]);
}

// It has slipped by 8 cm where it saw no riser: after five refusals of both, it believes them.
TEST(FusedModelWatch, BelievesBothFrontRangesRatherThanItself)
{
  StandingRobot robot;
  know_all(robot);
  put_before_riser(robot, 0.15, 0.005);
  const double x_m = robot.core.filter[kStateX];
  const double range_m = robot.stretch() * (0.15 + 0.08);
  for (int i = 0; i < 4; ++i) {
    robot.read_pair(Place::kFrontLeft, range_m, Place::kFrontRight, range_m);
  }
  EXPECT_NEAR(robot.core.filter[kStateX], x_m, 0.002) << "it may be spurious";
  for (int i = 0; i < 30; ++i) {
    robot.read_pair(Place::kFrontLeft, range_m, Place::kFrontRight, range_m);
  }
  EXPECT_NEAR(robot.core.filter[kStateX], x_m - 0.08, 0.005);
  EXPECT_EQ(robot.core.reports[Source::kFrontLeft].reject_streak, 0u);
}

// One sensor alone says so: either it or the heading is wrong, and that is told.
TEST(FusedModelWatch, DoesNotBelieveOneFrontRangeAlone)
{
  StandingRobot robot;
  know_all(robot);
  put_before_riser(robot, 0.15, 0.005);
  const double x_m = robot.core.filter[kStateX];
  const double range_m = robot.stretch() * 0.15;
  for (int i = 0; i < 60; ++i) {
    robot.read_pair(Place::kFrontLeft, range_m + 0.08, Place::kFrontRight, range_m);
  }
  EXPECT_NEAR(robot.core.filter[kStateX], x_m, 0.01);
  EXPECT_TRUE(robot.core.doubted[kStateYaw]);
}

// Nothing but the pair has told the heading, 17 deg wrong: half a second, and it finds the way.
TEST(FusedModelWatch, AHeadingThatOnlyThePairToldIsTakenBack)
{
  StandingRobot robot;
  know_all(robot);
  put_before_riser(robot, 0.15, 0.010);
  robot.know(kStateYaw, 0.30, 0.03);
  const double range_m = robot.stretch() * 0.15;
  for (int i = 0; i < 90; ++i) {
    robot.read_pair(Place::kFrontLeft, range_m, Place::kFrontRight, range_m);
  }
  EXPECT_NEAR(robot.core.filter[kStateYaw], 0.0, 0.03);
}

/// Stands at the right wall, sure to be 15 mm off it.
void believe_to_be_off_the_wall(StandingRobot & robot)
{
  robot.know(kStateY, kAtWall + 0.015, 0.002);
  robot.know(kStateYaw, 0.0, 0.002);
  robot.know(offset_index(Ranger::kSideRight), -0.015, 0.002);
  robot.know(gain_index(Ranger::kSideRight), 0.0, 0.002);
}

// The range said the same as y until the contact: it is the offset that is wrong, and what the
// sensor reads afterwards must not overrule the contact.
TEST(FusedModelWatch, AContactThatSurprisesTheRangesTooCalibratesThem)
{
  StandingRobot robot;
  believe_to_be_off_the_wall(robot);
  const double range_m = robot.stretch() * (kAtWall - kMount);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(robot.read(Place::kSideRight, range_m), Outcome::kFused);
  }
  EXPECT_NEAR(robot.core.filter[kStateY], kAtWall + 0.015, 0.002);
  touch_right(robot);
  for (int i = 0; i < 30; ++i) {
    robot.read(Place::kSideRight, range_m);
  }
  EXPECT_NEAR(robot.core.filter[kStateY], kAtWall, 0.002);
  const double error_m = robot.core.filter[offset_index(Ranger::kSideRight)] +
                         robot.core.filter[gain_index(Ranger::kSideRight)] * range_m;
  EXPECT_NEAR(error_m, 0.0, 0.004) << "by offset or gain";
}

// No range was in sight: the robot has slipped, and the offset is as it was.
TEST(FusedModelWatch, AContactThatSurprisesInTheDarkLeavesTheCalibration)
{
  StandingRobot robot;
  believe_to_be_off_the_wall(robot);
  robot.know(offset_index(Ranger::kSideRight), 0.0, 0.002);
  touch_right(robot);
  EXPECT_NEAR(robot.core.filter[kStateY], kAtWall, 0.002);
  EXPECT_NEAR(robot.core.filter[offset_index(Ranger::kSideRight)], 0.0, 1e-6);
}

// It slipped by 15 mm just before the wall, two readings ago: too few for an alarm.
TEST(FusedModelWatch, ASlipJustBeforeAContactLeavesTheCalibration)
{
  StandingRobot robot;
  believe_to_be_off_the_wall(robot);
  robot.know(offset_index(Ranger::kSideRight), 0.0, 0.002);
  const double range_m = robot.stretch() * (kAtWall - kMount);
  robot.read(Place::kSideRight, range_m);
  robot.read(Place::kSideRight, range_m);
  EXPECT_GT(robot.core.filter[kStateY], kAtWall + 0.004) << "not followed yet";
  touch_right(robot);
  EXPECT_NEAR(robot.core.filter[kStateY], kAtWall, 0.002);
  EXPECT_NEAR(robot.core.filter[offset_index(Ranger::kSideRight)], 0.0, 0.004);
}

// Both gains are out by 1.3 %, within their doubt of 1 %: 26 mm of the sum, in every reading alike.
TEST(FusedModelWatch, DoesNotDoubtWhatTheCalibrationMayExplain)
{
  StandingRobot robot;
  know_all(robot);
  for (const Ranger ranger : {Ranger::kSideLeft, Ranger::kSideRight}) {
    robot.know(gain_index(ranger), 0.0, 0.01);
  }
  const double range_m = 1.013 * robot.stretch() * (kWidth / 2.0 - kMount);
  for (int i = 0; i < 60; ++i) {
    robot.read_pair(Place::kSideLeft, range_m, Place::kSideRight, range_m);
  }
  EXPECT_FALSE(robot.core.doubted[1]);
}

}  // namespace
}  // namespace stetro_localizer
