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

#include "accuracy/proportion.hpp"
#include "accuracy/tread_errors.hpp"

namespace stetro_bringup
{
namespace
{

/// Four steps of 14 cm by 32 cm, 2 m wide, as the site file has them.
stetro_site::Flight drawn_flight()
{
  stetro_site::FlightSpec spec;
  spec.id = "stairs";
  spec.steps = stetro_site::equal_steps(4, 0.14, 0.32);
  spec.width_foot_m = spec.width_top_m = 2.0;
  return stetro_site::Flight(spec);
}

/// On tread 2 as built: its riser 5 mm later than drawn, the next one 8 mm, 3 mm too high.
stetro_driver::GroundTruth truth_on_tread_2()
{
  stetro_driver::GroundTruth truth;
  truth.step = 2;
  truth.x_m = 0.560;
  truth.y_m = 1.000;
  truth.z_m = 0.283;
  truth.yaw_rad = 0.010;
  truth.heading_rad = 0.012;
  truth.tread_x_m = 0.560 - 0.325;
  truth.riser_ahead_m = 0.648 - 0.560;
  truth.block_heights_m = {0.423, 0.283, 0.283};
  return truth;
}

stetro_localizer::StairEstimate estimate_on(int step, double x_m)
{
  stetro_localizer::StairEstimate estimate;
  estimate.step = step;
  estimate.pose = {x_m, 1.004, 0.14 * step, 0.013};
  estimate.tread_x_m = x_m - 0.32 * (step - 1);
  estimate.block_heights_m = {0.14 * (step + 1), 0.14 * step, 0.14 * step};
  return estimate;
}

TEST(TreadErrors, AreAgainstTheRisersWallsAndTreadsAsBuilt)
{
  const TreadErrors errors = errors_of(estimate_on(2, 0.555), truth_on_tread_2(), drawn_flight());
  // drawn: 0.640 - 0.555 = 0.085 to go, truly 0.088: 3 mm too far ahead
  EXPECT_NEAR(errors.x_m, 0.003, 1e-12);
  EXPECT_NEAR(errors.x_behind_m, 0.0, 1e-12);  // 0.235 both
  EXPECT_NEAR(errors.y_m, 0.004, 1e-12);
  EXPECT_NEAR(errors.z_m, 0.0, 1e-12);
  EXPECT_NEAR(errors.heading_rad, 0.003, 1e-12);
  EXPECT_NEAR(errors.heading_to_riser_rad, 0.001, 1e-12);
  EXPECT_NEAR(errors.flight_x_m, -0.005, 1e-12);
  EXPECT_NEAR(errors.flight_z_m, -0.003, 1e-12);
}

TEST(TreadErrors, ZFollowsTheLiftedBlock)
{
  auto truth = truth_on_tread_2();
  truth.block_heights_m[1] += 0.152;
  auto estimate = estimate_on(2, 0.555);
  estimate.block_heights_m[1] += 0.150;
  const TreadErrors errors = errors_of(estimate, truth, drawn_flight());
  EXPECT_NEAR(errors.z_m, -0.002, 1e-12);
  EXPECT_NEAR(errors.flight_z_m, -0.003, 1e-12) << "base_link stays on the tread";
}

TEST(TreadErrors, AWrongStepCostsATreadAndARiser)
{
  const TreadErrors errors = errors_of(estimate_on(1, 0.235), truth_on_tread_2(), drawn_flight());
  EXPECT_NEAR(errors.x_m, 0.003 - 0.32, 1e-12);
  EXPECT_NEAR(errors.x_behind_m, -0.085 - 0.235, 1e-12);
  EXPECT_NEAR(errors.z_m, -0.14, 1e-12);
}

TEST(TreadErrors, TheEstimatesOwnDistancesGoBeforeTheDrawing)
{
  auto estimate = estimate_on(2, 0.555);
  estimate.riser_ahead_m = 0.087;  // truly 0.088: 1 mm too far ahead
  estimate.tread_x_m = 0.237;      // truly 0.235
  const TreadErrors told = errors_of(estimate, truth_on_tread_2(), drawn_flight());
  EXPECT_NEAR(told.x_m, 0.001, 1e-12);
  EXPECT_NEAR(told.x_behind_m, 0.002, 1e-12);
  estimate.step = 1;  // they are another tread's
  const TreadErrors drawn = errors_of(estimate, truth_on_tread_2(), drawn_flight());
  EXPECT_NEAR(drawn.x_m, 0.003, 1e-12);
  EXPECT_NEAR(drawn.x_behind_m, 0.0, 1e-12);
}

TEST(TreadErrors, OnTheLastTreadOnlyTheRiserBehindIsLeft)
{
  stetro_driver::GroundTruth truth = truth_on_tread_2();
  truth.step = 4;
  truth.tread_x_m = 0.240;
  truth.riser_ahead_m = std::nan("");
  const TreadErrors errors = errors_of(estimate_on(4, 0.96 + 0.235), truth, drawn_flight());
  EXPECT_NEAR(errors.x_m, -0.005, 1e-12);
  EXPECT_EQ(errors.x_m, errors.x_behind_m);
}

TEST(TreadErrors, TheHeadingErrorIsTheShortWayRound)
{
  auto estimate = estimate_on(2, 0.555);
  estimate.pose.yaw_rad = 3.1;
  auto truth = truth_on_tread_2();
  truth.yaw_rad = -3.1;
  EXPECT_NEAR(errors_of(estimate, truth, drawn_flight()).heading_rad, 6.2 - 2.0 * M_PI, 1e-12);
}

TEST(Nees, OfOneSigmaEachIsThree)
{
  stetro_site::Covariance covariance = stetro_site::Covariance::Zero();
  covariance(0, 0) = 0.003 * 0.003;
  covariance(1, 1) = 0.004 * 0.004;
  covariance(5, 5) = 0.003 * 0.003;
  TreadErrors errors{};
  errors.x_m = 0.003;
  errors.y_m = -0.004;
  errors.heading_rad = 0.003;
  EXPECT_NEAR(nees_of(errors, covariance), 3.0, 1e-9);
  EXPECT_LT(nees_of(errors, covariance), kNees95.high);
  errors.y_m = 0.0124;  // 3.1 sigma: 1 + 9.61 + 1
  EXPECT_NEAR(nees_of(errors, covariance), 11.61, 1e-9);
  EXPECT_GT(nees_of(errors, covariance), kNees95.high);
  errors.y_m = std::nan("");
  EXPECT_TRUE(std::isnan(nees_of(errors, covariance)));
  errors.y_m = 0.0;
  covariance(1, 1) = 0.0;
  EXPECT_TRUE(std::isnan(nees_of(errors, covariance))) << "no doubt at all is no covariance";
}

// y and heading that err together are believed when the covariance says so: rho = 0.8, both one
// sigma: (1 - 2 * 0.8 + 1) / (1 - 0.64).
TEST(Nees, KnowsThatErrorsBelongTogether)
{
  stetro_site::Covariance covariance = stetro_site::Covariance::Identity();
  covariance(1, 5) = covariance(5, 1) = 0.8;
  TreadErrors errors{};
  errors.y_m = errors.heading_rad = 1.0;
  EXPECT_NEAR(nees_of(errors, covariance), 0.4 / 0.36, 1e-12);
}

}  // namespace
}  // namespace stetro_bringup
