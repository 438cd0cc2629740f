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

// A packet is told apart by its bytes alone, and what is measured survives its own wire bit by bit.
// The first byte of the input says where it is cut; the rest is taken as it is, and with the CRC
// that belongs to it.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "linux/imu/vn100_binary.hpp"
#include "require.hpp"

namespace
{

using stetro_driver::linux_io::binary_size;
using stetro_driver::linux_io::FrameVerdict;
using stetro_driver::linux_io::parse_binary;
using stetro_driver::linux_io::sample_of;
using stetro_driver::linux_io::scan_binary;
using stetro_driver::linux_io::to_binary;
using stetro_driver::linux_io::vn100_crc;

void try_packet(const std::vector<std::uint8_t> & bytes, std::size_t cut)
{
  const auto whole = scan_binary(bytes.data(), bytes.size());
  const auto part = scan_binary(bytes.data(), std::min(cut, bytes.size()));
  require(part.verdict == FrameVerdict::kNeedsMore || part.verdict == whole.verdict);
  if (whole.verdict != FrameVerdict::kFrame) {
    return;
  }
  require(whole.size <= bytes.size() && whole.size <= stetro_driver::linux_io::kLongestVn100Frame);
  const auto sample = sample_of(parse_binary(bytes.data()));
  if (sample && is_plausible(*sample)) {
    const auto packet = to_binary(*sample);
    require(scan_binary(packet.data(), packet.size()).verdict == FrameVerdict::kFrame);
    const auto again = sample_of(parse_binary(packet.data()));
    require(again && again->rate_rad_s == sample->rate_rad_s);
    require(again->acceleration_m_s2 == sample->acceleration_m_s2);
    require(again->sensor_in_ned.w == sample->sensor_in_ned.w);
  }
}

/// With the CRC that belongs to it, if it is long enough to have one.
void seal(std::vector<std::uint8_t> & bytes)
{
  if (bytes.size() < 4) {
    return;
  }
  const std::size_t size = binary_size(static_cast<std::uint16_t>(bytes[2] | (bytes[3] << 8)));
  if (size == 0 || size > bytes.size()) {
    return;
  }
  const std::uint16_t crc = vn100_crc(bytes.data() + 1, size - 3);
  bytes[size - 2] = static_cast<std::uint8_t>(crc >> 8);
  bytes[size - 1] = static_cast<std::uint8_t>(crc);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * input, std::size_t size)
{
  if (size < 2) {
    return 0;
  }
  const std::size_t cut = input[0];
  std::vector<std::uint8_t> bytes(input + 1, input + size);
  try_packet(bytes, cut);
  seal(bytes);
  try_packet(bytes, cut);
  return 0;
}
