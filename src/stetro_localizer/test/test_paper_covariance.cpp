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

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "stetro_localizer/paper_estimator.hpp"
#include "support/stair_robot.hpp"

namespace stetro_localizer
{
namespace
{

constexpr int kRuns = 300;

/// Errors drawn as the covariance assumes them: offsets, gains and white noise.
SensorErrors drawn(std::mt19937 & random)
{
  const TofSystematics systematic;
  std::normal_distribution<double> normal;
  SensorErrors errors;
  for (const Place place :
       {Place::kSideLeft, Place::kSideRight, Place::kFrontLeft, Place::kFrontRight}) {
    const std::size_t i = stetro_site::index_of(place);
    errors.offset_m[i] = std::hypot(systematic.offset_sigma, systematic.slow_m) * normal(random);
    errors.gain[i] = systematic.gain_sigma * normal(random);
  }
  errors.white_m = 0.0021;
  errors.white_per_m = 0.015;
  return errors;
}

struct Nees
{
  double y = 0.0;
  double yaw = 0.0;
};

/// Mean squared error over its own variance, at one place, over many robots.
Nees mean_nees(double y_m, bool calibrate)
{
  std::mt19937 random{20260310};
  Nees sum;
  for (int run = 0; run < kRuns; ++run) {
    LocalizerParams params;
    params.initial_step = 3;
    params.lateral.width_sigma_m = 0.0;  // this staircase is as the site says
    params.lateral.gate_sigma = 10.0;    // nothing is to be gated away
    params.heading.switch_sigma_rad = 1e-4;
    PaperEstimator estimator(params, stetro_site::RobotGeometry{}, papers_flight());
    StairRobot robot(estimator, drawn(random), static_cast<unsigned>(run));
    estimator.begin({});
    robot.stand_on(3);
    robot.y_m = y_m;
    if (calibrate) {
      robot.switches_closed = true;
      robot.rest(1.0);
      robot.switches_closed = false;
      robot.sweep_left();
      robot.sweep_right();
      robot.drive(0.0, 0.15, 0.0, (y_m - robot.y_m) / 0.15);
    }
    robot.rest(1.0);
    const StairEstimate & at = estimator.estimate();
    const double y_error = at.pose.y_m - robot.y_m;
    const double yaw_error = at.pose.yaw_rad - robot.yaw_rad;
    sum.y += y_error * y_error / at.covariance(1, 1) / kRuns;
    sum.yaw += yaw_error * yaw_error / at.covariance(5, 5) / kRuns;
  }
  return sum;
}

// Property: the propagated variance is the variance of the error. The mean of 300 squared normal
// errors over their variance is 1 +- 0.08 (one standard deviation).
TEST(PaperCovariance, AgreesWithMonteCarloBeforeCalibration)
{
  for (const double y_m : {0.4, 1.0, 1.7}) {
    const Nees nees = mean_nees(y_m, false);
    EXPECT_NEAR(nees.y, 1.0, 0.25) << "y at " << y_m << " m";
    EXPECT_NEAR(nees.yaw, 1.0, 0.25) << "heading at " << y_m << " m";
  }
}

TEST(PaperCovariance, AgreesWithMonteCarloAfterCalibration)
{
  for (const double y_m : {0.4, 1.0, 1.7}) {
    const Nees nees = mean_nees(y_m, true);
    EXPECT_NEAR(nees.y, 1.0, 0.35) << "y at " << y_m << " m";
    EXPECT_LT(nees.yaw, 1.35) << "heading at " << y_m << " m";
    EXPECT_GT(nees.yaw, 0.2) << "heading at " << y_m << " m";
  }
}

// It is propagated, not a constant: it follows the distance and the count of sensors.
TEST(PaperCovariance, FollowsTheRange)
{
  LocalizerParams params;
  params.initial_step = 3;
  const auto variance_at = [&params](double y_m) {
    PaperEstimator estimator(params, stetro_site::RobotGeometry{}, papers_flight());
    StairRobot robot(estimator);
    estimator.begin({});
    robot.stand_on(3);
    robot.y_m = y_m;
    robot.rest(1.0);
    return estimator.estimate().covariance(1, 1);
  };
  EXPECT_LT(variance_at(0.3), variance_at(0.6));
  EXPECT_LT(variance_at(1.0), variance_at(0.75)) << "two sides at the middle, one beside it";
}

TEST(PaperCovariance, IsSymmetricAndPositive)
{
  LocalizerParams params;
  params.initial_step = 3;
  PaperEstimator estimator(params, stetro_site::RobotGeometry{}, papers_flight());
  StairRobot robot(estimator);
  estimator.begin({});
  robot.stand_on(3);
  for (int i = 0; i < 100; ++i) {
    robot.drive(0.0, 0.15, 0.02 * std::sin(i), 0.1);
    const stetro_site::Covariance & covariance = estimator.estimate().covariance;
    ASSERT_EQ((covariance - covariance.transpose()).norm(), 0.0);
    ASSERT_GT(covariance.determinant(), 0.0);
  }
}

}  // namespace
}  // namespace stetro_localizer
