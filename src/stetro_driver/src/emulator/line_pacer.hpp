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

#ifndef EMULATOR__LINE_PACER_HPP_
#define EMULATOR__LINE_PACER_HPP_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "stetro_driver/time.hpp"

namespace stetro_driver::emulator
{

/// One direction of a serial line: bytes arrive no faster than its speed lets them.
/**
 * A byte of 8N1 takes ten bits. A pseudo-terminal delivers at once at any speed; this is where the
 * time on the wire comes from. Knows no clock: whoever uses it says what time it is.
 */
class LinePacer
{
public:
  /// Puts bytes on the line behind those already on it. \param baud above 0 [bit/s]
  void send(const std::uint8_t * from, std::size_t size, Time now, std::uint32_t baud)
  {
    const Time per_byte{10'000'000'000LL / baud};
    Time at = bytes_.empty() ? now : std::max(now, bytes_.back().arrives);
    for (std::size_t i = 0; i < size; ++i) {
      at += per_byte;
      bytes_.push_back({at, from[i]});
    }
  }

  /// Takes what has arrived by now. \return how many bytes
  [[nodiscard]] std::size_t receive(std::uint8_t * to, std::size_t room, Time now)
  {
    std::size_t count = 0;
    while (count < room && !bytes_.empty() && bytes_.front().arrives <= now) {
      to[count++] = bytes_.front().value;
      bytes_.pop_front();
    }
    return count;
  }

  /// When the last byte on the line will have arrived: the time to look again.
  [[nodiscard]] std::optional<Time> all_arrived() const
  {
    return bytes_.empty() ? std::nullopt : std::optional<Time>{bytes_.back().arrives};
  }

  void clear() { bytes_.clear(); }

private:
  struct Byte
  {
    Time arrives;
    std::uint8_t value;
  };
  std::deque<Byte> bytes_;
};

}  // namespace stetro_driver::emulator

#endif  // EMULATOR__LINE_PACER_HPP_
