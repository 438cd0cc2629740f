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

#ifndef LINUX__IMU__VN100_FRAME_HPP_
#define LINUX__IMU__VN100_FRAME_HPP_

#include <cstddef>
#include <cstdint>
#include <optional>

#include "linux/imu/ned.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// No frame of the VN-100 that we know is longer [bytes].
constexpr std::size_t kLongestVn100Frame = 256;

/// What a stream of bytes begins with.
/**
 * Decided by the bytes alone: what was kFrame or kNotAFrame stays so whatever follows, so it does
 * not matter in which portions they come.
 */
enum class FrameVerdict {
  kFrame,        ///< whole, and its checksum agrees
  kNeedsMore,    ///< so far it may become one
  kNotAFrame,    ///< cannot become one
  kBadChecksum,  ///< would be one, but for its checksum
};

struct FrameScan
{
  FrameVerdict verdict = FrameVerdict::kNotAFrame;
  std::size_t size = 0;  ///< of the frame; only when kFrame [bytes]
};

/// One measurement in the sensor's own terms: printed axes, north-east-down.
struct Vn100Sample
{
  Quaternion sensor_in_ned;
  Axes rate_rad_s{};
  Axes acceleration_m_s2{};      ///< specific force: z about -9.8 when level and at rest
  std::optional<Time> uptime{};  ///< since the sensor started; ASCII output does not say
};

/// CRC-16 with the polynomial 0x1021, from 0, most significant bit first (UM001, 3.8.3).
/** Over bytes and their own CRC, high byte first, it is 0. */
[[nodiscard]] std::uint16_t vn100_crc(const std::uint8_t * bytes, std::size_t size);

/// Whether the sensor could have measured it: finite, a unit quaternion, within its full scales.
[[nodiscard]] bool is_plausible(const Vn100Sample & sample);

}  // namespace stetro_driver::linux_io

#endif  // LINUX__IMU__VN100_FRAME_HPP_
