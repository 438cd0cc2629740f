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
#include <random>
#include <stdexcept>

#include "stetro_localizer/side_selection.hpp"

namespace stetro_localizer
{
namespace
{

SideFix fix(double range_m, double y_m, double sigma_m = 0.01)
{
  return {range_m, y_m, sigma_m * sigma_m, 0.0};
}

TEST(SideSelection, UsesTheOnlySideBelowTheLimit)
{
  SideSelection selection{SideSelectionParams{}};
  const auto near_right = selection.choose(fix(1.60, 0.30), fix(0.25, 0.31));
  ASSERT_TRUE(near_right.has_value());
  EXPECT_TRUE(near_right->right);
  EXPECT_FALSE(near_right->left);
  EXPECT_DOUBLE_EQ(near_right->y_m, 0.31);
  const auto near_left = selection.choose(fix(0.25, 1.75), fix(1.60, 1.70));
  EXPECT_TRUE(near_left->left);
  EXPECT_DOUBLE_EQ(near_left->y_m, 1.75);
}

TEST(SideSelection, WeighsBothByInverseVariance)
{
  SideSelection selection{SideSelectionParams{}};
  const auto both = selection.choose(fix(0.9, 1.10, 0.02), fix(0.9, 1.00, 0.01));
  ASSERT_TRUE(both.has_value());
  EXPECT_TRUE(both->left && both->right);
  EXPECT_NEAR(both->y_m, 1.02, 1e-12);                 // (1.1/4 + 1.0) / (1/4 + 1)
  EXPECT_NEAR(both->variance_m2, 1e-4 / 1.25, 1e-15);  // 1 / (1/4e-4 + 1/1e-4)
}

TEST(SideSelection, SaysNothingWhenNoSideSees)
{
  SideSelection selection{SideSelectionParams{}};
  EXPECT_FALSE(selection.choose(std::nullopt, std::nullopt));
  EXPECT_FALSE(selection.choose(fix(1.3, 1.0), fix(1.3, 1.0)));
}

// D1-5: Algorithm I turns 65535 mm into W - 819.0 cm = -614 cm. Here it is above the limit.
TEST(SideSelection, DoesNotBelieveANumberThatMeansInvalid)
{
  SideSelection selection{SideSelectionParams{}};
  for (const double invalid_m : {65.535, 8.19, 8.191}) {
    EXPECT_FALSE(selection.choose(fix(invalid_m, -6.14), std::nullopt)) << invalid_m;
    const auto other = selection.choose(fix(invalid_m, -6.14), fix(0.5, 0.55));
    ASSERT_TRUE(other.has_value()) << invalid_m;
    EXPECT_DOUBLE_EQ(other->y_m, 0.55) << invalid_m;
  }
  EXPECT_FALSE(selection.choose(fix(std::nan(""), 1.0), std::nullopt));
}

TEST(SideSelection, HasHysteresis)
{
  SideSelection selection{SideSelectionParams{}};
  EXPECT_FALSE(selection.choose(std::nullopt, fix(1.17, 1.2))) << "not yet below 1.15";
  EXPECT_TRUE(selection.choose(std::nullopt, fix(1.14, 1.2)));
  EXPECT_TRUE(selection.choose(std::nullopt, fix(1.17, 1.2))) << "in use up to 1.20";
  EXPECT_FALSE(selection.choose(std::nullopt, fix(1.20, 1.2)));
  EXPECT_FALSE(selection.choose(std::nullopt, fix(1.17, 1.2)));
}

TEST(SideSelection, VarianceOfTheMeanAgreesWithMonteCarlo)
{
  std::mt19937 random{20260303};
  std::normal_distribution<double> left{1.0, 0.02};
  std::normal_distribution<double> right{1.0, 0.01};
  double squares = 0.0;
  constexpr int kRuns = 20000;
  for (int i = 0; i < kRuns; ++i) {
    SideSelection selection{SideSelectionParams{}};
    const auto both = selection.choose(fix(0.9, left(random), 0.02), fix(0.9, right(random), 0.01));
    squares += (both->y_m - 1.0) * (both->y_m - 1.0);
  }
  EXPECT_NEAR(squares / kRuns / 8e-5, 1.0, 0.04);
}

TEST(SideSelection, RefusesCrossedLimits)
{
  EXPECT_THROW(SideSelection(SideSelectionParams{1.15, 1.20}), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_localizer
