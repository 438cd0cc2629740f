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
#include <optional>
#include <vector>

#include "stetro_localizer/paper_estimator.hpp"
#include "support/stair_robot.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kDeg = M_PI / 180.0;

/// An estimator and its robot, on a step.
struct Scene
{
  explicit Scene(int step, SensorErrors errors = {}, unsigned seed = 1, LocalizerParams params = {})
  : estimator(with_step(params, step), stetro_site::RobotGeometry{}, papers_flight()),
    robot(estimator, errors, seed)
  {
    estimator.begin({});
    robot.stand_on(step);
  }

  static LocalizerParams with_step(LocalizerParams params, int step)
  {
    params.initial_step = step;
    return params;
  }

  [[nodiscard]] const StairEstimate & estimate() const { return estimator.estimate(); }
  [[nodiscard]] double y_error_m() const { return estimate().pose.y_m - robot.y_m; }
  [[nodiscard]] double yaw_error_rad() const { return estimate().pose.yaw_rad - robot.yaw_rad; }

  PaperEstimator estimator;
  StairRobot robot;
};

// Eq. (1) with D1-10, D1-11 for all 16 steps, driven through the whole climb.
TEST(PaperEstimator, GivesEquation1OnEveryStep)
{
  Scene scene(0);
  scene.robot.rest(0.5);
  ASSERT_EQ(scene.estimate().integrity, Integrity::kOk) << reason_names(scene.estimate().reasons);
  EXPECT_NEAR(scene.estimate().pose.x_m, -0.5, 1e-6) << "step 0: measured by the front pair";
  EXPECT_EQ(scene.estimate().pose.z_m, 0.0);
  scene.robot.approach();
  EXPECT_EQ(scene.estimate().step, 0) << "block 1 is on tread 1, block 2 is not (D1-12)";
  EXPECT_NEAR(scene.estimate().pose.x_m, -0.085, 1e-3);
  for (int step = 1; step <= 16; ++step) {
    scene.robot.climb(step - 1);
    const StairEstimate & at = scene.estimate();
    ASSERT_EQ(at.step, step) << reason_names(at.reasons);
    EXPECT_NEAR(at.pose.x_m, (step - 0.5) * 0.32, 1e-12);
    EXPECT_NEAR(at.pose.z_m, step * 0.14, 1e-12);
    EXPECT_NEAR(at.tread_x_m, 0.16, 1e-12);
    EXPECT_NEAR(at.block_heights_m[1], step * 0.14, 1e-9);
    if (step < 15) {
      ASSERT_TRUE(at.measured_x_m.has_value()) << "step " << step;
      EXPECT_NEAR(*at.measured_x_m, scene.robot.x_m, 0.002) << "D1-13";
    }
    EXPECT_EQ(at.integrity, Integrity::kOk) << "step " << step << reason_names(at.reasons);
  }
  EXPECT_EQ(scene.estimate().reset_counter, 0u) << "a climbed step is no jump";
}

TEST(PaperEstimator, FollowsASweepExactlyWithExactSensors)
{
  Scene scene(3);
  scene.robot.rest(0.51);  // so that ranges come at the end of each 0.03 s
  double worst_m = 0.0;
  while (!scene.robot.touches(true)) {
    scene.robot.drive(0.0, 0.15, 0.0, 0.03);
    worst_m = std::max(worst_m, std::abs(scene.y_error_m()));
  }
  EXPECT_LT(worst_m, 0.002) << "no lag, no jump where the sides change";
}

SensorErrors uncalibrated()
{
  SensorErrors errors;
  errors.offset_m = {0.008, -0.006, 0.0, 0.012, -0.010, 0.0, 0.0, 0.0};
  errors.white_m = 0.0021;
  errors.white_per_m = 0.015;
  errors.gyro_bias_radps = 0.3 * kDeg;
  errors.gyro_white_radps = 0.1 * kDeg;
  errors.wheel_scale = 0.02;
  return errors;
}

TEST(PaperEstimator, LearnsTheSideOffsetsAtTheWalls)
{
  Scene scene(3, uncalibrated());
  scene.robot.rest(1.0);
  scene.robot.sweep_left();
  scene.robot.sweep_right();
  const auto biases = scene.estimator.biases();
  EXPECT_NEAR(biases[0].estimate.value, 0.012, 0.003);
  EXPECT_NEAR(biases[1].estimate.value, -0.010, 0.003);
  double squares = 0.0;
  int samples = 0;
  while (!scene.robot.touches(true)) {
    scene.robot.drive(0.0, 0.15, 0.0, 0.03);
    squares += scene.y_error_m() * scene.y_error_m();
    ++samples;
  }
  EXPECT_LT(std::sqrt(squares / samples), 0.006);
  RecordProperty("y_rms_mm", std::to_string(1e3 * std::sqrt(squares / samples)));
}

// Eq. (3), taken just before a contact is used: the offsets of 12 and -10 mm, then nearly nothing.
TEST(PaperEstimator, ReportsTheContactClosureOfEquation3)
{
  Scene scene(3, uncalibrated());
  scene.robot.rest(1.0);
  scene.robot.sweep_left();
  EXPECT_FALSE(scene.estimate().contact_closure_m) << "one wall only";
  scene.robot.sweep_right();
  scene.robot.rest(0.1);
  ASSERT_TRUE(scene.estimate().contact_closure_m);
  EXPECT_NEAR(*scene.estimate().contact_closure_m, 0.012 - 0.010, 0.008);
  scene.robot.sweep_left();
  scene.robot.sweep_right();
  scene.robot.rest(0.1);
  EXPECT_NEAR(*scene.estimate().contact_closure_m, 0.0, 0.006);
}

TEST(PaperEstimator, LearnsTheFrontDifferenceAtTheSwitches)
{
  SensorErrors errors = uncalibrated();
  Scene scene(3, errors);
  scene.robot.rest(3.0);
  EXPECT_NEAR(scene.yaw_error_rad(), std::atan(0.014 / 0.2), 0.6 * kDeg) << "4 deg before";
  scene.robot.climb(3);
  EXPECT_NEAR(scene.estimator.biases()[2].estimate.value, 0.014, 0.0025);
  scene.robot.rest(1.0);
  EXPECT_NEAR(scene.yaw_error_rad(), 0.0, 1.0 * kDeg);
  scene.robot.drive(0.0, 0.0, 0.05, 2.0);  // 5.7 deg to the left
  EXPECT_NEAR(scene.yaw_error_rad(), 0.0, 1.0 * kDeg) << "no lag in a turn";
}

// Sweeping N - 1 and N block 1 is level with the landing: the gyroscope carries the heading.
TEST(PaperEstimator, CarriesTheHeadingWhereThereIsNoRiser)
{
  SensorErrors errors;
  errors.gyro_bias_radps = 0.3 * kDeg;
  errors.gyro_white_radps = 0.1 * kDeg;
  Scene scene(14, errors);
  scene.robot.rest(1.0);
  scene.robot.climb(14);
  scene.robot.person_m = 0.5;  // on the landing, square to the robot: no riser, whatever it reads
  const double before = scene.estimate().covariance(5, 5);
  scene.robot.drive(0.0, 0.15, 0.05, 2.0);
  scene.robot.drive(0.0, -0.15, 0.0, 10.0);
  EXPECT_NEAR(scene.yaw_error_rad(), 0.0, 0.5 * kDeg);
  EXPECT_GT(scene.estimate().covariance(5, 5), before) << "and doubts it more";
  EXPECT_EQ(scene.estimator.reports()[Source::kFrontPair].outcome, Outcome::kNotVisible);
  EXPECT_EQ(scene.estimate().integrity, Integrity::kOk) << reason_names(scene.estimate().reasons);
}

// At contact the outer beam is 1.5 cm from the wall, which its cone of 25 deg meets after 7 cm; the
// riser is 21 cm away. Taken for a heading that is 36 deg, and 12 deg where the robot stops before.
TEST(PaperEstimator, DoesNotTakeASideWallForATurn)
{
  for (const double gap_m : {0.015, 0.025, 0.035}) {
    Scene scene(3);
    scene.robot.cone_rad = stetro_site::RobotGeometry{}.range_sensor.cone_rad;
    scene.robot.y_m = 1.85;
    scene.robot.rest(1.0);
    ASSERT_EQ(scene.estimator.reports()[Source::kFrontPair].outcome, Outcome::kFused);
    scene.robot.drive(0.0, 0.05, 0.0, (2.05 - 0.1 - gap_m - scene.robot.y_m) / 0.05);
    scene.robot.rest(2.0);
    const SourceReport & pair = scene.estimator.reports()[Source::kFrontPair];
    EXPECT_EQ(pair.outcome, Outcome::kNotVisible) << gap_m;
    EXPECT_EQ(pair.gated, 0u) << gap_m;
    EXPECT_NEAR(scene.yaw_error_rad(), 0.0, 0.01 * kDeg) << gap_m;
    scene.robot.drive(0.0, -0.002, 0.05, 1.0);
    EXPECT_NEAR(scene.yaw_error_rad(), 0.0, 0.1 * kDeg) << "the gyroscope follows a turn";
    EXPECT_EQ(scene.estimate().integrity, Integrity::kOk) << reason_names(scene.estimate().reasons);
  }
}

// The left wall is 1.7 m away: what its sensor says is made up, and the right one knows y.
TEST(PaperEstimator, DoesNotCountNumbersMadeUpBeyondReachAsContradictions)
{
  Scene scene(3);
  scene.robot.y_m = 0.3;
  scene.robot.rest(1.0);
  for (const double made_up_m : {0.2, 0.7, 1.1}) {
    scene.robot.made_up_m = made_up_m;
    scene.robot.rest(1.0);
    EXPECT_EQ(scene.estimator.reports()[Source::kSideLeft].gated, 0u) << made_up_m;
    EXPECT_EQ(scene.estimate().reasons, 0u) << reason_names(scene.estimate().reasons);
    EXPECT_NEAR(scene.y_error_m(), 0.0, 1e-6) << made_up_m;
  }
  EXPECT_EQ(scene.estimate().reset_counter, 0u);
}

TEST(PaperEstimator, IsDegradedWithoutAnySideRangeAndPredicts)
{
  Scene scene(3);
  scene.robot.rest(1.0);
  scene.robot.sides_dead = true;
  scene.robot.drive(0.0, 0.15, 0.0, 2.0);
  EXPECT_EQ(scene.estimate().integrity, Integrity::kDegraded);
  EXPECT_EQ(scene.estimate().reasons, kNoSideRange);
  EXPECT_NEAR(scene.y_error_m(), 0.0, 0.005) << "by the wheels";
  EXPECT_GT(scene.estimate().covariance(1, 1), std::pow(0.03 * 0.25, 2));
  scene.robot.sides_dead = false;
  scene.robot.rest(0.5);
  EXPECT_EQ(scene.estimate().integrity, Integrity::kOk);
}

TEST(PaperEstimator, NoticesAJumpInYAndCountsTheReset)
{
  Scene scene(3);
  scene.robot.rest(1.0);
  scene.robot.y_m += 0.4;  // carried away by hand
  scene.robot.rest(0.2);
  EXPECT_NEAR(scene.y_error_m(), -0.4, 0.01) << "gated at first";
  EXPECT_GT(scene.estimator.reports()[Source::kSideLeft].gated, 0u);
  scene.robot.rest(1.5);
  EXPECT_NEAR(scene.y_error_m(), 0.0, 0.01);
  EXPECT_EQ(scene.estimate().reset_counter, 1u);
  EXPECT_NEAR(scene.estimate().reset_delta.y_m, 0.4, 0.02);
}

// Sides that contradict each other: width and readings do not add up.
TEST(PaperEstimator, IsDegradedWhenTheSidesDoNotAddUp)
{
  Scene scene(3);
  scene.robot.rest(1.0);
  SensorErrors errors;
  errors.offset_m[stetro_site::index_of(Place::kSideLeft)] = -0.30;
  StairRobot wrong(scene.estimator, errors);
  wrong.now = scene.robot.now;
  wrong.stand_on(3);
  wrong.rest(1.0);
  EXPECT_NEAR(scene.estimate().pose.y_m, 1.0, 1e-6) << "the first one is kept";
  EXPECT_GT(scene.estimator.reports()[Source::kSideLeft].gated, 0u);
  EXPECT_EQ(scene.estimate().reasons, kClosureViolated);
}

// The range below block 2 was taken in the air. It does not contradict a touch-down after it.
TEST(PaperEstimator, DoesNotHoldAnOldRangeBelowBlock2AgainstATouchDown)
{
  Scene scene(3);
  scene.robot.rest(1.0);
  scene.robot.bearing[1] = false;
  scene.robot.block_z_m[1] += 0.18;
  scene.robot.rest(0.5);
  ASSERT_EQ(scene.estimate().step, 3);
  scene.robot.block_z_m[1] = 4 * 0.14;  // lowered while no ranges come
  scene.robot.bearing[1] = true;
  for (int i = 0; i < 15; ++i) {
    scene.robot.now += std::chrono::milliseconds(30);
    scene.estimator.add_blocks(scene.robot.blocks(), scene.robot.now);
    if (i == 5) {
      scene.estimator.tick(scene.robot.now);
      EXPECT_EQ(scene.estimate().step, 3) << "0.18 s old: it is waited for the next one";
    }
  }
  scene.estimator.tick(scene.robot.now);
  EXPECT_EQ(scene.estimate().step, 4);
  EXPECT_FALSE(scene.estimate().reasons & kContactConflict);
}

TEST(PaperEstimator, DoesNotBelieveAStuckBumper)
{
  Scene scene(3);
  scene.robot.rest(1.0);
  ContactSample stuck;
  stuck.left.fill({true, false});
  stuck.right = {{{true, false}, {true, true}, {true, false}}};
  stuck.riser_left = stuck.riser_right = {true, false};
  stuck.stamp = scene.robot.now + std::chrono::milliseconds(1);
  scene.estimator.add_contacts(stuck, scene.robot.now);
  scene.estimator.tick(scene.robot.now);
  EXPECT_TRUE(scene.estimate().reasons & kContactConflict);
  EXPECT_EQ(scene.estimator.biases()[1].estimate.value, 0.0) << "nothing learned";
  EXPECT_NEAR(scene.y_error_m(), 0.0, 1e-6);
}

}  // namespace
}  // namespace stetro_localizer
