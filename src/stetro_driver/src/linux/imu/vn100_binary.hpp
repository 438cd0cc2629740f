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

#ifndef LINUX__IMU__VN100_BINARY_HPP_
#define LINUX__IMU__VN100_BINARY_HPP_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "linux/imu/vn100_frame.hpp"

/// \file
/// Binary packets of the VN-100 whose fields are of the common group (UM001, chapter 4).
/**
 *   0xFA | groups = 0x01 | mask of fields, 16 bits | the fields, in the order of their bits | CRC
 *
 * Little-endian but for the CRC, which covers everything behind 0xFA. A packet with another group
 * is none of ours: nobody configured it.
 */

namespace stetro_driver::linux_io
{

/// Fields of the common group that are read; a packet may have others, which are stepped over.
enum BinaryField : std::uint16_t {
  kTimeStartup = 1U << 0,
  kYawPitchRoll = 1U << 3,
  kQuaternion = 1U << 4,
  kAngularRate = 1U << 5,
  kAcceleration = 1U << 8,
};

/// What the driver asks for: 54 bytes a packet.
constexpr std::uint16_t kVn100Fields = kTimeStartup | kQuaternion | kAngularRate | kAcceleration;

/// A packet whose CRC agrees.
struct BinaryPacket
{
  std::optional<Time> uptime;              ///< since the sensor started
  std::optional<Axes> yaw_pitch_roll_deg;  ///< in north-east-down, as the wire has it
  std::optional<Quaternion> sensor_in_ned;
  std::optional<Axes> rate_rad_s;
  std::optional<Axes> acceleration_m_s2;
};

/// What the bytes begin with, told at the first byte that gives them away.
[[nodiscard]] FrameScan scan_binary(const std::uint8_t * bytes, std::size_t size);

/// Takes a scanned packet apart.
[[nodiscard]] BinaryPacket parse_binary(const std::uint8_t * bytes);

/// A measurement, if the packet has all of attitude as a quaternion, rate and acceleration.
[[nodiscard]] std::optional<Vn100Sample> sample_of(const BinaryPacket & packet);

/// The packet with the fields kVn100Fields.
[[nodiscard]] std::vector<std::uint8_t> to_binary(const Vn100Sample & sample);

/// Length of a packet with these fields of the common group [bytes]; 0 if there are no such.
[[nodiscard]] std::size_t binary_size(std::uint16_t fields);

}  // namespace stetro_driver::linux_io

#endif  // LINUX__IMU__VN100_BINARY_HPP_
