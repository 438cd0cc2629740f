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
#include <numeric>
#include <vector>

#include "stetro_localizer/contact_closure.hpp"
#include "stetro_localizer/measurement/bumper_contact.hpp"
#include "stetro_localizer/scalar_estimate.hpp"
#include "support/papers_tables.hpp"

namespace stetro_localizer
{
namespace
{

using papers::kContactWidthCm;
using papers::kTable3;
using papers::kWidthCm;

std::vector<double> closures_cm()
{
  std::vector<double> errors;
  for (const auto & row : kTable3) {
    errors.push_back(
      100.0 * contact_closure_m(
                kWidthCm / 100, row.y_max_cm / 100, row.y_min_cm / 100, kContactWidthCm / 100));
  }
  return errors;
}

double mean(const std::vector<double> & values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation(const std::vector<double> & values)
{
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - mean(values)) * (value - mean(values));
  }
  return std::sqrt(squares / static_cast<double>(values.size()));
}

// Eq. (3) with R_w = 23.0 gives each printed error, but for row 10 (both), 13 and 14 (S-A).
TEST(PapersTable3, FollowsFromEquation3)
{
  const auto errors = closures_cm();
  for (std::size_t i = 0; i < kTable3.size(); ++i) {
    const auto & row = kTable3[i];
    EXPECT_NEAR(errors[i], row.step == 10 ? 2.9 : row.error_b_cm, 1e-9) << "S-B row " << row.step;
    const bool misfit = row.step == 10 || row.step == 13 || row.step == 14;
    if (row.error_a_cm) {
      EXPECT_EQ(std::abs(errors[i] - *row.error_a_cm) > 1e-9, misfit) << "S-A row " << row.step;
    }
  }
}

TEST(PapersTable3, IsOutByTheRobotsWidthWithThePrintedTwenty)
{
  const auto & row = kTable3.front();
  const double with_body_cm =
    100.0 * contact_closure_m(2.05, row.y_max_cm / 100, row.y_min_cm / 100, 0.20);
  EXPECT_NEAR(with_body_cm, row.error_b_cm + 3.0, 1e-9);
}

// D1-2: mean 3.0750 and deviation 0.135 (population) after correcting row 10.
TEST(PapersTable3, HasTheMeanAndDeviationOfTheCorrectedRows)
{
  const auto errors = closures_cm();
  for (const double error : errors) {
    EXPECT_GE(error, 2.8 - 1e-9);
    EXPECT_LE(error, 3.3 + 1e-9);
  }
  EXPECT_NEAR(mean(errors), 3.0750, 5e-5);
  EXPECT_NEAR(deviation(errors), 0.135, 5e-4);
  std::vector<double> printed;
  for (const auto & row : kTable3) {
    printed.push_back(row.error_b_cm);
  }
  EXPECT_NEAR(mean(printed), 3.0875, 5e-5) << "S-B as printed";
  EXPECT_NEAR(deviation(printed), 0.127, 5e-4) << "S-B as printed";
}

// D1-3: W cancels. Eq. (3) is the sum of the two near-wall readings, less R_w.
TEST(PapersTable3, DoesNotDependOnTheWidthOfTheStairs)
{
  for (const auto & row : kTable3) {
    const double left_cm = kWidthCm - row.y_max_cm;  // what the left sensor read at its wall
    for (const double width_cm : {150.0, 205.0, 300.0}) {
      const double closure_cm = 100.0 * contact_closure_m(
                                          width_cm / 100, (width_cm - left_cm) / 100,
                                          row.y_min_cm / 100, kContactWidthCm / 100);
      EXPECT_NEAR(closure_cm, row.y_min_cm + left_cm - kContactWidthCm, 1e-9);
    }
  }
}

// D1-2: mean much above deviation is a bias at each wall. Learned at the contacts and taken off,
// as the localizer does it, what is left is at most 0.14 cm rms.
TEST(PapersTable3, LosesItsErrorOnceTheOffsetsAreLearned)
{
  const BumperContact bumpers{BumperParams{}};
  const double right_y_cm =
    100.0 * bumpers.fix(Side::kRight, {true, true, true}, 0.0, 0.0, 2.05)->y_m;
  const double left_y_cm =
    100.0 * bumpers.fix(Side::kLeft, {true, true, true}, 0.0, 0.0, 2.05)->y_m;
  EXPECT_NEAR(right_y_cm, 11.5, 1e-9);
  ScalarEstimate right{0.0, 1.0};  // offset [cm], doubt 1 cm
  ScalarEstimate left{0.0, 1.0};
  double squares = 0.0;
  for (const auto & row : kTable3) {
    right.update(row.y_min_cm - right_y_cm, 0.01);
    left.update(left_y_cm - row.y_max_cm, 0.01);
  }
  for (const auto & row : kTable3) {
    const double closure_cm =
      100.0 * contact_closure_m(
                2.05, (row.y_max_cm + left.value) / 100, (row.y_min_cm - right.value) / 100, 0.23);
    squares += closure_cm * closure_cm;
  }
  EXPECT_NEAR(right.value, 14.16 - 11.5, 0.02);  // y_min 14.16 +- 0.13
  EXPECT_NEAR(left.value, 11.91 - 11.5, 0.02);   // 205 - y_max = 11.91 +- 0.11
  EXPECT_LE(std::sqrt(squares / 16.0), 0.14);
}

}  // namespace
}  // namespace stetro_localizer
