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

#include "stetro_bringup/error_statistics.hpp"

namespace stetro_bringup
{

TEST(ErrorStatistics, GivesTheFiguresWorkedByHand)
{
  ErrorStatistics errors;
  for (const double error : {1.0, 2.0, 3.0, -6.0}) {
    errors.add(error);
  }
  EXPECT_EQ(errors.count(), 4u);
  EXPECT_NEAR(errors.mean(), 0.0, 1e-12);
  EXPECT_NEAR(errors.rms(), std::sqrt(50.0 / 4.0), 1e-12);  // 1 + 4 + 9 + 36
  EXPECT_NEAR(errors.standard_deviation(), std::sqrt(12.5), 1e-12);
  EXPECT_DOUBLE_EQ(errors.max_abs(), 6.0);
}

TEST(ErrorStatistics, KeepsASmallSpreadAroundALargeMean)
{
  ErrorStatistics errors;
  errors.add(1e6 + 0.001);
  errors.add(1e6 - 0.001);
  EXPECT_NEAR(errors.standard_deviation(), 0.001, 1e-9);
}

TEST(ErrorStatistics, SaysNothingOfNothing)
{
  const ErrorStatistics none;
  EXPECT_TRUE(std::isnan(none.mean()));
  EXPECT_TRUE(std::isnan(none.rms()));
  EXPECT_TRUE(std::isnan(none.max_abs()));
}

TEST(ErrorStatistics, RefusesWhatIsNotANumber)
{
  ErrorStatistics errors;
  EXPECT_THROW(errors.add(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(errors.add(std::numeric_limits<double>::infinity()), std::invalid_argument);
  EXPECT_EQ(errors.count(), 0u);
}

}  // namespace stetro_bringup
