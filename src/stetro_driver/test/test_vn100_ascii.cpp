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

#include <string>

#include "linux/imu/vn100_ascii.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kDegree = 3.14159265358979323846 / 180.0;

const std::uint8_t * bytes_of(const std::string & text)
{
  return reinterpret_cast<const std::uint8_t *>(text.data());
}

FrameScan scan(const std::string & text) { return scan_ascii(bytes_of(text), text.size()); }

AsciiSentence parsed(const std::string & text)
{
  EXPECT_EQ(scan(text).verdict, FrameVerdict::kFrame) << text;
  EXPECT_EQ(scan(text).size, text.size()) << text;
  const auto sentence = parse_ascii(bytes_of(text), text.size());
  EXPECT_TRUE(sentence) << text;
  return sentence.value_or(AsciiSentence{});
}

// As the maker prints it.
std::string example()
{
  return "$VNYMR,+100.949,-007.330,+000.715,-00.0049,-00.2449,+00.5397,-01.258,-00.100,-09.701,"
         "-00.000018,+00.001122,-00.000551*69\r\n";
}

TEST(Vn100Ascii, TheMakersMeasurementDecodesExactly)
{
  const std::string whole = example();
  const AsciiSentence sentence = parsed(whole);
  EXPECT_EQ(sentence.type, "YMR");
  EXPECT_EQ(sentence.count, 12u);
  const auto sample = sample_of(sentence);
  ASSERT_TRUE(sample);
  const Axes euler = to_euler(sample->sensor_in_ned);
  EXPECT_NEAR(euler[2], 100.949 * kDegree, 1e-12);
  EXPECT_NEAR(euler[1], -7.330 * kDegree, 1e-12);
  EXPECT_NEAR(euler[0], 0.715 * kDegree, 1e-12);
  EXPECT_EQ(sample->acceleration_m_s2, (Axes{-1.258, -0.1, -9.701}));
  EXPECT_EQ(sample->rate_rad_s, (Axes{-0.000018, 0.001122, -0.000551}));
  EXPECT_FALSE(sample->uptime);
  EXPECT_TRUE(is_plausible(*sample));
}

TEST(Vn100Ascii, DocumentedSentencesHaveTheChecksumsTheyShow)
{
  for (const char * body :
       {"$VNYMR,-096.581,-001.050,+000.544,-00.1216,+00.2479,+00.6478,-00.180,-00.088,-09.385,"
        "+00.000818,-00.000947,-00.000141*6C",
        "$VNRRG,08,-114.314,+000.058,-001.773*5F", "$VNRRG,5*46", "$VNWRG,06,0*6C",
        "$VNRRG,30,0,0,0,0,1,0,1*6C", "$VNYPR,+010.071,+000.278,-002.026*60",
        "$VNYPR,+010.071,+000.278,-002.026,T1162704*2F", "$VNRRG,06,1,1*0865", "$VNRRG,07,1,1*A234",
        "$VNRRG,75,3,400,01,0321*3B31"}) {
    EXPECT_EQ(scan(std::string(body) + "\r\n").verdict, FrameVerdict::kFrame) << body;
  }
  EXPECT_EQ(to_ascii("VNRRG,5"), "$VNRRG,5*46\r\n");
  EXPECT_EQ(to_ascii("VNRRG,07,1,1", AsciiChecksum::kCrc16), "$VNRRG,07,1,1*A234\r\n");
  const std::string digits = "123456789";
  EXPECT_EQ(vn100_crc(bytes_of(digits), digits.size()), 0x31C3) << "the check value of its kind";
}

TEST(Vn100Ascii, AnyCharacterThatIsHurtIsNoticed)
{
  const std::string whole = example();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string hurt = whole;
      hurt[i] = static_cast<char>(hurt[i] ^ (1 << bit));
      EXPECT_NE(scan(hurt).verdict, FrameVerdict::kFrame) << "byte " << i << ", bit " << bit;
    }
  }
}

TEST(Vn100Ascii, WaitsForTheRestOfASentenceAndNotOfAnythingElse)
{
  const std::string whole = example();
  for (std::size_t size = 1; size < whole.size(); ++size) {
    EXPECT_EQ(scan(whole.substr(0, size)).verdict, FrameVerdict::kNeedsMore) << size;
  }
  EXPECT_EQ(scan("$VX").verdict, FrameVerdict::kNotAFrame);
  EXPECT_EQ(scan("$VNymr").verdict, FrameVerdict::kNotAFrame);
  EXPECT_EQ(scan("$VNYMR;").verdict, FrameVerdict::kNotAFrame);
  EXPECT_EQ(scan("$VNYMR,+1$VN").verdict, FrameVerdict::kNotAFrame) << "the next one began";
  EXPECT_EQ(scan("$VNYMR*123\r").verdict, FrameVerdict::kNotAFrame);
  EXPECT_EQ(scan("$VNRRG,5*47\r\n").verdict, FrameVerdict::kBadChecksum);
  EXPECT_EQ(scan("$VNYMR," + std::string(300, '1')).verdict, FrameVerdict::kNotAFrame);
}

TEST(Vn100Ascii, FieldsAreNumbersAndNothingElse)
{
  EXPECT_EQ(decimal_of("-007.330"), -7.33);
  EXPECT_EQ(decimal_of("+00.0049"), 0.0049);
  EXPECT_EQ(decimal_of("12"), 12.0);
  for (const char * text :
       {"", "+", "-", "+-1", "-+1", "nan", "+inf", "1.2.3", "1,2", " 1", "1 ", "0x10", "1e3", ".5",
        "5.", "--1"}) {
    EXPECT_FALSE(decimal_of(text)) << "'" << text << "'";
  }
  EXPECT_EQ(whole_of("08"), 8u);
  EXPECT_EQ(whole_of("0B", 16), 11u);
  EXPECT_FALSE(whole_of("8x"));
  EXPECT_FALSE(whole_of("-1"));
  EXPECT_FALSE(whole_of(""));
}

TEST(Vn100Ascii, AMeasurementMustBeWhole)
{
  const auto measures = [](const std::string & fields) {
    return sample_of(parsed(to_ascii("VNYMR," + fields))).has_value();
  };
  const std::string numbers = "1,2,3,4,5,6,7,8,9,10,11";
  EXPECT_TRUE(measures(numbers + ",12"));
  EXPECT_TRUE(measures(numbers + ",12,T1162704,S0004")) << "a counter and a status";
  EXPECT_FALSE(measures(numbers)) << "one too few";
  EXPECT_FALSE(measures(numbers + ",12,13")) << "one that is unknown";
  EXPECT_FALSE(measures(numbers + ",nan"));
  EXPECT_FALSE(measures("181,2,3,4,5,6,7,8,9,10,11,12")) << "beyond its circle";
  EXPECT_FALSE(measures("1,91,3,4,5,6,7,8,9,10,11,12"));
  EXPECT_FALSE(sample_of(parsed("$VNYPR,+010.071,+000.278,-002.026*60\r\n")));
  const std::string many = to_ascii("VNRRG" + std::string(2 * 25, ','));
  EXPECT_FALSE(parse_ascii(bytes_of(many), many.size())) << "more fields than any sentence has";
}

TEST(Vn100Ascii, AnImplausibleSampleIsRefused)
{
  const Vn100Sample level{{}, {0.0, 0.0, 0.1}, {0.0, 0.0, -9.8}, std::nullopt};
  EXPECT_TRUE(is_plausible(level));
  Vn100Sample sample = level;
  sample.rate_rad_s[1] = 36.0;
  EXPECT_FALSE(is_plausible(sample)) << "2000 deg/s is the most it measures";
  sample = level;
  sample.acceleration_m_s2[0] = std::nan("");
  EXPECT_FALSE(is_plausible(sample));
  sample = level;
  sample.sensor_in_ned.w = 0.9;
  EXPECT_FALSE(is_plausible(sample));
}

TEST(Vn100Ascii, WhatIsPrintedIsReadBack)
{
  const Vn100Sample sample{
    from_euler(0.1, -0.2, 2.5), {0.25, -0.5, 1.0 / 64}, {-1.25, 0.5, -9.75}, std::nullopt};
  const std::string printed = to_ascii(ymr_body(sample));
  EXPECT_EQ(printed.size(), 122u) << "as long as the maker's";
  const auto back = sample_of(parsed(printed));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->acceleration_m_s2, sample.acceleration_m_s2);
  EXPECT_EQ(back->rate_rad_s, sample.rate_rad_s);
  EXPECT_NEAR(to_euler(back->sensor_in_ned)[1], -0.2, 1e-5);
  EXPECT_NEAR(to_euler(back->sensor_in_ned)[2], 2.5, 1e-5);
}

}  // namespace
}  // namespace stetro_driver::linux_io
