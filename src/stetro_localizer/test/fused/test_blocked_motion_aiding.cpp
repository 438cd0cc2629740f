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

#include "stetro_localizer/fused/blocked_motion_aiding.hpp"
#include "support/jacobian.hpp"
#include "support/standing_robot.hpp"

namespace stetro_localizer
{
namespace
{

TEST(BlockedMotionAiding, JacobianHolds)
{
  for (const int axis : {kStateVx, kStateVy}) {
    expect_jacobian_holds(
      [axis](const StateVector & state) { return expect_blocked(state, axis); });
  }
}

// Wheels that turn towards a closed bumper move nothing; away from it they do.
TEST(BlockedMotionAiding, ARobotAtTheWallDoesNotMoveIntoIt)
{
  for (const double vy_mps : {0.15, -0.15}) {
    StandingRobot robot;
    ContactSample contacts;
    contacts.stamp = robot.core.time;
    contacts.left[1] = {true, true};
    robot.take(contacts);
    robot.take(OdometrySample{robot.core.time + std::chrono::milliseconds(10), 0.0, vy_mps, 0.0});
    EXPECT_NEAR(robot.core.filter[kStateVy], vy_mps > 0.0 ? 0.0 : vy_mps, 1e-3);
    EXPECT_EQ(robot.core.reports[Source::kWheelsAcross].outcome, Outcome::kFused);
  }
}

}  // namespace
}  // namespace stetro_localizer
