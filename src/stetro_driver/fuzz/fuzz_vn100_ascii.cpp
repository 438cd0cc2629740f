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

// A sentence is told apart by its bytes alone, and what is measured survives its own wire.
// The first byte of the input says where it is cut; the rest is taken as it is, and as the body of
// a sentence whose checksum agrees.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "linux/imu/vn100_ascii.hpp"
#include "require.hpp"

namespace
{

using stetro_driver::linux_io::AsciiChecksum;
using stetro_driver::linux_io::FrameVerdict;
using stetro_driver::linux_io::parse_ascii;
using stetro_driver::linux_io::sample_of;
using stetro_driver::linux_io::scan_ascii;
using stetro_driver::linux_io::to_ascii;

const std::uint8_t * bytes_of(const std::string & text)
{
  return reinterpret_cast<const std::uint8_t *>(text.data());
}

void try_sentence(const std::string & text, std::size_t cut)
{
  const auto whole = scan_ascii(bytes_of(text), text.size());
  const auto part = scan_ascii(bytes_of(text), std::min(cut, text.size()));
  require(part.verdict == FrameVerdict::kNeedsMore || part.verdict == whole.verdict);
  if (whole.verdict != FrameVerdict::kFrame) {
    return;
  }
  const auto sentence = parse_ascii(bytes_of(text), whole.size);
  const auto sample = sentence ? sample_of(*sentence) : std::nullopt;
  if (sample && is_plausible(*sample)) {
    const std::string printed = to_ascii(ymr_body(*sample));
    const auto again = scan_ascii(bytes_of(printed), printed.size());
    require(again.verdict == FrameVerdict::kFrame);
    require(sample_of(*parse_ascii(bytes_of(printed), again.size)).has_value());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * input, std::size_t size)
{
  if (size < 2) {
    return 0;
  }
  const std::size_t cut = input[0];
  const std::string text(input + 1, input + size);
  try_sentence(text, cut);
  try_sentence(to_ascii(text), cut);
  try_sentence(to_ascii(text, AsciiChecksum::kCrc16), cut);
  return 0;
}
