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

#include "stetro_localizer/fused/wheel_aiding.hpp"
#include "support/jacobian.hpp"
#include "support/standing_robot.hpp"

namespace stetro_localizer
{
namespace
{

TEST(WheelAiding, JacobianHolds)
{
  for (const int axis : {kStateVx, kStateVy}) {
    expect_jacobian_holds([axis](const StateVector & state) { return expect_wheels(state, axis); });
  }
}

TEST(WheelAiding, WheelsCountTheirScaleToo)
{
  StateVector state = StateVector::Zero();
  state[kStateVx] = 0.05;
  state[kStateOdomScale] = 0.02;
  EXPECT_NEAR(expect_wheels(state, kStateVx).value(), 0.051, 1e-12);
}

// Between two samples the speed may change by 0.3 m/s, one standard deviation: 0.15 m/s pass their
// gate, 3.9 deviations, and 2 m/s do not. What is refused changes nothing, and is told.
TEST(WheelAiding, ASpeedThatNoMotorReachesIsGated)
{
  StandingRobot robot;
  const Nanoseconds later = robot.core.time + std::chrono::milliseconds(10);
  robot.take(OdometrySample{later, 0.15, 0.0, 0.0});
  const SourceReport & along = robot.core.reports[Source::kWheelsAlong];
  EXPECT_EQ(along.outcome, Outcome::kFused);
  EXPECT_NEAR(robot.core.filter[kStateVx], 0.15, 1e-3);
  const double before_mps = robot.core.filter[kStateVx];
  robot.take(OdometrySample{later + std::chrono::milliseconds(10), 2.0, 0.0, 0.0});
  EXPECT_EQ(along.outcome, Outcome::kGated);
  EXPECT_NEAR(along.innovation, 1.85, 1e-3);
  EXPECT_GT(along.test_ratio, 1.0);
  EXPECT_EQ(robot.core.filter[kStateVx], before_mps);
  EXPECT_EQ(robot.core.reports[Source::kWheelsAcross].outcome, Outcome::kFused);
}

}  // namespace
}  // namespace stetro_localizer
