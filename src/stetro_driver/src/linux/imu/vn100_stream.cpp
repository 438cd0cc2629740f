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

#include "linux/imu/vn100_stream.hpp"

#include <algorithm>

namespace stetro_driver::linux_io
{
namespace
{

FrameScan scan(const std::uint8_t * bytes, std::size_t size)
{
  return bytes[0] == '$' ? scan_ascii(bytes, size) : scan_binary(bytes, size);
}

}  // namespace

std::size_t Vn100Stream::take(const std::uint8_t * bytes, std::size_t size)
{
  // There is room: find() keeps less than one frame.
  const std::size_t taken = std::min(size, bytes_.size() - kept_);
  std::copy_n(bytes, taken, bytes_.begin() + static_cast<std::ptrdiff_t>(kept_));
  kept_ += taken;
  return taken;
}

std::optional<std::size_t> Vn100Stream::find()
{
  std::size_t start = 0;
  FrameScan found;
  for (; start < kept_; ++start) {
    found = scan(bytes_.data() + start, kept_ - start);
    if (found.verdict == FrameVerdict::kFrame || found.verdict == FrameVerdict::kNeedsMore) {
      break;
    }
    counts_.bad_checksums += found.verdict == FrameVerdict::kBadChecksum ? 1 : 0;
  }
  counts_.lost_bytes += start;
  drop(start);
  if (kept_ == 0 || found.verdict != FrameVerdict::kFrame) {
    return std::nullopt;
  }
  ++counts_.frames;
  frame_size_ = found.size;
  return found.size;
}

std::optional<Vn100Frame> Vn100Stream::parse() const
{
  if (bytes_[0] != '$') {
    return Vn100Frame{parse_binary(bytes_.data())};
  }
  const auto sentence = parse_ascii(bytes_.data(), frame_size_);
  return sentence ? std::optional<Vn100Frame>{*sentence} : std::nullopt;
}

void Vn100Stream::drop(std::size_t size)
{
  std::copy(
    bytes_.begin() + static_cast<std::ptrdiff_t>(size),
    bytes_.begin() + static_cast<std::ptrdiff_t>(kept_), bytes_.begin());
  kept_ -= size;
}

}  // namespace stetro_driver::linux_io
