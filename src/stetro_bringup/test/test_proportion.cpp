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
#include <stdexcept>

#include "accuracy/proportion.hpp"

namespace stetro_bringup
{
namespace
{

TEST(Proportion, BinomialSumsAreThoseOfThePascalTriangle)
{
  EXPECT_NEAR(binomial_at_most(0, 4, 0.5), 1.0 / 16.0, 1e-14);
  EXPECT_NEAR(binomial_at_most(1, 4, 0.5), 5.0 / 16.0, 1e-14);
  EXPECT_NEAR(binomial_at_most(3, 4, 0.5), 15.0 / 16.0, 1e-14);
  EXPECT_EQ(binomial_at_most(4, 4, 0.5), 1.0);
  EXPECT_EQ(binomial_at_most(2, 4, 0.0), 1.0);
  EXPECT_EQ(binomial_at_most(2, 4, 1.0), 0.0);
}

// (1 - p)^n = 0.025 gives the upper bound of none out of n, and p^n = 0.025 the lower of all.
TEST(Proportion, NoneOrAllHaveBoundsInClosedForm)
{
  const Interval none = clopper_pearson(0, 10);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 1.0 - std::pow(0.025, 0.1), 1e-12);
  EXPECT_NEAR(none.high, 0.3085, 5e-5) << "the textbooks' figure";
  const Interval all = clopper_pearson(10, 10);
  EXPECT_NEAR(all.low, std::pow(0.025, 0.1), 1e-12);
  EXPECT_EQ(all.high, 1.0);
}

// One of two: at least one has probability 1 - (1 - p)^2, at most one 1 - p^2; each is 0.025.
TEST(Proportion, OneOfTwoIsWorkedByHand)
{
  const Interval bounds = clopper_pearson(1, 2);
  EXPECT_NEAR(bounds.low, 1.0 - std::sqrt(0.975), 1e-12);
  EXPECT_NEAR(bounds.high, std::sqrt(0.975), 1e-12);
}

TEST(Proportion, ThirtyThousandCleanStepsClaimOneInTenThousand)
{
  EXPECT_LT(clopper_pearson(0, 30'000, 0.90).high, 1e-4) << "one-sided 95 %";
  EXPECT_GT(clopper_pearson(0, 29'000, 0.90).high, 1e-4);
}

TEST(Proportion, TwoSidedItTakesMoreStepsToClaimOneInTenThousand)
{
  EXPECT_GT(clopper_pearson(0, 36'800).high, 1e-4);
  EXPECT_LT(clopper_pearson(0, 36'900).high, 1e-4) << "ln(40) / 1e-4";
}

// Far below and far above the mean the sums must neither stop early nor lose themselves.
TEST(Proportion, BoundsOfManyAreThoseOfTheNormalDistribution)
{
  const Interval bounds = clopper_pearson(5000, 10'000);
  EXPECT_NEAR(bounds.low, 0.5 - 1.96 * 0.005, 1e-4);
  EXPECT_NEAR(bounds.high, 0.5 + 1.96 * 0.005, 1e-4);
}

// exp(-2) (1 + 2 + 2) for two or fewer.
TEST(Proportion, PoissonSumsAreWorkedByHand)
{
  EXPECT_NEAR(poisson_at_most(0, 2.0), std::exp(-2.0), 1e-14);
  EXPECT_NEAR(poisson_at_most(2, 2.0), 5.0 * std::exp(-2.0), 1e-14);
  EXPECT_EQ(poisson_at_most(0, 0.0), 1.0);
}

// None: exp(-m) = 0.025. The rest from chi-square tables: half of 0.0506 (2 degrees of freedom) and
// of 11.1433 (4) for one, of 9.5908 (20) and of 36.7807 (22) for ten.
TEST(Proportion, EventsAStepHaveGarwoodsBounds)
{
  EXPECT_EQ(garwood(0, 10).low, 0.0);
  EXPECT_NEAR(garwood(0, 10).high, -std::log(0.025) / 10.0, 1e-12);
  EXPECT_NEAR(garwood(1, 1).low, 0.0253, 5e-5);
  EXPECT_NEAR(garwood(1, 1).high, 5.5716, 5e-5);
  EXPECT_NEAR(garwood(10, 100).low, 0.047954, 5e-6);
  EXPECT_NEAR(garwood(10, 100).high, 0.183904, 5e-6);
  EXPECT_GT(garwood(7, 2).high, 1.0) << "there may be more than one a step";
  EXPECT_TRUE(std::isinf(garwood(0, 0).high));
  EXPECT_EQ(garwood(0, 0).low, 0.0);
  EXPECT_THROW(static_cast<void>(garwood(0, 1, 0.0)), std::invalid_argument);
}

TEST(Proportion, OfNothingIsEverything)
{
  EXPECT_EQ(clopper_pearson(0, 0).low, 0.0);
  EXPECT_EQ(clopper_pearson(0, 0).high, 1.0);
  EXPECT_THROW(static_cast<void>(clopper_pearson(3, 2)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(clopper_pearson(1, 2, 1.0)), std::invalid_argument);
}

TEST(Proportion, NeesBoundsLeaveTwoAndAHalfPercentOnEitherSide)
{
  EXPECT_NEAR(chi_square_3(kNees95.low), 0.025, 1e-6);
  EXPECT_NEAR(chi_square_3(kNees95.high), 0.975, 1e-6);
  EXPECT_EQ(chi_square_3(0.0), 0.0);
  EXPECT_NEAR(chi_square_3(3.0), 0.608375, 1e-6) << "the mean, from tables";
}

}  // namespace
}  // namespace stetro_bringup
