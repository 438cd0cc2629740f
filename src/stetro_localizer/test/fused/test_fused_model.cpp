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
#include <random>

#include "stetro_localizer/fused/cone.hpp"
#include "stetro_localizer/fused/fused_model.hpp"
#include "support/stair_robot.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kWidth = 2.05;     // [m]
constexpr double kMount = 0.05;     // of a side sensor off the middle [m]
constexpr int kReadings = 600;      // twenty seconds
constexpr double kSquareTo = 0.19;  // from base_link to the front pair [m]

/// The model and a core that stands on tread 3, ready to sweep; time stands still.
class Standing
{
public:
  explicit Standing(unsigned seed = 1)
  : model_(LocalizerParams{}, robot_, papers_flight()), random_(seed), core(model_.begin())
  {
    core.steps.tell(3);
    for (int i = 0; i < 10; ++i) {
      BlockSample blocks;
      blocks.stamp = std::chrono::seconds(1000) + i * std::chrono::milliseconds(33);
      blocks.blocks[0] = {0.14, 0.33, true, false, false};
      blocks.blocks[1] = blocks.blocks[2] = {0.0, 0.33, true, false, false};
      model_.take(core, blocks);
    }
    core.filter.set(kStateYaw, 0.0, 0.175 * 0.175);
  }

  void know(int index, double value, double sigma) { core.filter.set(index, value, sigma * sigma); }

  /// A reading that the one before confirms. \return what became of it
  Outcome read(Place place, double range_m)
  {
    core.last_ranges[place] = {core.time, range_m, 0.0, RangeStatus::kValid};
    return read_once(place, range_m);
  }

  Outcome read_once(Place place, double range_m)
  {
    RangeSample sample;
    sample.stamp = core.time;
    sample[place] = {core.time, range_m, 0.0, RangeStatus::kValid};
    model_.take(core, sample);
    switch (place) {
      case Place::kSideLeft:
        return core.reports[Source::kSideLeft].outcome;
      case Place::kSideRight:
        return core.reports[Source::kSideRight].outcome;
      case Place::kFrontRight:
        return core.reports[Source::kFrontRight].outcome;
      case Place::kBlock3Front:
        return core.reports[Source::kBlock3Front].outcome;
      default:
        return core.reports[Source::kFrontLeft].outcome;
    }
  }

  /// Readings of one array, with noise of 1 mm, each confirmed by the one before.
  void read_pair(Place first, double first_m, Place second, double second_m)
  {
    RangeSample sample;
    sample.stamp = core.time;
    sample[first] = {core.time, first_m + 0.001 * normal_(random_), 0.0, RangeStatus::kValid};
    sample[second] = {core.time, second_m + 0.001 * normal_(random_), 0.0, RangeStatus::kValid};
    core.last_ranges[first] = sample[first];
    core.last_ranges[second] = sample[second];
    model_.take(core, sample);
  }

  /// A reading with noise, of a sensor square to a wall at that distance.
  double noisy(double square_m, double offset_m = 0.0, double gain = 0.0)
  {
    const double range_m = (1.0 + gain) * stretch() * square_m + offset_m;
    return range_m + robot_.range_sensor.sigma_at_m(range_m) * normal_(random_);
  }

  void take(const Sample & sample) { model_.take(core, sample); }
  double random(double sigma) { return sigma * normal_(random_); }
  [[nodiscard]] double stretch() const
  {
    return ConeOnWall(robot_.range_sensor.cone_rad).stretch(0.0);
  }

private:
  stetro_site::RobotGeometry robot_;
  FusedModel model_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;

public:
  FusedCore core;
};

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
  Standing robot;
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
    Standing robot(seed);
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
  Standing robot;
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
    Standing robot;
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
  Standing robot;
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
  Standing robot;
  robot.know(kStateY, 0.3, 0.5);
  EXPECT_EQ(robot.read(Place::kSideLeft, 0.9), Outcome::kFused);
}

/// Puts it where the front pair is `square_m` before the riser that it sees.
void put_before_riser(Standing & robot, double square_m, double sigma_m)
{
  robot.know(kStateY, 1.0, 0.005);
  robot.know(kStateX, robot.core.filter[kStateTreadAhead] - kSquareTo - square_m, sigma_m);
}

// The beams strike a riser of 0.14 m at half its height; a cone of 25 deg fits in up to 0.07 m /
// tan(12.5 deg) = 0.316 m. From 0.325 m, read as 0.329 m, a short reading of 0.310 m would fit.
TEST(FusedModel, AShortReadingDoesNotClearACone)
{
  Standing sure;
  put_before_riser(sure, 0.325, 0.005);
  const ErrorStateFilter known = sure.core.filter;
  EXPECT_EQ(sure.read(Place::kFrontLeft, 0.310), Outcome::kNotVisible);
  EXPECT_EQ(sure.core.filter.state(), known.state());

  Standing unsure;
  put_before_riser(unsure, 0.325, 0.015);
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
  Standing robot;
  put_before_riser(robot, 0.29, 0.015);
  const ErrorStateFilter before = robot.core.filter;
  EXPECT_EQ(robot.read(Place::kFrontLeft, 0.320), Outcome::kFused);
  expect_untouched(robot.core.filter, before, kStateYaw);
}

TEST(FusedModel, AClearConeTellsOfTheHeading)
{
  Standing robot;
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
  Standing robot;
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
  Standing robot;
  put_before_riser(robot, 0.1, 0.0005);
  robot.know(kStateYaw, 0.0, 0.003);
  for (int i = 0; i < kReadings; ++i) {
    robot.read(Place::kFrontLeft, robot.noisy(0.1, 0.012));
  }
  EXPECT_NEAR(robot.core.filter[offset_index(Ranger::kFrontLeft)], 0.012, 0.003);
}

TEST(FusedModel, AReadingCountsOnceTheNextConfirmsIt)
{
  Standing robot;
  robot.know(kStateY, 1.0, 0.2);
  EXPECT_EQ(robot.read_once(Place::kSideLeft, 0.9), Outcome::kNotVisible) << "the first";
  EXPECT_EQ(robot.read_once(Place::kSideLeft, 1.1), Outcome::kNotVisible) << "another";
  EXPECT_EQ(robot.read_once(Place::kSideLeft, 1.09), Outcome::kFused);
}

/// Block 2 lifted 0.18 m above tread 3, block 1 on tread 4.
void lift_block2(Standing & robot)
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
  Standing robot;
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

/// Knows all but where a slip will take it: the right sensor is 0.25 m from its wall.
void calibrate(Standing & robot)
{
  robot.core.rolled_at = robot.core.time;
  robot.know(kStateY, 0.3, 0.001);
  robot.know(kStateYaw, 0.0, 0.002);
  robot.know(offset_index(Ranger::kSideRight), 0.0, 0.0005);
  robot.know(gain_index(Ranger::kSideRight), 0.0, 0.002);
}

/// In the middle, all known as after a contact with both walls and a riser.
void know_all(Standing & robot)
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
TEST(FusedModel, DoubtsYWhereBothSidesDoNotAddUp)
{
  Standing robot;
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
TEST(FusedModel, DoubtsYWhereARangeJumpsAtAStand)
{
  Standing robot;
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
TEST(FusedModel, DoubtsTheHeadingWhereTheFrontPairTurnsAlone)
{
  Standing robot;
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

// One reading knows 4.3 mm: with 1 mm of doubt in y the filter by itself would follow in some 20.
TEST(FusedModel, FollowsASlip)
{
  constexpr unsigned kRobots = 200;
  for (const double slip_m : {0.012, -0.012}) {
    int found = 0;
    double sum_m = 0.0;
    for (unsigned seed = 1; seed <= kRobots; ++seed) {
      Standing robot(seed);
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

}  // namespace
}  // namespace stetro_localizer
