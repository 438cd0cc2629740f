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

#include "stetro_localizer/fused/standing_gyro_aiding.hpp"
#include "support/jacobian.hpp"
#include "support/standing_robot.hpp"

namespace stetro_localizer
{
namespace
{

TEST(StandingGyroAiding, JacobianHolds)
{
  expect_jacobian_holds([](const StateVector & state) { return expect_standing_gyro(state); });
}

// 200 samples of sigma 1.75 mrad/s make a mean of 0.12 mrad/s; one that is off by 11, six
// sigmas, is not one of them.
TEST(StandingGyroAiding, LearnsTheBiasAndGatesAJolt)
{
  StandingRobot robot;
  Nanoseconds stamp = robot.core.time;
  const auto stand = [&](double rate_radps) {
    stamp += std::chrono::milliseconds(10);
    robot.take(OdometrySample{stamp, 0.0, 0.0, 0.0});
    robot.take(GyroSample{stamp, rate_radps});
  };
  for (int i = 0; i < 300; ++i) {
    stand(0.004 + robot.random(0.00175));
  }
  const SourceReport & report = robot.core.reports[Source::kStandingGyro];
  EXPECT_GT(report.fused, 200u);
  EXPECT_NEAR(robot.core.filter[kStateGyroBias], 0.004, 0.0005);
  const double before_radps = robot.core.filter[kStateGyroBias];
  stand(0.015);
  EXPECT_EQ(report.outcome, Outcome::kGated);
  EXPECT_EQ(robot.core.filter[kStateGyroBias], before_radps);
}

}  // namespace
}  // namespace stetro_localizer
