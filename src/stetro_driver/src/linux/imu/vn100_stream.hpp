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

#ifndef LINUX__IMU__VN100_STREAM_HPP_
#define LINUX__IMU__VN100_STREAM_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "linux/imu/vn100_ascii.hpp"
#include "linux/imu/vn100_binary.hpp"

namespace stetro_driver::linux_io
{

/// One frame of either kind. A sentence's texts are good until the stream is fed again.
using Vn100Frame = std::variant<AsciiSentence, BinaryPacket>;

struct StreamCounts
{
  std::uint64_t frames = 0;
  std::uint64_t bad_checksums = 0;
  std::uint64_t lost_bytes = 0;  ///< that belong to no frame
};

/// Finds sentences and packets in what a VN-100 sends, which mixes both once it is asked something.
/**
 * What proves to be no frame loses its first byte only, and the search goes on behind it: 0xFA
 * and `$` also occur inside packets, and a frame may begin inside a broken one. The frames do not
 * depend on the portions in which the bytes come. Allocates nothing.
 */
class Vn100Stream
{
public:
  /// \param sink called as sink(frame, age): age is the number of fed bytes from its first one on
  template <class Sink>
  void feed(const std::uint8_t * bytes, std::size_t size, Sink && sink)
  {
    while (size > 0) {
      const std::size_t taken = take(bytes, size);
      bytes += taken;
      size -= taken;
      while (const std::optional<std::size_t> frame_size = find()) {
        if (const std::optional<Vn100Frame> frame = parse()) {
          sink(*frame, kept_ + size);
        }
        drop(*frame_size);
      }
    }
  }

  [[nodiscard]] const StreamCounts & counts() const { return counts_; }

private:
  /// As many as there is room for, at least one.
  std::size_t take(const std::uint8_t * bytes, std::size_t size);
  /// Drops what is no frame. \return size of the frame that the kept bytes then begin with
  std::optional<std::size_t> find();
  [[nodiscard]] std::optional<Vn100Frame> parse() const;
  void drop(std::size_t size);

  std::array<std::uint8_t, 4 * kLongestVn100Frame> bytes_{};
  std::size_t kept_ = 0;
  std::size_t frame_size_ = 0;
  StreamCounts counts_{};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__IMU__VN100_STREAM_HPP_
