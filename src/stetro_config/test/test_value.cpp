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
#include <cstring>
#include <limits>
#include <random>

#include "stetro_config/value.hpp"

namespace stetro_config
{
namespace
{

template <class T>
std::optional<T> read(const std::string & yaml)
{
  const auto value = parse(YAML::Load(yaml), kind_of<T>());
  return value ? std::optional<T>{std::get<T>(*value)} : std::nullopt;
}

TEST(Value, ReadsABoolOnlyAsTrueOrFalse)
{
  EXPECT_EQ(read<bool>("true"), true);
  EXPECT_EQ(read<bool>("False"), false);
  for (const char * text : {"yes", "on", "1", "'true'", "~", "[true]", "tRue", "!!str true"}) {
    EXPECT_FALSE(read<bool>(text)) << text;
  }
}

TEST(Value, ReadsAnIntOnlyAsADecimalOf64Bits)
{
  EXPECT_EQ(read<std::int64_t>("16"), 16);
  EXPECT_EQ(read<std::int64_t>("+16"), 16);
  EXPECT_EQ(read<std::int64_t>("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  for (const char * text :
       {"3.0", "1e3", "010", "0x10", "'3'", "9223372036854775808", "--1", "+-1", "true", ""}) {
    EXPECT_FALSE(read<std::int64_t>(text)) << text;
  }
}

TEST(Value, ReadsADoubleOnlyIfFiniteAndExact)
{
  EXPECT_EQ(read<double>("0.14"), 0.14);
  EXPECT_EQ(read<double>("-.5e-3"), -0.5e-3);
  EXPECT_EQ(read<double>("2"), 2.0);
  EXPECT_EQ(read<double>("9007199254740992"), 0x1p53);
  for (const char * text :
       {".nan", ".inf", "-.inf", "nan", "inf", "1e999", "1.0 m", "0,14", "'0.14'", "!!str 0.14",
        "9007199254740993", "9223372036854775807", "00.5", "0x1p3", "~", "[0.1]", "{a: 1}"}) {
    EXPECT_FALSE(read<double>(text)) << text;
  }
}

TEST(Value, ReadsTextThatNobodyCouldTakeForANumber)
{
  EXPECT_EQ(read<std::string>("fused"), "fused");
  EXPECT_EQ(read<std::string>("'0.14'"), "0.14");
  EXPECT_EQ(read<std::string>("!!str 5"), "5");
  EXPECT_EQ(read<std::string>("''"), "");
  EXPECT_EQ(read<std::string>("192.168.1.1"), "192.168.1.1");
  EXPECT_EQ(read<std::string>("2026-01-01"), "2026-01-01");
  EXPECT_EQ(read<std::string>("/dev/ttyS0"), "/dev/ttyS0");
  for (const char * text : {"5", "0.14", "true", "~", ".inf", "0x1f", "1_000", "!mine x", "[a]"}) {
    EXPECT_FALSE(read<std::string>(text)) << text;
  }
}

TEST(Value, ReadsListsElementByElement)
{
  EXPECT_EQ(read<std::vector<double>>("[0.1, 2]"), (std::vector<double>{0.1, 2.0}));
  EXPECT_EQ(read<std::vector<std::string>>("[a, 'b']"), (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(read<std::vector<double>>("[]")->empty());
  EXPECT_FALSE(read<std::vector<double>>("[0.1, .nan]"));
  EXPECT_FALSE(read<std::vector<double>>("0.1"));
  EXPECT_FALSE(read<std::vector<std::string>>("[a, 1]"));
}

TEST(Value, SaysWhatWasWritten)
{
  EXPECT_EQ(excerpt(YAML::Load("{a: 1}")), "a map");
  EXPECT_EQ(excerpt(YAML::Load("[1, {a: 2}]")), "[1, ...]");
  EXPECT_EQ(excerpt(YAML::Load("~")), "null");
  EXPECT_EQ(excerpt(YAML::Load(std::string(1000, 'x'))).size(), 63U);
}

TEST(Value, KnowsNumbersThatAreNone)
{
  EXPECT_TRUE(is_finite(Value{1.0}));
  EXPECT_FALSE(is_finite(Value{std::nan("")}));
  EXPECT_FALSE(is_finite(Value{std::vector<double>{0.0, HUGE_VAL}}));
}

// Property: what is printed reads back as the same value.
TEST(Value, SurvivesPrintingAndReading)
{
  std::vector<Value> values{
    true,
    std::int64_t{-3},
    1e300,
    2.0,
    5e-324,
    std::string{"a \"b\"\n\t: #"},
    std::string{},
    std::vector<double>{0.1, -7.0},
    std::vector<std::string>{"true", "é", "1"}};
  std::mt19937_64 random{20250301};
  for (int i = 0; i < 2000; ++i) {
    double number = 0.0;
    const std::uint64_t bits = random();
    std::memcpy(&number, &bits, sizeof number);
    if (std::isfinite(number)) {
      values.emplace_back(number);
    }
  }
  for (const Value & value : values) {
    const std::string text = to_yaml(value);
    EXPECT_EQ(parse(YAML::Load(text), static_cast<Kind>(value.index())), value) << text;
  }
}

}  // namespace
}  // namespace stetro_config
