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

#include "linux/imu/vn100_binary.hpp"

#include <array>
#include <cstring>

namespace stetro_driver::linux_io
{
namespace
{

constexpr std::uint8_t kSync = 0xFA;
constexpr std::uint8_t kCommonGroup = 0x01;
constexpr std::size_t kHeader = 4;
constexpr std::size_t kCrc = 2;

// Bytes of each field of the common group, by bit. Bit 14, a time of the GPS, and 15 are none of
// the VN-100's.
constexpr std::array<std::size_t, 14> kFieldBytes{8,  8,  8,  12, 16, 12, 24,
                                                  12, 12, 24, 20, 28, 2,  4};

std::uint64_t whole_at(const std::uint8_t * bytes, std::size_t size)
{
  std::uint64_t value = 0;
  for (std::size_t i = size; i-- > 0;) {
    value = (value << 8) | bytes[i];
  }
  return value;
}

double float_at(const std::uint8_t * bytes)
{
  const auto bits = static_cast<std::uint32_t>(whole_at(bytes, 4));
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof(value));
  return static_cast<double>(value);
}

Axes axes_at(const std::uint8_t * bytes)
{
  return {float_at(bytes), float_at(bytes + 4), float_at(bytes + 8)};
}

void put_whole(std::vector<std::uint8_t> & to, std::uint64_t value, std::size_t size)
{
  for (std::size_t i = 0; i < size; ++i) {
    to.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
}

void put_float(std::vector<std::uint8_t> & to, double value)
{
  const auto single = static_cast<float>(value);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &single, sizeof(bits));
  put_whole(to, bits, sizeof(bits));
}

}  // namespace

std::size_t binary_size(std::uint16_t fields)
{
  if (fields == 0 || (fields >> kFieldBytes.size()) != 0) {
    return 0;
  }
  std::size_t size = kHeader + kCrc;
  for (std::size_t bit = 0; bit < kFieldBytes.size(); ++bit) {
    size += ((fields >> bit) & 1U) != 0 ? kFieldBytes[bit] : 0;
  }
  return size;
}

FrameScan scan_binary(const std::uint8_t * bytes, std::size_t size)
{
  if ((size > 0 && bytes[0] != kSync) || (size > 1 && bytes[1] != kCommonGroup)) {
    return {FrameVerdict::kNotAFrame, 0};
  }
  if (size < kHeader) {
    return {FrameVerdict::kNeedsMore, 0};
  }
  const std::size_t whole = binary_size(static_cast<std::uint16_t>(whole_at(bytes + 2, 2)));
  if (whole == 0) {
    return {FrameVerdict::kNotAFrame, 0};
  }
  if (size < whole) {
    return {FrameVerdict::kNeedsMore, 0};
  }
  if (vn100_crc(bytes + 1, whole - 1) != 0) {
    return {FrameVerdict::kBadChecksum, 0};
  }
  return {FrameVerdict::kFrame, whole};
}

BinaryPacket parse_binary(const std::uint8_t * bytes)
{
  const auto fields = static_cast<std::uint16_t>(whole_at(bytes + 2, 2));
  const std::uint8_t * at = bytes + kHeader;
  BinaryPacket packet;
  for (std::size_t bit = 0; bit < kFieldBytes.size(); ++bit) {
    const auto field = static_cast<std::uint16_t>(fields & (1U << bit));
    if (field == 0) {
      continue;
    }
    if (field == kTimeStartup) {
      packet.uptime = Time{static_cast<Time::rep>(whole_at(at, 8))};
    } else if (field == kYawPitchRoll) {
      packet.yaw_pitch_roll_deg = axes_at(at);
    } else if (field == kQuaternion) {
      packet.sensor_in_ned =
        Quaternion{float_at(at), float_at(at + 4), float_at(at + 8), float_at(at + 12)};
    } else if (field == kAngularRate) {
      packet.rate_rad_s = axes_at(at);
    } else if (field == kAcceleration) {
      packet.acceleration_m_s2 = axes_at(at);
    }
    at += kFieldBytes[bit];
  }
  return packet;
}

std::optional<Vn100Sample> sample_of(const BinaryPacket & packet)
{
  if (!packet.sensor_in_ned || !packet.rate_rad_s || !packet.acceleration_m_s2) {
    return std::nullopt;
  }
  return Vn100Sample{
    *packet.sensor_in_ned, *packet.rate_rad_s, *packet.acceleration_m_s2, packet.uptime};
}

std::vector<std::uint8_t> to_binary(const Vn100Sample & sample)
{
  std::vector<std::uint8_t> packet{kSync, kCommonGroup};
  packet.reserve(binary_size(kVn100Fields));
  put_whole(packet, kVn100Fields, 2);
  put_whole(packet, static_cast<std::uint64_t>(sample.uptime.value_or(Time{0}).count()), 8);
  const Quaternion & q = sample.sensor_in_ned;
  for (const double value : {q.x, q.y, q.z, q.w}) {
    put_float(packet, value);
  }
  for (const Axes * axes : {&sample.rate_rad_s, &sample.acceleration_m_s2}) {
    for (const double value : *axes) {
      put_float(packet, value);
    }
  }
  const std::uint16_t crc = vn100_crc(packet.data() + 1, packet.size() - 1);
  packet.push_back(static_cast<std::uint8_t>(crc >> 8));
  packet.push_back(static_cast<std::uint8_t>(crc));
  return packet;
}

}  // namespace stetro_driver::linux_io
