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

#ifndef LINUX__TOF__VL53L0X_READING_HPP_
#define LINUX__TOF__VL53L0X_READING_HPP_

#include <optional>
#include <string_view>

#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// What the kernel's driver says when nothing is within reach: one of these two.
constexpr int kNoTargetMm = 8190;
constexpr int kNoTargetAltMm = 8191;  ///< also the largest number that 13 bits hold

/// What a VL53L0X can be believed; as `range_sensor` in the robot file.
struct TofLimits
{
  double min_range_m = 0.03;       ///< nearer targets give numbers that mean nothing
  double reliable_range_m = 1.20;  ///< farther ones are guessed
  double sigma_m = 0.0021;         ///< standard deviation of one reading at zero range
  double sigma_per_m = 0.015;      ///< its part that grows with range, added in squares
};

/// Reads the content of `in_distance_raw`: a decimal number from 0 to 8191 and a newline.
/**
 * Nothing but what the kernel prints is a number: no sign, no blank, no leading zero, no lack of
 * the newline. A reading that was cut off must not become a shorter distance.
 * \return millimetres, or nothing if the text is anything else
 */
[[nodiscard]] std::optional<int> parse_millimetres(std::string_view text) noexcept;

/// A number of millimetres as a range of REP 117.
/**
 * The kernel's driver drops the sensor's own status, so a weak echo is a plausible number here:
 * whether it fits what else is known is judged by who uses it.
 */
[[nodiscard]] RangeReading range_reading(
  int millimetres, const TofLimits & limits, Time stamp) noexcept;

}  // namespace stetro_driver::linux_io

#endif  // LINUX__TOF__VL53L0X_READING_HPP_
