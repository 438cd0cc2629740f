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

#include <chrono>
#include <cmath>

#include "support/standing_robot.hpp"

namespace stetro_localizer
{
namespace
{

constexpr int kReadings = 600;  // twenty seconds

/// Same value, same variance, to the last bit.
void expect_untouched(const ErrorStateFilter & now, const ErrorStateFilter & before, int index)
{
  EXPECT_EQ(now[index], before[index]) << "state " << index;
  EXPECT_EQ(now.variance(index), before.variance(index)) << "state " << index;
}

// In the middle both sensors are 0.975 m from their wall, which they read as 0.987 m. Offset and
// gain shift a reading by hypot(10 mm, 3 % of 0.987 m) = 31.3 mm, 30.9 mm of y; the width adds
// 2.5 mm on the left. The mean of both is off by 21.9 mm, however often they are read.
TEST(FusedModel, SideRangesCannotCalibrateThemselves)
{
  StandingRobot robot;
  ASSERT_EQ(robot.core.located_on, 3);
  const ErrorStateFilter before = robot.core.filter;
  for (int i = 0; i < kReadings; ++i) {
    ASSERT_EQ(robot.read(Place::kSideLeft, robot.noisy(0.975)), Outcome::kFused);
    ASSERT_EQ(robot.read(Place::kSideRight, robot.noisy(0.975)), Outcome::kFused);
  }
  const ErrorStateFilter & filter = robot.core.filter;
  expect_untouched(filter, before, kStateYaw);
  for (const Ranger ranger : {Ranger::kSideLeft, Ranger::kSideRight}) {
    expect_untouched(filter, before, offset_index(ranger));
    expect_untouched(filter, before, gain_index(ranger));
  }
  EXPECT_NEAR(std::sqrt(filter.variance(kStateY)), 0.0219, 0.0002);
}

// Property: whatever the sensors' errors, y is off as far as the filter says, and no readings tell
// more than the calibration allows.
TEST(FusedModel, StandingIsConsistent)
{
  constexpr unsigned kRobots = 400;
  double squares = 0.0;
  for (unsigned seed = 1; seed <= kRobots; ++seed) {
    StandingRobot robot(seed);
    const double width_m = kWidth + robot.random(0.0025);
    const double y_m = width_m / 2.0 + robot.random(0.03);
    const double left_m = width_m - y_m - kMount;
    const double offset_m[2] = {robot.random(0.01), robot.random(0.01)};
    const double gain[2] = {robot.random(0.03), robot.random(0.03)};
    for (int k = 0; k < kReadings; ++k) {
      robot.read(Place::kSideLeft, robot.noisy(left_m, offset_m[0], gain[0]));
      robot.read(Place::kSideRight, robot.noisy(y_m - kMount, offset_m[1], gain[1]));
    }
    const double error_m = robot.core.filter[kStateY] - y_m;
    squares += error_m * error_m / robot.core.filter.variance(kStateY);
    EXPECT_GT(std::sqrt(robot.core.filter.variance(kStateY)), 0.021);
  }
  EXPECT_NEAR(squares / kRobots, 1.0, 0.25);  // its own standard deviation is 0.07
}

TEST(FusedModel, SideRangesCalibrateWhereYIsKnown)
{
  StandingRobot robot;
  robot.know(kStateY, 1.0, 0.005);
  const ErrorStateFilter before = robot.core.filter;
  ASSERT_EQ(robot.read(Place::kSideRight, robot.noisy(0.95)), Outcome::kFused);
  for (const int index : {offset_index(Ranger::kSideRight), gain_index(Ranger::kSideRight)}) {
    EXPECT_LT(robot.core.filter.variance(index), before.variance(index));
  }
}

// Three standard deviations from zero are 0.06 rad here.
TEST(FusedModel, SideRangesTurnOnlyAHeadingOfKnownSide)
{
  for (const double yaw_rad : {0.1, 0.05, -0.05, -0.1}) {
    StandingRobot robot;
    robot.know(kStateYaw, yaw_rad, 0.02);
    const ErrorStateFilter before = robot.core.filter;
    ASSERT_EQ(robot.read(Place::kSideRight, robot.noisy(0.95)), Outcome::kFused);
    if (std::abs(yaw_rad) < 0.06) {
      expect_untouched(robot.core.filter, before, kStateYaw);
    } else {
      EXPECT_NE(robot.core.filter[kStateYaw], before[kStateYaw]);
      EXPECT_LT(robot.core.filter.variance(kStateYaw), before.variance(kStateYaw));
    }
  }
}

// At y = 0.3 m the left wall is 1.70 m away and the right one 0.25 m.
TEST(FusedModel, WhatIsNearerThanAWallOutOfReachIsNotTheWall)
{
  StandingRobot robot;
  robot.know(kStateY, 0.3, 0.005);
  const ErrorStateFilter before = robot.core.filter;
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(robot.read(Place::kSideLeft, 0.9 + 0.001 * i), Outcome::kNotVisible);
  }
  EXPECT_EQ(robot.core.reports[Source::kSideLeft].reject_streak, 0u);
  EXPECT_EQ(robot.core.filter.state(), before.state());
  EXPECT_EQ(robot.core.filter.covariance(), before.covariance());
  EXPECT_EQ(robot.read(Place::kSideRight, robot.noisy(0.25)), Outcome::kFused);
}

TEST(FusedModel, WhereYIsUnknownTheWallMayBeInReach)
{
  StandingRobot robot;
  robot.know(kStateY, 0.3, 0.5);
  EXPECT_EQ(robot.read(Place::kSideLeft, 0.9), Outcome::kFused);
}

// The beams strike a riser of 0.14 m at half its height; a cone of 25 deg fits in up to 0.07 m /
// tan(12.5 deg) = 0.316 m. From 0.325 m, read as 0.329 m, a short reading of 0.310 m would fit.
TEST(FusedModel, AShortReadingDoesNotClearACone)
{
  StandingRobot sure;
  put_before_riser(sure, 0.325, 0.005);
  const ErrorStateFilter known = sure.core.filter;
  EXPECT_EQ(sure.read(Place::kFrontLeft, 0.310), Outcome::kNotVisible);
  EXPECT_EQ(sure.core.filter.state(), known.state());

  StandingRobot unsure;
  put_before_riser(unsure, 0.325, 0.015);
  unsure.know(kStateYaw, 0.0, 0.06);
  const ErrorStateFilter before = unsure.core.filter;
  EXPECT_EQ(unsure.read(Place::kFrontLeft, 0.310), Outcome::kFused);
  EXPECT_GT(unsure.core.filter[kStateX], before[kStateX] + 0.003);
  for (int i = 0; i < kStateCount; ++i) {
    if (i != kStateX) {
      expect_untouched(unsure.core.filter, before, i);
    }
  }
}

TEST(FusedModel, ALongReadingDoesNotClearAConeEither)
{
  StandingRobot robot;
  put_before_riser(robot, 0.29, 0.015);
  robot.know(kStateYaw, 0.0, 0.06);
  const ErrorStateFilter before = robot.core.filter;
  EXPECT_EQ(robot.read(Place::kFrontLeft, 0.320), Outcome::kFused);
  expect_untouched(robot.core.filter, before, kStateYaw);
}

// Half a metre away, read as 0.506 m, the shift is 3 % of it, 15 mm, and the heading told by two
// over 0.2 m is good to 0.107 rad: what a robot begins with that knows it to 0.175.
TEST(FusedModel, ClippedConesBeginTheHeading)
{
  StandingRobot robot;
  put_before_riser(robot, 0.5, 0.1);
  const ErrorStateFilter before = robot.core.filter;
  for (int i = 0; i < kReadings; ++i) {
    robot.read(Place::kFrontLeft, robot.noisy(0.5));
    robot.read(Place::kFrontRight, robot.noisy(0.5));
  }
  EXPECT_LT(std::sqrt(robot.core.filter.variance(kStateYaw)), 0.12);
  EXPECT_GT(std::sqrt(robot.core.filter.variance(kStateYaw)), 0.07) << "however often it is asked";
  for (const Ranger ranger : {Ranger::kFrontLeft, Ranger::kFrontRight}) {
    expect_untouched(robot.core.filter, before, offset_index(ranger));
  }
}

TEST(FusedModel, AClearConeTellsOfTheHeading)
{
  StandingRobot robot;
  put_before_riser(robot, 0.29, 0.005);
  const ErrorStateFilter before = robot.core.filter;
  EXPECT_EQ(robot.read(Place::kFrontLeft, robot.noisy(0.29)), Outcome::kFused);
  EXPECT_LT(robot.core.filter.variance(kStateX), before.variance(kStateX));
  EXPECT_LT(robot.core.filter.variance(kStateYaw), before.variance(kStateYaw));
}

// At 0.29 m offset and gain shift a reading by hypot(10 mm, 3 % of 0.294 m) = 13.3 mm, the
// difference of the pair by 18.8 mm and the heading over 0.2 m by 0.094 rad, however often they
// are read.
TEST(FusedModel, AFrontPairTellsTheHeadingAsWellAsItIsCalibrated)
{
  StandingRobot robot;
  put_before_riser(robot, 0.29, 0.1);
  const ErrorStateFilter before = robot.core.filter;
  for (int i = 0; i < kReadings; ++i) {
    ASSERT_EQ(robot.read(Place::kFrontLeft, robot.noisy(0.29)), Outcome::kFused);
    ASSERT_EQ(robot.read(Place::kFrontRight, robot.noisy(0.29)), Outcome::kFused);
  }
  EXPECT_GT(std::sqrt(robot.core.filter.variance(kStateYaw)), 0.07);
  EXPECT_LT(std::sqrt(robot.core.filter.variance(kStateYaw)), 0.1);
  for (const Ranger ranger : {Ranger::kFrontLeft, Ranger::kFrontRight}) {
    expect_untouched(robot.core.filter, before, offset_index(ranger));
    expect_untouched(robot.core.filter, before, gain_index(ranger));
  }
}

TEST(FusedModel, AFrontRangeIsCalibratedWhereXAndHeadingAreKnown)
{
  StandingRobot robot;
  put_before_riser(robot, 0.1, 0.0005);
  robot.know(kStateYaw, 0.0, 0.003);
  for (int i = 0; i < kReadings; ++i) {
    robot.read(Place::kFrontLeft, robot.noisy(0.1, 0.012));
  }
  EXPECT_NEAR(robot.core.filter[offset_index(Ranger::kFrontLeft)], 0.012, 0.003);
}

TEST(FusedModel, AReadingCountsOnceTheNextConfirmsIt)
{
  StandingRobot robot;
  robot.know(kStateY, 1.0, 0.2);
  EXPECT_EQ(robot.read_once(Place::kSideLeft, 0.9), Outcome::kNotVisible) << "the first";
  EXPECT_EQ(robot.read_once(Place::kSideLeft, 1.1), Outcome::kNotVisible) << "another";
  EXPECT_EQ(robot.read_once(Place::kSideLeft, 1.09), Outcome::kFused);
}

/// Block 2 lifted 0.18 m above tread 3, block 1 on tread 4.
void lift_block2(StandingRobot & robot)
{
  for (int i = 1; i < 10; ++i) {
    BlockSample blocks;
    blocks.stamp = robot.core.time + std::chrono::milliseconds(33);
    blocks.blocks[0] = {0.14, 0.5, true, false, false};
    blocks.blocks[1] = {0.02 * i, 0.0, true, true, false};
    blocks.blocks[2] = {0.0, 0.5, true, false, false};
    robot.take(blocks);
  }
}

// The beam starts 0.11 m behind base_link, 0.07 m above tread 3: half the riser.
TEST(FusedModel, Block3SeesTheRiserBelowALiftedBlock2)
{
  StandingRobot robot;
  robot.know(kStateX, -0.1, 0.02);
  robot.know(kStateYaw, 0.0, 0.003);
  EXPECT_EQ(robot.read(Place::kBlock3Front, 0.035), Outcome::kNotVisible) << "block 2's back";
  lift_block2(robot);
  ASSERT_EQ(robot.core.located_on, 3);
  const double x_m = robot.core.filter[kStateX];
  EXPECT_EQ(robot.read(Place::kBlock3Front, robot.stretch() * (0.11 - x_m)), Outcome::kFused);
  EXPECT_NEAR(robot.core.reports[Source::kBlock3Front].innovation, 0.0, 1e-9);
  EXPECT_NEAR(robot.core.filter[kStateX], x_m, 1e-9);
  EXPECT_LT(std::sqrt(robot.core.filter.variance(kStateX)), 0.012);
}

}  // namespace
}  // namespace stetro_localizer
