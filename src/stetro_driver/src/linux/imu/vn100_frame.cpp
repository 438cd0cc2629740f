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

#include "linux/imu/vn100_frame.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kFullRate = 35.0;           // 2000 deg/s [rad/s]
constexpr double kFullAcceleration = 160.0;  // 16 g [m/s^2]

bool within(const Axes & axes, double limit)
{
  for (const double value : axes) {
    if (!(std::fabs(value) <= limit)) {  // nor is NaN
      return false;
    }
  }
  return true;
}

}  // namespace

std::uint16_t vn100_crc(const std::uint8_t * bytes, std::size_t size)
{
  unsigned crc = 0;
  for (std::size_t i = 0; i < size; ++i) {
    crc ^= static_cast<unsigned>(bytes[i]) << 8;
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 0x8000U) != 0 ? (crc << 1) ^ 0x1021U : crc << 1;
    }
  }
  return static_cast<std::uint16_t>(crc);
}

bool is_plausible(const Vn100Sample & sample)
{
  const Quaternion & q = sample.sensor_in_ned;
  const double length = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  return std::fabs(length - 1.0) <= 0.01 && within(sample.rate_rad_s, kFullRate) &&
         within(sample.acceleration_m_s2, kFullAcceleration);
}

}  // namespace stetro_driver::linux_io
