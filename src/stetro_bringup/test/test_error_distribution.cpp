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
#include <limits>
#include <stdexcept>

#include "accuracy/error_distribution.hpp"
#include "accuracy/histogram.hpp"

namespace stetro_bringup
{
namespace
{

TEST(ErrorDistribution, GivesTheFiguresWorkedByHand)
{
  ErrorDistribution errors;
  for (const double error : {0.003, -0.004}) {
    errors.add(error);
  }
  EXPECT_EQ(errors.count(), 2u);
  EXPECT_NEAR(errors.mean(), -0.0005, 1e-15);
  EXPECT_NEAR(errors.rmse(), std::sqrt(12.5e-6), 1e-12);  // (9 + 16) / 2 mm^2
  EXPECT_NEAR(errors.standard_deviation(), 0.0035, 1e-12);
  EXPECT_DOUBLE_EQ(errors.max(), 0.004);
}

// Of the sizes 1..1000 mm the nearest rank to 95 % is 950, to 99.9 % is 999.
TEST(ErrorDistribution, TakesPercentilesByNearestRankOfTheSize)
{
  ErrorDistribution errors;
  for (int i = 1; i <= 1000; ++i) {
    errors.add((i % 2 == 0 ? 0.001 : -0.001) * i);
  }
  EXPECT_NEAR(errors.percentile(0.5), 0.500, 0.001 * 0.500);
  EXPECT_NEAR(errors.percentile(0.95), 0.950, 0.001 * 0.950);
  EXPECT_NEAR(errors.percentile(0.999), 0.999, 0.001 * 0.999);
  EXPECT_DOUBLE_EQ(errors.percentile(1.0), 1.0);
  EXPECT_GE(errors.percentile(0.95), 0.950) << "rounded up, never down";
}

TEST(ErrorDistribution, KnowsAPercentileOfOneErrorExactly)
{
  ErrorDistribution errors;
  errors.add(0.0123);
  EXPECT_DOUBLE_EQ(errors.percentile(0.001), 0.0123);
  EXPECT_DOUBLE_EQ(errors.percentile(0.999), 0.0123);
}

TEST(ErrorDistribution, TakesZeroAndTheVeryLarge)
{
  ErrorDistribution errors;
  errors.add(0.0);
  errors.add(0.0);
  errors.add(1e6);
  EXPECT_LE(errors.percentile(0.5), 1e-9);
  EXPECT_GE(errors.percentile(1.0), 1e3);
  EXPECT_DOUBLE_EQ(errors.max(), 1e6);
}

TEST(ErrorDistribution, OfNothingIsNotANumberAndRefusesWhatIsNone)
{
  ErrorDistribution errors;
  EXPECT_TRUE(std::isnan(errors.percentile(0.95)));
  EXPECT_TRUE(std::isnan(errors.rmse()));
  EXPECT_THROW(errors.add(std::nan("")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(errors.percentile(0.0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(errors.percentile(1.1)), std::invalid_argument);
  EXPECT_EQ(errors.count(), 0u);
}

TEST(Histogram, CountsWhatLiesOutsideAtItsEdges)
{
  Histogram histogram(2.0, 4);  // classes of one: [-2, -1), [-1, 0), [0, 1), [1, 2]
  for (const double error : {-5.0, -1.5, 0.5, 9.0}) {
    histogram.add(error);
  }
  EXPECT_DOUBLE_EQ(histogram.centre(0), -1.5);
  EXPECT_DOUBLE_EQ(histogram.share(0), 0.5);
  EXPECT_DOUBLE_EQ(histogram.share(1), 0.0);
  EXPECT_DOUBLE_EQ(histogram.share(2), 0.25);
  EXPECT_DOUBLE_EQ(histogram.share(3), 0.25);
}

}  // namespace
}  // namespace stetro_bringup
