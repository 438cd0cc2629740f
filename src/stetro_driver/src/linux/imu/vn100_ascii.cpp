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

#include "linux/imu/vn100_ascii.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr std::size_t kHead = 6;  // $VN and the three letters
constexpr std::size_t kYmrFields = 12;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hex(std::uint8_t c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'F'); }
bool is_capital(std::uint8_t c) { return c >= 'A' && c <= 'Z'; }

std::string_view text_of(const std::uint8_t * bytes, std::size_t size)
{
  return {reinterpret_cast<const char *>(bytes), size};
}

std::uint8_t xor_of(const std::uint8_t * bytes, std::size_t size)
{
  unsigned sum = 0;
  for (std::size_t i = 0; i < size; ++i) {
    sum ^= bytes[i];
  }
  return static_cast<std::uint8_t>(sum);
}

bool agrees(const std::uint8_t * bytes, std::size_t star, std::size_t digits)
{
  const unsigned written = *whole_of(text_of(bytes + star + 1, digits), 16);
  const std::uint8_t * inside = bytes + 1;
  return written == (digits == 2 ? xor_of(inside, star - 1) : vn100_crc(inside, star - 1));
}

/// From the `*` on: two or four hexadecimal digits, CR, LF.
FrameScan scan_end(const std::uint8_t * bytes, std::size_t size, std::size_t star)
{
  std::size_t at = star + 1;
  while (at < size && at <= star + 4 && is_hex(bytes[at])) {
    ++at;
  }
  const std::size_t digits = at - star - 1;
  if (at == size) {
    return {FrameVerdict::kNeedsMore, 0};
  }
  if ((digits != 2 && digits != 4) || bytes[at] != '\r') {
    return {FrameVerdict::kNotAFrame, 0};
  }
  if (at + 1 == size) {
    return {FrameVerdict::kNeedsMore, 0};
  }
  if (bytes[at + 1] != '\n') {
    return {FrameVerdict::kNotAFrame, 0};
  }
  if (!agrees(bytes, star, digits)) {
    return {FrameVerdict::kBadChecksum, 0};
  }
  return {FrameVerdict::kFrame, at + 2};
}

bool starts_well(const std::uint8_t * bytes, std::size_t size)
{
  constexpr char kStart[] = "$VN";
  for (std::size_t i = 0; i < size && i < kHead; ++i) {
    if (i < 3 ? bytes[i] != static_cast<std::uint8_t>(kStart[i]) : !is_capital(bytes[i])) {
      return false;
    }
  }
  return size <= kHead || bytes[kHead] == ',' || bytes[kHead] == '*';
}

/// Three fields from the first on.
std::optional<Axes> axes_of(const AsciiSentence & sentence, std::size_t first)
{
  Axes axes{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = decimal_of(sentence.fields[first + i]);
    if (!value) {
      return std::nullopt;
    }
    axes[i] = *value;
  }
  return axes;
}

bool has_known_suffixes(const AsciiSentence & sentence)
{
  for (std::size_t i = kYmrFields; i < sentence.count; ++i) {
    const std::string_view field = sentence.fields[i];
    if (field.empty() || (field[0] != 'T' && field[0] != 'S')) {
      return false;
    }
  }
  return true;
}

}  // namespace

FrameScan scan_ascii(const std::uint8_t * bytes, std::size_t size)
{
  if (!starts_well(bytes, size)) {
    return {FrameVerdict::kNotAFrame, 0};
  }
  for (std::size_t at = kHead; at < size; ++at) {
    if (at + 7 > kLongestVn100Frame) {  // no room for the longest end
      return {FrameVerdict::kNotAFrame, 0};
    }
    if (bytes[at] == '*') {
      return scan_end(bytes, size, at);
    }
    if (bytes[at] < ' ' || bytes[at] > '~' || bytes[at] == '$') {
      return {FrameVerdict::kNotAFrame, 0};
    }
  }
  return {FrameVerdict::kNeedsMore, 0};
}

std::optional<AsciiSentence> parse_ascii(const std::uint8_t * bytes, std::size_t size)
{
  std::string_view text = text_of(bytes, size);
  AsciiSentence sentence;
  sentence.type = text.substr(3, 3);
  text = text.substr(kHead, text.find('*') - kHead);
  while (!text.empty()) {  // it begins with the comma of the next field
    if (sentence.count == AsciiSentence::kMostFields) {
      return std::nullopt;
    }
    text.remove_prefix(1);
    const std::size_t end = std::min(text.find(','), text.size());
    sentence.fields[sentence.count++] = text.substr(0, end);
    text.remove_prefix(end);
  }
  return sentence;
}

std::optional<double> decimal_of(std::string_view text)
{
  const bool negative = !text.empty() && text[0] == '-';
  if (negative || (!text.empty() && text[0] == '+')) {
    text.remove_prefix(1);
  }
  if (text.empty() || !is_digit(text.front()) || !is_digit(text.back())) {
    return std::nullopt;  // from_chars would take "inf", "nan" and a second sign
  }
  double value = 0.0;
  const auto end =
    std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (end.ec != std::errc{} || end.ptr != text.data() + text.size()) {
    return std::nullopt;
  }
  return negative ? -value : value;
}

std::optional<unsigned> whole_of(std::string_view text, int base)
{
  unsigned value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (end.ec != std::errc{} || end.ptr != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

std::optional<Vn100Sample> sample_of(const AsciiSentence & sentence)
{
  if (sentence.type != "YMR" || sentence.count < kYmrFields || !has_known_suffixes(sentence)) {
    return std::nullopt;
  }
  const auto yaw_pitch_roll = axes_of(sentence, 0);
  const auto magnetic = axes_of(sentence, 3);
  const auto acceleration = axes_of(sentence, 6);
  const auto rate = axes_of(sentence, 9);
  if (!yaw_pitch_roll || !magnetic || !acceleration || !rate) {
    return std::nullopt;
  }
  const Axes & angles = *yaw_pitch_roll;
  if (std::fabs(angles[0]) > 180.0 || std::fabs(angles[1]) > 90.0 || std::fabs(angles[2]) > 180.0) {
    return std::nullopt;
  }
  const Quaternion attitude =
    from_euler(angles[2] * kDegree, angles[1] * kDegree, angles[0] * kDegree);
  return Vn100Sample{attitude, *rate, *acceleration, std::nullopt};
}

std::string to_ascii(const std::string & body, AsciiChecksum checksum)
{
  const auto * bytes = reinterpret_cast<const std::uint8_t *>(body.data());
  char end[8];
  if (checksum == AsciiChecksum::kXor8) {
    std::snprintf(end, sizeof(end), "*%02X\r\n", unsigned{xor_of(bytes, body.size())});
  } else {
    std::snprintf(end, sizeof(end), "*%04X\r\n", unsigned{vn100_crc(bytes, body.size())});
  }
  return "$" + body + end;
}

std::string ymr_body(const Vn100Sample & sample)
{
  const Axes euler = to_euler(sample.sensor_in_ned);
  const Axes & force = sample.acceleration_m_s2;
  const Axes & rate = sample.rate_rad_s;
  char body[kLongestVn100Frame];
  std::snprintf(
    body, sizeof(body),
    "VNYMR,%+08.3f,%+08.3f,%+08.3f,+00.0000,+00.0000,+00.0000,%+07.3f,%+07.3f,%+07.3f,"
    "%+010.6f,%+010.6f,%+010.6f",
    euler[2] / kDegree, euler[1] / kDegree, euler[0] / kDegree, force[0], force[1], force[2],
    rate[0], rate[1], rate[2]);
  return body;
}

}  // namespace stetro_driver::linux_io
