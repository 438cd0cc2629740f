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
#include <optional>
#include <string>
#include <vector>

#include "stetro_localizer/fused_estimator.hpp"
#include "stetro_localizer/stored_state.hpp"
#include "support/fused_rig.hpp"

namespace stetro_localizer
{
namespace
{

using std::chrono::milliseconds;

TEST(FusedEstimator, CalibratesItselfAtTheWalls)
{
  Rig rig(3, uncalibrated());
  for (int i = 0; i < 3; ++i) {
    rig.sweep();
  }
  rig.robot.drive(0.0, 0.15, 0.0, 3.0);
  EXPECT_LT(std::abs(rig.y_error_m()), 0.006);
  EXPECT_LT(std::abs(rig.y_error_m()), rig.estimate().protection_across_m);
  EXPECT_LT(rig.estimate().protection_across_m, 0.03);
  EXPECT_EQ(rig.estimate().integrity, Integrity::kOk) << reason_names(rig.estimate().reasons);
}

TEST(FusedEstimator, FollowsTheStepsUp)
{
  Rig rig(0, uncalibrated());
  rig.robot.approach();
  for (int step = 0; step < 3; ++step) {
    rig.robot.climb(step);
    EXPECT_EQ(rig.estimate().step, step + 1);
    EXPECT_GT(rig.estimate().step_probability, 0.999);
    rig.sweep();
  }
  EXPECT_NEAR(rig.estimate().pose.z_m, 3 * 0.14, 0.003);
  EXPECT_NEAR(rig.estimate().pose.x_m, rig.robot.x_m, 0.015);
  EXPECT_NEAR(rig.estimate().pose.yaw_rad, rig.robot.yaw_rad, 0.01);
}

// Three treads of 2.5 mm and three risers of 1.5 mm lie between the foot of the stairs and tread 3.
// On the tread x is told from the riser ahead, whose direction is doubtful, too: a hair here, for
// the robot stands 2.5 cm off the middle.
TEST(FusedEstimator, DoubtsTheFlightFrameMoreThanTheTread)
{
  Rig rig(3, uncalibrated());
  const StairEstimate & at = rig.estimate();
  EXPECT_NEAR(at.covariance(0, 0) - at.tread_covariance(0, 0), 3 * 0.0025 * 0.0025, 3e-8);
  EXPECT_NEAR(at.covariance(2, 2) - at.tread_covariance(2, 2), 3 * 0.0015 * 0.0015, 1e-12);
  EXPECT_EQ(at.covariance(1, 1), at.tread_covariance(1, 1));
  EXPECT_EQ(at.covariance(5, 5), at.tread_covariance(5, 5));
  Rig floor(0, uncalibrated());
  EXPECT_TRUE(floor.estimate().covariance.isApprox(floor.estimate().tread_covariance, 1e-3));
}

TEST(FusedEstimator, MeasuresTheStairsThatItClimbs)
{
  Rig rig(0, uncalibrated());
  EXPECT_TRUE(rig.estimator.staircase_as_built().empty()) << "the floor is no step";
  rig.robot.approach();
  for (int step = 0; step < 4; ++step) {
    rig.robot.climb(step);
    rig.sweep();
  }
  const auto steps = rig.estimator.staircase_as_built();
  ASSERT_EQ(steps.size(), 4u);
  for (const StepAsBuilt & one : steps) {
    ASSERT_TRUE(one.tread_m) << one.step;
    const double sigma_m = std::sqrt(one.tread_m->variance);
    EXPECT_LT(sigma_m, 0.0025) << one.step << ": no better than the site file";
    EXPECT_LT(std::abs(one.tread_m->value - 0.32), 3.0 * sigma_m) << one.step;
  }
}

TEST(FusedEstimator, BadSamplesChangeNothing)
{
  Rig rig(3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Nanoseconds now = rig.robot.now;
  rig.estimator.tick(now);
  const double y_m = rig.estimate().pose.y_m;
  EXPECT_EQ(rig.estimator.add_gyro({Nanoseconds{0}, 1.0}, now).refusal, Refusal::kZeroStamp);
  EXPECT_EQ(
    rig.estimator.add_gyro({now + std::chrono::seconds(1), 1.0}, now).refusal, Refusal::kFuture);
  EXPECT_EQ(
    rig.estimator.add_gyro({now - std::chrono::seconds(1), 1.0}, now).refusal, Refusal::kTooOld);
  EXPECT_EQ(rig.estimator.add_gyro({now, nan}, now).refusal, Refusal::kNotFinite);
  EXPECT_EQ(rig.estimator.add_odometry({now, 0.0, nan, 0.0}, now).refusal, Refusal::kNotFinite);
  BlockSample blocks;
  blocks.stamp = now;
  blocks.blocks[1].height_m = -0.1;
  EXPECT_EQ(rig.estimator.add_blocks(blocks, now).refusal, Refusal::kNegative);
  rig.estimator.tick(now);
  EXPECT_EQ(rig.estimate().pose.y_m, y_m);
  EXPECT_EQ(rig.estimator.reports()[Source::kGyro].refused_total(), 4u);
}

TEST(FusedEstimator, BadRangesAreRefusedAndCounted)
{
  Rig rig(3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Nanoseconds now = rig.robot.now + milliseconds(5);
  const double y_m = rig.estimate().pose.y_m;
  const auto refusal_of = [&](Nanoseconds stamp) {
    RangeSample ranges = rig.robot.ranges();
    ranges.stamp = stamp;
    return rig.estimator.add_ranges(ranges, now).refusal;
  };
  EXPECT_EQ(refusal_of(Nanoseconds{0}), Refusal::kZeroStamp);
  EXPECT_EQ(refusal_of(now + std::chrono::seconds(1)), Refusal::kFuture);
  EXPECT_EQ(refusal_of(now - std::chrono::seconds(1)), Refusal::kTooOld);
  EXPECT_EQ(rig.estimator.reports()[Source::kRanges].refused_total(), 3u);

  RangeSample none = rig.robot.ranges();
  none.stamp = now;
  for (RangeReading & reading : none.readings) {
    reading = {now, 0.0, 0.0, RangeStatus::kAbsent};
  }
  none[Place::kSideLeft] = {now, nan, 0.0, RangeStatus::kValid};
  none[Place::kSideRight] = {now, -0.2, 0.0, RangeStatus::kValid};
  none[Place::kFrontLeft] = {Nanoseconds{0}, 0.3, 0.0, RangeStatus::kValid};
  (void)rig.estimator.add_ranges(none, now);
  const SourceReport & report = rig.estimator.reports()[Source::kRanges];
  EXPECT_EQ(report.refused[static_cast<std::size_t>(Refusal::kNotFinite)], 1u);
  EXPECT_EQ(report.refused[static_cast<std::size_t>(Refusal::kNegative)], 1u);
  EXPECT_EQ(report.refused[static_cast<std::size_t>(Refusal::kZeroStamp)], 2u);
  EXPECT_EQ(rig.estimator.add_ranges(none, now).refusal, Refusal::kOutOfOrder) << "twice the same";
  EXPECT_NEAR(rig.estimate().pose.y_m, y_m, 1e-4);
}

// Between two arrays of ranges a tick makes no estimate of its own.
TEST(FusedEstimator, ATickWaitsForTheRanges)
{
  Rig rig(3, uncalibrated());
  rig.robot.drive(0.0, 0.1, 0.0, 1.0);
  const StairEstimate before = rig.estimate();
  ASSERT_FALSE(
    rig.estimator.add_gyro({rig.robot.now + milliseconds(5), 0.0}, rig.robot.now).is_refused());
  rig.estimator.tick(rig.robot.now + milliseconds(5));
  EXPECT_EQ(rig.estimate().stamp, before.stamp);
  EXPECT_EQ(rig.estimate().pose.y_m, before.pose.y_m);
}

// The wheels alone bring none, nor does the gyroscope: one would roll where the other turns.
TEST(FusedEstimator, FollowsTheMotionBetweenRanges)
{
  Rig rig(3, uncalibrated());
  rig.robot.drive(0.0, 0.1, 0.0, 1.0);
  const StairEstimate before = rig.estimate();
  const Nanoseconds later = rig.robot.now + milliseconds(10);
  ASSERT_FALSE(rig.estimator.add_odometry({later, 0.0, 0.1, 0.0}, later).is_refused());
  EXPECT_EQ(rig.estimate().stamp, before.stamp);
  ASSERT_FALSE(rig.estimator.add_gyro({later, 0.0}, later).is_refused());
  EXPECT_EQ(rig.estimate().stamp, later);
  const double rolled_m = 0.1 * seconds(later - before.stamp);
  EXPECT_NEAR(rig.estimate().pose.y_m - before.pose.y_m, rolled_m, 2e-4);
}

// Before the first ranges nothing is known that motion could carry on.
TEST(FusedEstimator, DoesNotFollowTheMotionBeforeTheRanges)
{
  FusedEstimator estimator(params_with(0), stetro_site::RobotGeometry{}, papers_flight());
  estimator.begin({});
  const Nanoseconds now = std::chrono::seconds(1);
  ASSERT_FALSE(estimator.add_odometry({now, 0.0, 0.0, 0.0}, now).is_refused());
  ASSERT_FALSE(estimator.add_gyro({now, 0.0}, now).is_refused());
  EXPECT_EQ(estimator.estimate().stamp, Nanoseconds{0});
}

// The motion goes on for 0.1 s as it was; from then on the robot may have stopped as well as not,
// and y is known to 0.15 m/s times 0.5 s. The next sample knows better.
TEST(FusedEstimator, PredictsWhenItsInputsAreSilent)
{
  Rig rig(3, uncalibrated());
  rig.robot.drive(0.0, 0.1, 0.0, 2.0);
  const StairEstimate before = rig.estimate();
  const double y_error_m = rig.y_error_m();
  ASSERT_EQ(before.integrity, Integrity::kOk) << reason_names(before.reasons);
  const Nanoseconds later = rig.robot.now + milliseconds(600);
  rig.estimator.tick(later);
  EXPECT_EQ(rig.estimate().stamp, later);
  EXPECT_TRUE(rig.estimate().reasons & kInputSilent);
  EXPECT_NEAR(rig.estimate().pose.y_m - before.pose.y_m, 0.01, 0.003);
  EXPECT_NEAR(std::sqrt(rig.estimate().covariance(1, 1)), 0.075, 0.01);
  rig.robot.now = later;
  rig.robot.rest(0.3);
  rig.estimator.tick(rig.robot.now);
  EXPECT_FALSE(rig.estimate().reasons & kInputSilent);
  EXPECT_NEAR(rig.y_error_m(), y_error_m, 0.01);
}

TEST(FusedEstimator, KeepsStepAndCalibrationOverARestart)
{
  Rig rig(3, uncalibrated());
  for (int i = 0; i < 3; ++i) {
    rig.sweep();
  }
  rig.robot.drive(0.0, 0.15, 0.0, 3.0);
  std::string why;
  const auto kept = parse_stored_state(to_text(rig.estimator.state_to_store()), why);
  ASSERT_TRUE(kept) << why;

  FusedEstimator again(params_with(0), stetro_site::RobotGeometry{}, papers_flight());
  StateReading found;
  found.kind = StateReading::Kind::kFound;
  found.state = *kept;
  again.begin(found);
  StairRobot robot(again, uncalibrated(), 2);
  robot.x_m = rig.robot.x_m;
  robot.y_m = rig.robot.y_m;
  robot.yaw_rad = rig.robot.yaw_rad;
  robot.block_z_m = rig.robot.block_z_m;
  robot.now = rig.robot.now + milliseconds(500);
  robot.rest(3.0);
  EXPECT_EQ(again.estimate().step, 3);
  EXPECT_EQ(again.estimate().integrity, Integrity::kOk) << reason_names(again.estimate().reasons);
  EXPECT_NEAR(again.estimate().pose.y_m, robot.y_m, 0.008);
  EXPECT_GT(again.estimate().reset_counter, kept->reset_counter);
}

TEST(FusedEstimator, ADamagedStateFileIsLost)
{
  FusedEstimator estimator(params_with(0), stetro_site::RobotGeometry{}, papers_flight());
  StateReading damaged;
  damaged.kind = StateReading::Kind::kDamaged;
  estimator.begin(damaged);
  StairRobot robot(estimator);
  robot.stand_on(0);
  robot.rest(1.0);
  EXPECT_EQ(estimator.estimate().integrity, Integrity::kLost);
  EXPECT_TRUE(estimator.estimate().reasons & kCalibrationDamaged);
}

TEST(FusedEstimator, TakesAPoseThatAPersonTells)
{
  Rig rig(-1, uncalibrated());
  EXPECT_EQ(rig.estimate().integrity, Integrity::kLost);
  rig.robot.stand_on(5);
  stetro_site::Pose pose{rig.robot.x_m, 9.0, 0.7, 0.0};
  EXPECT_TRUE(rig.estimator.tell_pose(pose, stetro_site::Covariance::Zero()));
  pose.y_m = 1.01;
  EXPECT_FALSE(rig.estimator.tell_pose(pose, stetro_site::Covariance::Zero()));
  rig.robot.rest(2.0);
  EXPECT_EQ(rig.estimate().step, 5);
  EXPECT_EQ(rig.estimate().integrity, Integrity::kOk) << reason_names(rig.estimate().reasons);
  EXPECT_NEAR(rig.estimate().pose.y_m, rig.robot.y_m, 0.012);
}

TEST(FusedEstimator, ListsWhatItComparesAndAllThatItLearns)
{
  Rig rig(3, uncalibrated());
  rig.robot.drive(0.0, 0.1, 0.0, 1.0);
  std::string compared;
  for (const Source source : rig.estimator.compared()) {
    const SourceReport & report = rig.estimator.reports()[source];
    compared += std::string(to_string(source)) + (report.fused > 0 ? "+ " : " ");
    EXPECT_EQ(std::isfinite(report.innovation), report.fused + report.gated > 0);
  }
  EXPECT_EQ(
    compared,
    "side_left+ side_right+ front_left+ front_right+ block3_front bumper_left bumper_right "
    "riser_switches gyro_at_rest+ wheels_along+ wheels_across+ ");
  const std::vector<Bias> biases = rig.estimator.biases();
  EXPECT_EQ(biases.size(), 12u) << "offset and gain of five sensors, gyroscope, wheels";
  for (const Bias & bias : biases) {
    EXPECT_GT(bias.estimate.variance, 0.0) << bias.name;
  }
}

// Nose down by 0.3 rad, as when it hangs over a nosing: level blocks 15 cm apart then read 4.64 cm,
// 0.15 m tan 0.3, apart, and a robot at the foot of the stairs stands level.
TEST(FusedEstimator, PitchIsEvidenceOfTheStep)
{
  FusedModel model(LocalizerParams{}, stetro_site::RobotGeometry{}, papers_flight());
  const double apart_m = 0.15 * std::tan(0.3);
  for (const bool known : {false, true}) {
    FusedCore core = model.begin();
    core.steps.assume_foot();
    Nanoseconds now = std::chrono::seconds(1000);
    for (int i = 0; i < 60; ++i) {
      now += milliseconds(33);
      const auto pitch_rad = known ? std::optional<double>(0.3) : std::nullopt;
      model.take(core, Sample(GyroSample{now, 0.0, pitch_rad}));
      BlockSample blocks;
      blocks.stamp = now;
      blocks.blocks[0] = {2.0 * apart_m, 0.33, true, false, false};
      blocks.blocks[1] = {apart_m, 0.33, true, false, false};
      blocks.blocks[2] = {0.0, 0.33, true, false, false};
      model.take(core, Sample(blocks));
    }
    EXPECT_EQ(core.steps.lost(), !known);
  }
}

}  // namespace
}  // namespace stetro_localizer
