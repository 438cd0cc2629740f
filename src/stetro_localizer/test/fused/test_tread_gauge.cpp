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

#include "stetro_localizer/fused/tread_gauge.hpp"
#include "support/standing_robot.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kCalibration = 0.003 * 0.003;

TEST(TreadGauge, AveragesFromATouchOn)
{
  TreadGauge gauge;
  EXPECT_FALSE(gauge.x_m(1.0)) << "not touched yet";
  gauge.touch(-0.075, 1.0);
  EXPECT_NEAR(*gauge.x_m(0.998), -0.077, 1e-12);
  EXPECT_FALSE(gauge.x_m(0.99)) << "backed off: slips count from here on";
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(gauge.depth_m(kCalibration)) << i;
    gauge.add(i % 2 == 0 ? 0.33 : 0.32, 0.005 * 0.005);
  }
  ASSERT_TRUE(gauge.depth_m(kCalibration));
  EXPECT_NEAR(gauge.depth_m(kCalibration)->value, 0.325, 1e-12);
  // The calibration's 3 mm, the touch's 2 mm and 5 mm of ten readings.
  EXPECT_NEAR(gauge.depth_m(kCalibration)->variance, 9e-6 + 4e-6 + 2.5e-6, 1e-12);
}

TEST(TreadGauge, CountsFromTheSecondSwitchAndNotFromASweep)
{
  TreadGauge gauge;
  gauge.touch(-0.070, 1.0);
  gauge.add(0.3, 1e-6);
  gauge.touch(-0.075, 1.001);
  for (int i = 0; i < 10; ++i) {
    gauge.add(0.33, 1e-6);
  }
  gauge.touch(-0.060, 1.2);
  ASSERT_TRUE(gauge.depth_m(kCalibration));
  EXPECT_NEAR(gauge.depth_m(kCalibration)->value, 0.33, 1e-12) << "the first touch was turned";
}

/// A robot on tread 3 that has just touched riser 4 and looks at riser 5, `depth_m` beyond it.
void look_at_tread_ahead(StandingRobot & robot, double depth_m)
{
  robot.know(kStateYaw, 0.0, 0.003);
  robot.know(kStateY, 1.0, 0.005);
  robot.know(kStateX, -0.075, 0.001);
  robot.core.gauge_ahead.touch(-0.075, robot.core.travel_m);
  const double square_m = depth_m + 0.075 - kSquareTo;
  for (int i = 0; i < 60; ++i) {
    robot.read(Place::kFrontLeft, robot.noisy(square_m));
    robot.read(Place::kFrontRight, robot.noisy(square_m));
  }
}

// Whatever the filter makes of it: 4 cm are 16 of its standard deviations.
TEST(TreadGauge, FindsATreadThatTheFilterCannotBelieve)
{
  StandingRobot robot;
  look_at_tread_ahead(robot, 0.36);
  const auto gauged = robot.core.gauge_ahead.depth_m(kCalibration);
  ASSERT_TRUE(gauged);
  EXPECT_NEAR(gauged->value, 0.36, 0.002);
  EXPECT_LT(robot.core.filter[kStateTreadAhead], 0.345);
}

TEST(TreadGauge, ReadsTheSameAsTheFilterOnATreadAsDrawn)
{
  StandingRobot robot;
  look_at_tread_ahead(robot, 0.32);
  EXPECT_NEAR(robot.core.gauge_ahead.depth_m(kCalibration)->value, 0.32, 0.002);
}

// Offset 10 mm and gain 3 % of some 0.2 m, each of two sensors: 8 mm for their mean.
TEST(TreadGauge, IsAsGoodAsThePairIsCalibrated)
{
  StandingRobot robot;
  const double sigma_m = std::sqrt(robot.core.front_calibration.depth_variance);
  EXPECT_NEAR(sigma_m, std::hypot(0.010, 0.03 * 0.207) / std::sqrt(2.0), 0.0005);
}

TEST(TreadGauge, OverrulesTheFilterOnlyWhereItBeliesTheSiteFile)
{
  StandingRobot robot;
  FusedModel model{LocalizerParams{}, stetro_site::RobotGeometry{}, papers_flight()};
  robot.know(kStateTreadHere, 0.322, 0.001);
  robot.core.gauged_here = ScalarEstimate{0.33, 0.003 * 0.003};  // 2.6 standard deviations
  EXPECT_EQ(model.as_built_here(robot.core).tread_m->value, 0.322);
  robot.core.gauged_here = ScalarEstimate{0.36, 0.003 * 0.003};
  EXPECT_EQ(model.as_built_here(robot.core).tread_m->value, 0.36);
  EXPECT_EQ(model.as_built_here(robot.core).tread_m->variance, 0.003 * 0.003);
}

}  // namespace
}  // namespace stetro_localizer
