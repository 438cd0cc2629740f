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
#include <fstream>
#include <stdexcept>

#include "recorded/range_record.hpp"

namespace recorded
{
namespace
{

TEST(RangeRecord, ComparesMeansByHand)
{
  const RangeRecord record({1.0, 2.0, 5.0, 4.0});
  EXPECT_DOUBLE_EQ(record.mean_m(), 3.0);
  // About the mean: -2, -1, 2, 1. Steps: 1, 3, -1.
  EXPECT_DOUBLE_EQ(record.deviation_of_means_m(1), std::sqrt(10.0 / 3.0));
  EXPECT_DOUBLE_EQ(record.allan_deviation_m(1), std::sqrt(11.0 / 3.0 / 2.0));
  // Pairs have the means 1.5 and 4.5.
  EXPECT_DOUBLE_EQ(record.deviation_of_means_m(2), std::sqrt(4.5));
  EXPECT_DOUBLE_EQ(record.allan_deviation_m(2), std::sqrt(4.5));
}

TEST(RangeRecord, RefusesWhatIsNotARecord)
{
  EXPECT_THROW(RangeRecord::read("/nowhere/at/all.csv"), std::runtime_error);
  const std::string path = testing::TempDir() + "not_a_record.csv";
  std::ofstream(path) << "Fs,50.00\nLogging time,3600\nd\n79.0\nfar\n";
  EXPECT_THROW(RangeRecord::read(path), std::runtime_error);
}

// Averages of 100 still vary by 0.59 mm and of 10 000 by 0.40 mm: white noise of the same
// deviation would leave 0.22 and 0.02.
TEST(RangeRecord, OfTheVl53l0xIsNotWhite)
{
  const RangeRecord & record = vl53l0x();
  EXPECT_EQ(record.size(), 200244U);
  EXPECT_NEAR(record.mean_m(), 0.0755, 0.00005);
  const double one_m = record.deviation_of_means_m(1);
  EXPECT_NEAR(one_m, 0.00215, 0.00001);
  EXPECT_NEAR(record.deviation_of_means_m(100), 0.00059, 0.00001);
  EXPECT_NEAR(one_m / std::sqrt(100.0), 0.00022, 0.00001);
  EXPECT_NEAR(record.deviation_of_means_m(10000), 0.00040, 0.00001);
  EXPECT_NEAR(one_m / std::sqrt(10000.0), 0.00002, 0.00001);
}

}  // namespace
}  // namespace recorded
