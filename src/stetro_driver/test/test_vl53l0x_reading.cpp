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
#include <string>

#include "linux/tof/vl53l0x_reading.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Vl53l0xReading, EveryNumberOfThirteenBitsAndNoOtherIsParsed)
{
  for (int number = 0; number < 100000; ++number) {
    const auto parsed = parse_millimetres(std::to_string(number) + "\n");
    if (number <= 8191) {
      ASSERT_EQ(parsed, number);
    } else {
      ASSERT_EQ(parsed, std::nullopt) << number;
    }
  }
}

TEST(Vl53l0xReading, NothingButWhatTheKernelPrintsIsANumber)
{
  for (const char * text :
       {"", "\n", "12", "12\n\n", "12 \n", " 12\n", "+12\n", "-12\n", "012\n", "00\n", "1.2\n",
        "0x1f\n", "1e3\n", "12\r\n", "\xff\xff\n", "nan\n", "99999999999999999999\n"}) {
    EXPECT_EQ(parse_millimetres(text), std::nullopt) << "'" << text << "'";
  }
  EXPECT_EQ(parse_millimetres(std::string{"1\0002\n", 4}), std::nullopt) << "a zero byte inside";
}

// Property: a reading that was cut off is no reading, wherever it was cut.
TEST(Vl53l0xReading, APartOfAReadingIsNone)
{
  const std::string whole = "1234\n";
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_EQ(parse_millimetres(whole.substr(0, size)), std::nullopt) << size;
  }
}

// Property: of all texts of two characters, only digits with a newline are numbers.
TEST(Vl53l0xReading, OfAllTextsOfTwoBytesTenAreNumbers)
{
  int numbers = 0;
  for (int first = 0; first < 256; ++first) {
    for (int second = 0; second < 256; ++second) {
      const std::string text{static_cast<char>(first), static_cast<char>(second)};
      numbers += parse_millimetres(text) ? 1 : 0;
    }
  }
  EXPECT_EQ(numbers, 10);
}

TEST(Vl53l0xReading, BecomesARangeOfRep117)
{
  const TofLimits limits{0.03, 1.20, 0.003, 0.02};
  const Time stamp = std::chrono::seconds{7};

  const RangeReading valid = range_reading(200, limits, stamp);
  EXPECT_EQ(valid.status, RangeStatus::kValid);
  EXPECT_DOUBLE_EQ(valid.range_m, 0.2);
  EXPECT_DOUBLE_EQ(valid.std_dev_m, 0.005);  // 3 mm and 20 mm/m * 0.2 m = 4 mm, in squares
  EXPECT_EQ(valid.stamp, stamp);

  EXPECT_EQ(range_reading(30, limits, stamp).status, RangeStatus::kValid) << "at the limit";
  EXPECT_EQ(range_reading(29, limits, stamp).status, RangeStatus::kTooNear);
  EXPECT_EQ(range_reading(0, limits, stamp).range_m, -kInfinity);
  EXPECT_EQ(range_reading(1200, limits, stamp).status, RangeStatus::kValid);
  EXPECT_EQ(range_reading(1201, limits, stamp).status, RangeStatus::kWeak);
  EXPECT_DOUBLE_EQ(range_reading(8189, limits, stamp).range_m, 8.189);
}

TEST(Vl53l0xReading, BothNumbersForNoTargetAreInfinite)
{
  for (const int none : {8190, 8191}) {
    const RangeReading reading = range_reading(none, {}, std::chrono::seconds{7});
    EXPECT_EQ(reading.status, RangeStatus::kNoTarget);
    EXPECT_EQ(reading.range_m, kInfinity);
    EXPECT_TRUE(std::isnan(reading.std_dev_m));
  }
}

}  // namespace
}  // namespace stetro_driver::linux_io
