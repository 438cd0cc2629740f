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

#include "stetro_supervisor/range_median.hpp"

namespace stetro_supervisor
{
namespace
{

Range reading(int time_ms, double range_m, RangeStatus status = RangeStatus::kValid)
{
  return {std::chrono::milliseconds(time_ms), range_m, status};
}

}  // namespace

TEST(RangeMedian, ASpuriousReturnMovesNothing)
{
  RangeMedian median;
  median.take(reading(1, 0.20));
  median.take(reading(2, 0.21));
  median.take(reading(3, 0.03));  // spurious
  EXPECT_DOUBLE_EQ(median.value_m().value(), 0.20);
  median.take(reading(4, 0.22));
  EXPECT_DOUBLE_EQ(median.value_m().value(), 0.21);
}

TEST(RangeMedian, IsUnknownWhenTheSensorIsNotSound)
{
  RangeMedian median;
  for (int i = 1; i < 5; ++i) {
    median.take(reading(i, 0.20));
  }
  median.take(reading(5, 0.20, RangeStatus::kFault));
  EXPECT_FALSE(median.value_m().has_value());
}

TEST(RangeMedian, NothingInReachIsInfinitelyFarAndTooNearIsZero)
{
  RangeMedian median;
  for (int i = 1; i < 4; ++i) {
    median.take(reading(i, std::nan(""), RangeStatus::kNoTarget));
  }
  EXPECT_TRUE(std::isinf(median.value_m().value()));
  for (int i = 4; i < 7; ++i) {
    median.take(reading(i, std::nan(""), RangeStatus::kTooNear));
  }
  EXPECT_EQ(median.value_m().value(), 0.0);
}

TEST(RangeMedian, TakesAReadingOnce)
{
  RangeMedian median;
  for (int i = 0; i < 5; ++i) {
    median.take(reading(1, 0.20));
  }
  EXPECT_FALSE(median.value_m().has_value()) << "one reading, seen five times";
}

}  // namespace stetro_supervisor
