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
#include <stdexcept>

#include "stetro_localizer/paper_estimator.hpp"
#include "support/stair_robot.hpp"

namespace stetro_localizer
{
namespace
{

LocalizerParams params_with(int initial_step)
{
  LocalizerParams params;
  params.initial_step = initial_step;
  return params;
}

PaperEstimator fresh(int initial_step = 0)
{
  return {params_with(initial_step), stetro_site::RobotGeometry{}, papers_flight()};
}

StateReading found(const StoredState & state) { return {StateReading::Kind::kFound, state, ""}; }

/// An estimator that knows step 3, with its robot.
struct Known
{
  Known()
  {
    estimator.begin({});
    robot.stand_on(3);
    robot.rest(1.0);
  }

  PaperEstimator estimator = fresh(3);
  StairRobot robot{estimator};
};

/// The seconds until a restarted estimator is OK, on the robot as it now stands.
std::optional<double> seconds_until_ok(PaperEstimator & estimator, StairRobot & robot)
{
  const Nanoseconds start = robot.now;
  while (robot.now < start + std::chrono::seconds(5)) {
    robot.rest(0.01);
    if (estimator.estimate().integrity == Integrity::kOk) {
      return seconds(robot.now - start);
    }
  }
  return std::nullopt;
}

StairRobot moved_to(PaperEstimator & estimator, const StairRobot & from)
{
  StairRobot robot(estimator);
  robot.x_m = from.x_m;
  robot.y_m = from.y_m;
  robot.block_z_m = from.block_z_m;
  robot.bearing = from.bearing;
  robot.now = from.now;
  return robot;
}

TEST(Restart, GoesOnFromTheStoredStepWithinASecond)
{
  Known before;
  PaperEstimator after = fresh();
  after.begin(found(before.estimator.state_to_store()));
  EXPECT_EQ(after.estimate().integrity, Integrity::kLost);
  StairRobot robot = moved_to(after, before.robot);
  const auto wait_s = seconds_until_ok(after, robot);
  ASSERT_TRUE(wait_s) << reason_names(after.estimate().reasons);
  EXPECT_LT(*wait_s, 1.0);
  EXPECT_EQ(after.estimate().step, 3);
  EXPECT_EQ(after.estimate().reset_counter, 1u) << "a restart is a jump";
}

TEST(Restart, ResolvesATouchDownThatNobodySaw)
{
  Known before;
  before.robot.bearing[1] = false;
  before.robot.block_z_m[1] += 0.18;
  before.robot.rest(0.5);
  before.robot.drive(0.05, 0.0, 0.0, 3.2);
  PaperEstimator after = fresh();
  after.begin(found(before.estimator.state_to_store()));
  before.robot.block_z_m[1] = 4 * 0.14;
  before.robot.bearing[1] = true;
  StairRobot robot = moved_to(after, before.robot);
  ASSERT_TRUE(seconds_until_ok(after, robot)) << reason_names(after.estimate().reasons);
  EXPECT_EQ(after.estimate().step, 4);
}

TEST(Restart, IsLostWhenTheBlocksDoNotFitUntilTold)
{
  Known before;
  PaperEstimator after = fresh();
  after.begin(found(before.estimator.state_to_store()));
  StairRobot robot(after);
  robot.stand_on(0);  // somebody carried it to the floor: level
  robot.rest(2.0);
  EXPECT_EQ(after.estimate().integrity, Integrity::kLost);
  EXPECT_TRUE(after.estimate().reasons & kStepUncertain);
  EXPECT_FALSE(after.tell_pose({-0.5, 1.0, 0.0, 0.0}, stetro_site::Covariance::Zero()));
  ASSERT_TRUE(seconds_until_ok(after, robot)) << reason_names(after.estimate().reasons);
  EXPECT_EQ(after.estimate().step, 0);
}

TEST(Restart, DoesNotUseADamagedFile)
{
  PaperEstimator after = fresh(0);
  after.begin({StateReading::Kind::kDamaged, {}, "cut off"});
  StairRobot robot(after);
  robot.stand_on(0);
  robot.rest(1.0);
  EXPECT_EQ(after.estimate().integrity, Integrity::kLost)
    << "a history that cannot be read is not the same as none";
  EXPECT_TRUE(after.estimate().reasons & kCalibrationDamaged);
}

TEST(Restart, KnowsAFreshRobotOnlyWhereItCanBeOnlyThere)
{
  PaperEstimator foot = fresh(0);
  foot.begin({});
  StairRobot level(foot);
  level.stand_on(0);
  level.front_dead = true;
  level.rest(1.0);
  EXPECT_EQ(foot.estimate().step, 0);
  EXPECT_EQ(foot.estimate().integrity, Integrity::kDegraded) << "no riser seen: the landing?";
  level.front_dead = false;
  level.rest(0.5);
  EXPECT_EQ(foot.estimate().integrity, Integrity::kOk) << reason_names(foot.estimate().reasons);

  PaperEstimator stairs = fresh(0);
  stairs.begin({});
  StairRobot climbing(stairs);
  climbing.stand_on(7);
  climbing.rest(1.0);
  EXPECT_EQ(stairs.estimate().integrity, Integrity::kLost) << "any tread looks like this";

  PaperEstimator unknown = fresh(-1);
  unknown.begin({});
  StairRobot any(unknown);
  any.stand_on(0);
  any.rest(1.0);
  EXPECT_EQ(unknown.estimate().reasons & kNotInitialised, kNotInitialised);
  EXPECT_EQ(unknown.estimate().integrity, Integrity::kLost);
}

TEST(Restart, IsNotOkOnTheFloorWhileXIsUnknown)
{
  PaperEstimator before = fresh(0);
  before.begin({});
  StairRobot level(before);
  level.stand_on(0);
  level.rest(1.0);
  ASSERT_EQ(before.estimate().integrity, Integrity::kOk);
  PaperEstimator after = fresh();
  after.begin(found(before.state_to_store()));
  StairRobot robot = moved_to(after, level);
  robot.front_dead = true;
  robot.rest(1.0);
  EXPECT_EQ(after.estimate().step, 0);
  EXPECT_TRUE(std::isnan(after.estimate().pose.x_m));
  EXPECT_EQ(after.estimate().integrity, Integrity::kDegraded);
  EXPECT_EQ(after.estimate().reasons, kNoFrontReference);
  robot.front_dead = false;
  robot.rest(0.5);
  EXPECT_EQ(after.estimate().integrity, Integrity::kOk) << reason_names(after.estimate().reasons);
}

TEST(Restart, DoesNotUseAStepThatTheFlightDoesNotHave)
{
  for (const int step : {-1, 17}) {
    Known before;
    StoredState state = before.estimator.state_to_store();
    state.step->step = step;
    PaperEstimator after = fresh();
    after.begin(found(state));
    StairRobot robot = moved_to(after, before.robot);
    robot.rest(1.0);
    EXPECT_EQ(after.estimate().integrity, Integrity::kLost) << step;
    EXPECT_TRUE(after.estimate().reasons & kNotInitialised) << step;
  }
  EXPECT_THROW(fresh(17).begin({}), std::invalid_argument);
}

TEST(Restart, KeepsTheCalibration)
{
  Known before;
  StoredState state = before.estimator.state_to_store();
  state.calibration.left.offset = {0.011, 1e-6};
  state.calibration.gyro_bias = {0.004, 1e-10};
  PaperEstimator after = fresh();
  after.begin(found(state));
  EXPECT_EQ(after.biases()[0].estimate.value, 0.011);
  EXPECT_EQ(after.biases()[3].estimate.value, 0.004);
}

TEST(Restart, StoresOnlyWhatItIsSureOf)
{
  Known known;
  const auto version = known.estimator.state_version();
  known.robot.rest(1.0);
  EXPECT_EQ(known.estimator.state_version(), version) << "nothing changed, nothing to write";
  known.robot.bearing[1] = false;
  known.robot.rest(0.2);
  EXPECT_GT(known.estimator.state_version(), version);
  known.robot.block_z_m[1] += 0.07;
  known.robot.bearing[1] = true;
  known.robot.rest(0.2);
  EXPECT_FALSE(known.estimator.state_to_store().step) << "half a riser: lost";
}

TEST(TellPose, RefusesWithAReason)
{
  Known known;
  const auto refusal = [&](double x, double y, double z, double yaw) {
    return known.estimator.tell_pose({x, y, z, yaw}, stetro_site::Covariance::Zero()).value_or("");
  };
  EXPECT_NE(refusal(0.5, 1.0, 0.0, 0.0).find("height"), std::string::npos);
  EXPECT_NE(refusal(0.5, 3.0, 0.28, 0.0).find("walls"), std::string::npos);
  EXPECT_NE(refusal(0.5, 1.0, 0.28, 2.0).find("face"), std::string::npos);
  EXPECT_NE(refusal(std::nan(""), 1.0, 0.28, 0.0).find("finite"), std::string::npos);
  EXPECT_EQ(known.estimator.estimate().reset_counter, 0u);
  EXPECT_EQ(refusal(2.5 * 0.32, 1.02, 3 * 0.14, 0.0), "");
  EXPECT_EQ(known.estimator.estimate().reset_counter, 1u);
  EXPECT_NEAR(known.estimator.estimate().reset_delta.y_m, 0.02, 1e-6);
}

}  // namespace
}  // namespace stetro_localizer
