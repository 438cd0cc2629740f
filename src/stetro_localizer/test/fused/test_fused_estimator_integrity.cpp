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

#include <array>
#include <cmath>

#include "stetro_localizer/fused/normal_quantile.hpp"
#include "support/fused_rig.hpp"

namespace stetro_localizer
{
namespace
{

TEST(FusedEstimatorIntegrity, SaysThatNoSideRangeIsLeft)
{
  Rig rig(3);
  rig.robot.sides_dead = true;
  rig.robot.rest(1.0);
  EXPECT_TRUE(rig.estimate().reasons & kNoSideRange);
  EXPECT_EQ(rig.estimate().integrity, Integrity::kDegraded);
}

/// What slips and turns add to the protection levels along, across and in heading: the rest is the
/// filter's doubt.
std::array<double, 3> unseen_shares(const StairEstimate & estimate)
{
  const double q = protection_quantile(FusedParams{}.integrity_risk);
  return {
    estimate.protection_along_m - q * std::sqrt(estimate.tread_covariance(0, 0)),
    estimate.protection_across_m - q * std::sqrt(estimate.tread_covariance(1, 1)),
    estimate.protection_heading_rad - q * std::sqrt(estimate.tread_covariance(5, 5))};
}

// 2 mm of a slip and 6 mrad of a turn before the ranges suspect one; a whole slip, 20 mm, and a
// turn of 0.1 rad, where nothing corrected for half a second.
TEST(FusedEstimatorIntegrity, WhatNothingSeesCountsWhole)
{
  Rig rig(3, uncalibrated());
  EXPECT_NEAR(unseen_shares(rig.estimate())[0], 0.002, 1e-12);
  EXPECT_NEAR(unseen_shares(rig.estimate())[1], 0.002, 1e-12);
  EXPECT_NEAR(unseen_shares(rig.estimate())[2], 0.006, 1e-12);
  rig.robot.sides_dead = true;
  rig.robot.rest(0.6);
  EXPECT_NEAR(unseen_shares(rig.estimate())[0], 0.002, 1e-12);
  EXPECT_NEAR(unseen_shares(rig.estimate())[1], 0.020, 1e-12);
  EXPECT_NEAR(unseen_shares(rig.estimate())[2], 0.006, 1e-12);
  rig.robot.sides_dead = false;
  rig.robot.front_dead = true;
  rig.robot.rest(0.6);
  EXPECT_NEAR(unseen_shares(rig.estimate())[0], 0.020, 1e-12);
  EXPECT_NEAR(unseen_shares(rig.estimate())[1], 0.002, 1e-12);
  EXPECT_NEAR(unseen_shares(rig.estimate())[2], 0.1, 1e-12);
}

// From a table of the normal distribution: 1.959964 for 5 %, 2.575829 for 1 %.
TEST(FusedEstimatorIntegrity, ThreeLevelsShareTheRisk)
{
  EXPECT_NEAR(protection_quantile(0.15), 1.959964, 1e-6);
  EXPECT_NEAR(protection_quantile(0.03), 2.575829, 1e-6);
}

// Sixteen treads: on 15 block 1 stands on the last one, and nothing rises before the front pair.
TEST(FusedEstimatorIntegrity, NoRiserAheadIsToldAndNoDoubt)
{
  Rig rig(14, uncalibrated());
  rig.sweep();
  EXPECT_EQ(rig.estimate().reasons, 0u) << reason_names(rig.estimate().reasons);
  rig.robot.climb(14);
  ASSERT_EQ(rig.estimate().step, 15);
  EXPECT_EQ(rig.estimate().reasons, kNoFrontReference) << reason_names(rig.estimate().reasons);
  EXPECT_EQ(rig.estimate().integrity, Integrity::kOk);
}

// Exact readings repeat themselves, which no live sensor does.
TEST(FusedEstimatorIntegrity, SaysThatASensorIsStuck)
{
  Rig live(3, uncalibrated());
  EXPECT_FALSE(live.estimate().reasons & kSensorStuck);
  Rig frozen(3);
  EXPECT_TRUE(frozen.estimate().reasons & kSensorStuck);
}

// A dead sensor keeps the stamp of its last answer and says that it is at fault.
TEST(FusedEstimatorIntegrity, SaysThatAnySensorIsDead)
{
  for (const Place place : stetro_site::kPlaces) {
    Rig rig(3, uncalibrated());
    ASSERT_EQ(rig.estimate().integrity, Integrity::kOk) << reason_names(rig.estimate().reasons);
    rig.robot.dead = place;
    rig.robot.rest(0.6);
    EXPECT_TRUE(rig.estimate().reasons & kSensorDead) << stetro_site::name_of(place);
    EXPECT_EQ(rig.estimate().integrity, Integrity::kDegraded);
    rig.robot.dead.reset();
    rig.robot.rest(0.2);
    EXPECT_FALSE(rig.estimate().reasons & kSensorDead) << stetro_site::name_of(place);
  }
}

// A gain of 25 % is dirt, not the state file; the file's own reason stays its own.
TEST(FusedEstimatorIntegrity, ADirtySensorIsNotADamagedFile)
{
  EXPECT_EQ(reason_names(kSensorCalibration), "sensor calibration beyond trust");
  EXPECT_EQ(reason_names(kCalibrationDamaged), "state file damaged");
  FusedEstimator estimator(params_with(3), stetro_site::RobotGeometry{}, papers_flight());
  StateReading found;
  found.kind = StateReading::Kind::kFound;
  found.state.segment_id = "papers";
  ErrorStateFilter filter;
  filter.set(gain_index(Ranger::kBlock3Front), 0.25, 1e-6);
  found.state.fused = filter.calibration();
  estimator.begin(found);
  StairRobot robot(estimator, uncalibrated());
  robot.stand_on(3);
  robot.rest(0.5);
  EXPECT_TRUE(estimator.estimate().reasons & kSensorCalibration);
  EXPECT_FALSE(estimator.estimate().reasons & kCalibrationDamaged);
}

// Block 2 stands on tread 3, 8.5 cm before riser 4, but somebody says 4 cm beyond it.
TEST(FusedEstimatorIntegrity, SaysThatXIsOffTheTread)
{
  Rig rig(3, uncalibrated());
  EXPECT_FALSE(rig.estimate().reasons & kOffTread);
  rig.robot.front_dead = true;
  stetro_site::Covariance sure = stetro_site::Covariance::Zero();
  sure.diagonal().setConstant(1e-6);
  const auto told_at = [&](double x_m) {
    EXPECT_FALSE(rig.estimator.tell_pose({x_m, 1.0, 3 * 0.14, 0.0}, sure));
    rig.robot.rest(0.1);
    return rig.estimate();
  };
  const StairEstimate inside = told_at(3 * 0.32 - 0.005);  // its front edge 7 cm in the riser
  EXPECT_LT(inside.protection_along_m, 0.05);
  EXPECT_TRUE(inside.reasons & kOffTread) << reason_names(inside.reasons);
  EXPECT_FALSE(told_at(3 * 0.32 - 0.10).reasons & kOffTread);
}

}  // namespace
}  // namespace stetro_localizer
