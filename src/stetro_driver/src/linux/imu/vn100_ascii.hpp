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

#ifndef LINUX__IMU__VN100_ASCII_HPP_
#define LINUX__IMU__VN100_ASCII_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "linux/imu/vn100_frame.hpp"

/// \file
/// Sentences of the VN-100: `$VN`, three letters, fields, `*`, a checksum, CR LF.
/**
 *   $VNYMR,+100.949,-007.330,+000.715,...*69
 *
 * The checksum has two hexadecimal digits, the exclusive or of all between `$` and `*`, or four,
 * their CRC-16 (UM001, 3.8). Register 30 chooses; a sentence shows which by its length.
 */

namespace stetro_driver::linux_io
{

/// How a sentence is closed.
enum class AsciiChecksum { kXor8, kCrc16 };

/// A sentence whose checksum agrees. Its texts live as long as the bytes it was read from.
struct AsciiSentence
{
  static constexpr std::size_t kMostFields = 24;

  std::string_view type;  ///< three letters: "YMR" measures, "RRG" and "WRG" answer, "ERR" refuses
  std::array<std::string_view, kMostFields> fields{};
  std::size_t count = 0;  ///< of fields
};

/// What the bytes begin with, told at the first byte that gives them away.
[[nodiscard]] FrameScan scan_ascii(const std::uint8_t * bytes, std::size_t size);

/// Takes a scanned sentence apart. \return nothing if it has more fields than we know
[[nodiscard]] std::optional<AsciiSentence> parse_ascii(
  const std::uint8_t * bytes, std::size_t size);

/// All of the text as a decimal number, such as "-00.0049"; nothing else, not even a blank.
[[nodiscard]] std::optional<double> decimal_of(std::string_view text);
/// All of the text as an unsigned number to the base 10 or 16.
[[nodiscard]] std::optional<unsigned> whole_of(std::string_view text, int base = 10);

/// A measurement of type YMR: yaw, pitch, roll, magnetic field, acceleration, rate.
/** Fields behind the twelfth, counters and status, are passed over if they are marked T or S. */
[[nodiscard]] std::optional<Vn100Sample> sample_of(const AsciiSentence & sentence);

/// The whole sentence, for a body such as "VNRRG,08".
[[nodiscard]] std::string to_ascii(
  const std::string & body, AsciiChecksum checksum = AsciiChecksum::kXor8);

/// The body of a measurement as the VN-100 prints it. The magnetic field is not ours to know: zero.
[[nodiscard]] std::string ymr_body(const Vn100Sample & sample);

}  // namespace stetro_driver::linux_io

#endif  // LINUX__IMU__VN100_ASCII_HPP_
