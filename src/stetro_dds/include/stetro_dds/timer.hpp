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

#ifndef STETRO_DDS__TIMER_HPP_
#define STETRO_DDS__TIMER_HPP_

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include "stetro_dds/clock.hpp"

namespace stetro_dds
{

/// Calls back once a period, in the executor's thread.
/**
 * A timer on simulated time counts that time's seconds, and starts when the time becomes known.
 * Every other timer counts seconds of the steady clock, which no clock step moves. A timer that
 * comes late fires once and skips what it missed, staying on the grid of its period.
 */
class Timer
{
public:
  enum class Counts { kNodeTime, kSteadyTime };

  /// \param callback gets the node clock's time of the call
  /// \throws std::invalid_argument if the period is not positive or the callback empty
  Timer(
    const Clock & clock, Counts counts, std::chrono::nanoseconds period,
    std::function<void(Time)> callback);

  /// Fires if due. \return whether it fired
  bool fire_if_due();

  /// Steady time of the next firing; nothing if simulated time decides it. [ns]
  [[nodiscard]] std::optional<Time> next_steady() const;

  [[nodiscard]] std::chrono::nanoseconds period() const { return period_; }
  [[nodiscard]] std::uint64_t fired() const { return fired_; }
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }  ///< periods missed
  void cancel() { cancelled_ = true; }

private:
  [[nodiscard]] bool simulated() const;

  const Clock & clock_;
  const Counts counts_;
  const std::chrono::nanoseconds period_;
  std::function<void(Time)> callback_;
  std::optional<Time> due_;  ///< on the time line the timer counts
  std::uint64_t fired_ = 0;
  std::uint64_t skipped_ = 0;
  bool cancelled_ = false;
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__TIMER_HPP_
