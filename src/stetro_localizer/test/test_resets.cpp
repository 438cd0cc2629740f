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

// Jumps of the estimate: each counted once, with its cause and how far it went, by both methods.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "stetro_localizer/estimator.hpp"
#include "stetro_localizer/segment_estimator.hpp"
#include "support/stair_robot.hpp"

namespace stetro_localizer
{
namespace
{

std::unique_ptr<Estimator> made(const std::string & method, int initial_step)
{
  LocalizerParams params;
  params.estimator = method;
  params.initial_step = initial_step;
  return make_estimator(params, stetro_site::RobotGeometry{}, papers_flight());
}

class Resets : public testing::TestWithParam<std::string>
{
protected:
  /// On tread 3, y 1.0 m, and known to be.
  void know()
  {
    estimator->begin({});
    robot.stand_on(3);
    robot.rest(1.0);
    ASSERT_EQ(estimate().step, 3);
  }

  [[nodiscard]] const StairEstimate & estimate() const { return estimator->estimate(); }

  std::unique_ptr<Estimator> estimator = made(GetParam(), 3);
  StairRobot robot{*estimator};
};

TEST_P(Resets, AFreshStartIsNone)
{
  know();
  EXPECT_EQ(estimate().reset_counter, 0u);
  EXPECT_EQ(estimate().reset_cause, ResetCause::kNone);
  EXPECT_EQ(estimate().reset_delta.y_m, 0.0);
}

TEST_P(Resets, AClimbHasNone)
{
  know();
  robot.climb(3);
  EXPECT_EQ(estimate().step, 4);
  EXPECT_EQ(estimate().reset_counter, 0u);
}

TEST_P(Resets, ATellingIsOneAndSaysHowFar)
{
  know();
  const stetro_site::Pose before = estimate().pose;
  const auto version = estimator->state_version();
  // two treads higher and 20 cm to the left, where nobody has carried it
  ASSERT_FALSE(
    estimator->tell_pose({robot.x_m + 0.64, 1.2, 5 * 0.14, 0.02}, stetro_site::Covariance::Zero()));
  EXPECT_EQ(estimate().reset_counter, 1u);
  EXPECT_EQ(estimate().reset_cause, ResetCause::kTold);
  EXPECT_EQ(estimate().step, 5);
  EXPECT_NEAR(estimate().reset_delta.x_m, estimate().pose.x_m - before.x_m, 1e-12);
  EXPECT_NEAR(estimate().reset_delta.x_m, 0.64, 0.02);
  EXPECT_NEAR(estimate().reset_delta.y_m, 1.2 - before.y_m, 1e-9);
  EXPECT_NEAR(estimate().reset_delta.z_m, 2 * 0.14, 1e-9);
  EXPECT_NEAR(estimate().reset_delta.yaw_rad, 0.02 - before.yaw_rad, 1e-9);
  EXPECT_NE(estimator->state_version(), version) << "worth storing";
}

// Told where it stands, the estimate is not begun anew when the blocks agree.
TEST_P(Resets, ATellingIsOneJumpAndKeepsWhatWasTold)
{
  know();
  robot.x_m -= 0.10;
  robot.y_m = 0.9;  // carried by hand
  robot.front_dead = true;
  robot.sides_dead = true;  // nothing but the telling says so
  ASSERT_FALSE(
    estimator->tell_pose({robot.x_m, robot.y_m, 3 * 0.14, 0.0}, stetro_site::Covariance::Zero()));
  robot.rest(1.0);
  EXPECT_EQ(estimate().reset_counter, 1u);
  EXPECT_EQ(estimate().step, 3);
  EXPECT_NEAR(estimate().pose.y_m, 0.9, 0.01);
  if (GetParam() == "fused") {  // the other always says the middle of the tread
    EXPECT_NEAR(estimate().pose.x_m, robot.x_m, 0.01);
  }
}

TEST_P(Resets, ATellingThatIsRefusedIsNone)
{
  know();
  EXPECT_TRUE(estimator->tell_pose({robot.x_m, 9.0, 3 * 0.14, 0.0}, {}));
  EXPECT_EQ(estimate().reset_counter, 0u);
}

TEST_P(Resets, WhatWasUnknownMovedByAnUnknownWay)
{
  estimator = made(GetParam(), -1);
  estimator->begin({});
  StairRobot lost(*estimator);
  lost.stand_on(3);
  lost.rest(1.0);
  ASSERT_FALSE(estimate().step);
  ASSERT_FALSE(estimator->tell_pose({lost.x_m, 1.0, 3 * 0.14, 0.0}, {}));
  EXPECT_EQ(estimate().reset_counter, 1u);
  EXPECT_EQ(estimate().reset_cause, ResetCause::kTold);
  EXPECT_TRUE(std::isnan(estimate().reset_delta.x_m));
  EXPECT_TRUE(std::isnan(estimate().reset_delta.z_m));
}

TEST_P(Resets, ARestartIsOneFromTheStoredNumberOn)
{
  know();
  ASSERT_FALSE(estimator->tell_pose({robot.x_m, 1.1, 3 * 0.14, 0.0}, {}));
  robot.rest(1.0);
  const StateReading stored{StateReading::Kind::kFound, estimator->state_to_store(), ""};
  ASSERT_EQ(stored.state.reset_counter, estimate().reset_counter);
  const std::unique_ptr<Estimator> after = made(GetParam(), -1);
  after->begin(stored);
  EXPECT_EQ(after->estimate().reset_counter, stored.state.reset_counter + 1);
  EXPECT_EQ(after->estimate().reset_cause, ResetCause::kRestarted);
  EXPECT_TRUE(std::isnan(after->estimate().reset_delta.x_m));
  StairRobot same(*after);
  same.stand_on(3);
  same.now = robot.now;
  same.rest(1.0);
  EXPECT_EQ(after->estimate().step, 3);
  EXPECT_EQ(after->estimate().reset_counter, stored.state.reset_counter + 1) << "one, not two";
}

TEST_P(Resets, AStepThatIsTakenBackIsOne)
{
  know();
  robot.bearing[1] = false;
  robot.block_z_m[1] += 0.18;
  robot.rest(0.5);
  robot.drive(0.05, 0.0, 0.0, 3.2);
  robot.block_z_m[1] = 4 * 0.14;
  robot.bearing[1] = true;
  robot.rest(0.5);
  ASSERT_EQ(estimate().step, 4);
  const std::uint32_t before = estimate().reset_counter;
  robot.drive(-0.05, 0.0, 0.0, 3.2);
  robot.bearing[1] = false;
  robot.block_z_m[1] = 3 * 0.14 + 0.16;
  robot.rest(0.5);
  robot.block_z_m[1] = 3 * 0.14;  // it has slipped off the nosing
  robot.bearing[1] = true;
  robot.rest(0.5);
  ASSERT_EQ(estimate().step, 3);
  EXPECT_EQ(estimate().reset_counter, before + 1);
  EXPECT_EQ(estimate().reset_cause, ResetCause::kStepUndone);
  EXPECT_NEAR(estimate().reset_delta.z_m, -0.14, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
  Estimators, Resets, testing::Values("paper", "fused"),
  [](const testing::TestParamInfo<std::string> & method) { return method.param; });

// Only the paper's method measures one coordinate anew while it keeps the others.
TEST(PaperResets, SayWhichCoordinateWasMeasuredAnew)
{
  const auto estimator = made("paper", 3);
  StairRobot robot(*estimator);
  estimator->begin({});
  robot.stand_on(3);
  robot.rest(1.0);
  robot.y_m += 0.4;  // carried away by hand
  robot.rest(1.5);
  EXPECT_EQ(estimator->estimate().reset_counter, 1u);
  EXPECT_EQ(estimator->estimate().reset_cause, ResetCause::kAcrossAnew);
  EXPECT_NEAR(estimator->estimate().reset_delta.y_m, 0.4, 0.02);
  robot.yaw_rad += 0.2;  // turned by hand, and the gyroscope was not looking
  robot.rest(2.0);
  EXPECT_EQ(estimator->estimate().reset_cause, ResetCause::kHeadingAnew);
  EXPECT_NEAR(estimator->estimate().reset_delta.yaw_rad, 0.2, 0.02);
  EXPECT_GE(estimator->estimate().reset_counter, 2u);
}

TEST(ResetCause, IsToldInWordsOfItsOwn)
{
  EXPECT_STREQ(to_string(ResetCause::kNone), "none");
  for (int i = 1; i < static_cast<int>(ResetCause::kHeadingAnew); ++i) {
    const std::string text = to_string(static_cast<ResetCause>(i));
    EXPECT_NE(text, to_string(static_cast<ResetCause>(i + 1)));
    EXPECT_NE(text, "unknown");
  }
}

}  // namespace
}  // namespace stetro_localizer
