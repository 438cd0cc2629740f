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

#include <vector>

#include "linux/imu/vn100_binary.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

FrameScan scan(const Bytes & bytes) { return scan_binary(bytes.data(), bytes.size()); }

// UM001, the first example case of chapter 4: yaw, pitch and roll of the common group.
const Bytes kExample{0xFA, 0x01, 0x08, 0x00, 0x93, 0x50, 0x2E, 0x42, 0x83,
                     0x3E, 0xF1, 0x3F, 0x48, 0xB5, 0x04, 0xBB, 0x92, 0x88};

TEST(Vn100Binary, TheManualsExampleDecodesExactly)
{
  ASSERT_EQ(scan(kExample).verdict, FrameVerdict::kFrame);
  EXPECT_EQ(scan(kExample).size, kExample.size());
  const BinaryPacket packet = parse_binary(kExample.data());
  ASSERT_TRUE(packet.yaw_pitch_roll_deg);
  // The manual prints +43.578692, +001.884720, -0.0020249; the bits say it to the last digit.
  EXPECT_EQ((*packet.yaw_pitch_roll_deg)[0], 0x1.5ca126p+5);
  EXPECT_NEAR((*packet.yaw_pitch_roll_deg)[0], 43.578692, 1e-5);
  EXPECT_NEAR((*packet.yaw_pitch_roll_deg)[1], 1.884720, 1e-6);
  EXPECT_NEAR((*packet.yaw_pitch_roll_deg)[2], -0.0020249, 1e-7);
  EXPECT_FALSE(packet.rate_rad_s);
  EXPECT_FALSE(sample_of(packet)) << "without rates it is no measurement of ours";
}

TEST(Vn100Binary, AnyBitThatIsHurtIsNoticed)
{
  for (std::size_t i = 0; i < kExample.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      Bytes hurt = kExample;
      hurt[i] = static_cast<std::uint8_t>(hurt[i] ^ (1 << bit));
      EXPECT_NE(scan(hurt).verdict, FrameVerdict::kFrame) << "byte " << i << ", bit " << bit;
    }
  }
}

TEST(Vn100Binary, WaitsForTheRestOfAPacketAndNotOfAnythingElse)
{
  for (std::size_t size = 1; size < kExample.size(); ++size) {
    const Bytes begun(kExample.begin(), kExample.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_EQ(scan(begun).verdict, FrameVerdict::kNeedsMore) << size;
  }
  EXPECT_EQ(scan({0xFB}).verdict, FrameVerdict::kNotAFrame);
  EXPECT_EQ(scan({0xFA, 0x05}).verdict, FrameVerdict::kNotAFrame) << "another group";
  EXPECT_EQ(scan({0xFA, 0x01, 0x00, 0x00}).verdict, FrameVerdict::kNotAFrame) << "no field";
  EXPECT_EQ(scan({0xFA, 0x01, 0x00, 0x40}).verdict, FrameVerdict::kNotAFrame) << "unknown field";
}

TEST(Vn100Binary, FieldsAreFoundBehindThoseThatAreNotRead)
{
  EXPECT_EQ(binary_size(kVn100Fields), 54u) << "4 + 8 + 16 + 12 + 12 + 2";
  EXPECT_EQ(binary_size(0x3FFF), 196u) << "the longest: 4 + 190 + 2";
  EXPECT_LE(binary_size(0x3FFF), kLongestVn100Frame);
  // Time of the GPS (bit 1) and the acceleration (bit 8): 8 bytes to step over.
  Bytes packet{0xFA, 0x01, 0x02, 0x01, 1, 2, 3, 4, 5, 6, 7, 8};
  const Bytes one_minus_two_zero{0x00, 0x00, 0x80, 0x3F, 0x00, 0x00, 0x00, 0xC0, 0, 0, 0, 0};
  packet.insert(packet.end(), one_minus_two_zero.begin(), one_minus_two_zero.end());
  const std::uint16_t crc = vn100_crc(packet.data() + 1, packet.size() - 1);
  packet.push_back(static_cast<std::uint8_t>(crc >> 8));
  packet.push_back(static_cast<std::uint8_t>(crc));
  ASSERT_EQ(scan(packet).verdict, FrameVerdict::kFrame);
  EXPECT_EQ(parse_binary(packet.data()).acceleration_m_s2, (Axes{1.0, -2.0, 0.0}));
}

TEST(Vn100Binary, WhatIsWrittenIsReadBack)
{
  const Vn100Sample sample{
    {0.5, -0.5, 0.5, 0.5}, {0.25, -0.5, 2.0}, {-1.25, 0.5, -9.75}, Time{123'456'789'012}};
  const Bytes packet = to_binary(sample);
  ASSERT_EQ(packet.size(), 54u);
  EXPECT_EQ(packet[2], 0x31) << "the mask 0x0131, low byte first";
  EXPECT_EQ(packet[3], 0x01);
  ASSERT_EQ(scan(packet).verdict, FrameVerdict::kFrame);
  const auto back = sample_of(parse_binary(packet.data()));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->uptime, sample.uptime);
  EXPECT_EQ(back->sensor_in_ned.y, -0.5);
  EXPECT_EQ(back->rate_rad_s, sample.rate_rad_s);
  EXPECT_EQ(back->acceleration_m_s2, sample.acceleration_m_s2);
}

}  // namespace
}  // namespace stetro_driver::linux_io
