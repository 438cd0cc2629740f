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

#ifndef LINUX__LINES__CONTACT_DEBOUNCE_HPP_
#define LINUX__LINES__CONTACT_DEBOUNCE_HPP_

#include <cstdint>
#include <optional>

#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

struct DebounceLimits
{
  Time release = std::chrono::milliseconds{15};  ///< open for so long, then it is released
  std::uint64_t most_edges = 200;                ///< in a second: a switch, and not a loose wire
};

/// Why a contact is not to be believed.
enum class ContactTrouble : std::uint8_t {
  kNone,
  kNotFitted,
  kStuckClosed,  ///< closed at the start, and never seen open
  kChatters,     ///< changes faster than a switch can be pressed
  kLost,         ///< its line cannot be read
};

/// What a contact did, for diagnostics.
struct ContactStatistics
{
  std::uint64_t presses = 0;
  std::uint64_t edges = 0;
  std::uint64_t unheralded = 0;  ///< presses that only the level showed: their edge was lost
};

/// One switch: closed at the first sign, open only after it has kept still.
/**
 *   open   --(edge to active, or active level)------------> closed
 *   closed --(inactive for `release` without an edge)-----> open
 *
 * A bumper that touches must stop the robot at once, and contacts bounce for 1 to 10 ms; a touch
 * too short for the level to show is told by its edges. Reads no clock.
 */
class ContactDebounce
{
public:
  ContactDebounce() : ContactDebounce(DebounceLimits{}) {}
  explicit ContactDebounce(const DebounceLimits & limits);

  /// The first level of all. \param may_be_closed closed is a state and no fault, as of a button
  void begin(bool active, bool may_be_closed);
  /// An edge that was drained.
  void edge(bool active, Time stamp);
  /// The level, read after the edges were drained.
  void level(bool active, Time now);
  /// Its line cannot be read; until the next level.
  void lose() noexcept { lost_ = true; }

  [[nodiscard]] bool closed() const noexcept { return closed_; }
  /// Inactive, and not for long enough yet.
  [[nodiscard]] bool settling() const noexcept { return open_since_.has_value(); }
  [[nodiscard]] ContactTrouble trouble() const noexcept;
  [[nodiscard]] ContactReading reading() const noexcept;
  [[nodiscard]] const ContactStatistics & statistics() const noexcept { return statistics_; }

private:
  void press(Time when) noexcept;
  void count_edges(Time now) noexcept;

  DebounceLimits limits_;
  bool closed_ = false;
  bool stuck_ = false;
  bool chatters_ = false;
  bool lost_ = false;
  Time last_change_{0};
  std::optional<Time> open_since_{};
  Time second_began_{0};
  std::uint64_t edges_in_second_ = 0;
  ContactStatistics statistics_{};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__LINES__CONTACT_DEBOUNCE_HPP_
