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

#ifndef STETRO_DDS__CLOCK_HPP_
#define STETRO_DDS__CLOCK_HPP_

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>

#include "stetro_dds/refusal.hpp"

namespace stetro_dds
{

/// Nanoseconds since the epoch, or since the origin of simulated time.
using Time = std::chrono::nanoseconds;

/// Where a clock's time comes from.
enum class TimeSource {
  kSystem,      ///< the computer's clock
  kClockTopic,  ///< `/clock`; unknown until the first message (`use_sim_time`)
  kByHand       ///< `Clock::set`, called by the process that owns simulated time
};

/// What went wrong with time so far; all zero on a good day.
struct ClockFaults
{
  std::uint64_t zero = 0;       ///< settings to zero or less, refused
  std::uint64_t backwards = 0;  ///< settings (simulated) or steps (system) backwards, refused
  std::uint64_t forwards = 0;   ///< steps of the system clock forwards of more than 1 s, followed
  Time behind{0};               ///< how far the system clock lies behind what `now()` says
};

/// The time a node stamps with, and a steady companion to measure ages with.
/**
 * `now()` never runs backwards. When the computer's clock is stepped back, `now()` goes on at the
 * steady clock's rate from where it was, loses the excess at 1 in 1000, and the step is counted;
 * a step forwards is followed and counted.
 *
 * Safe to use from several threads.
 */
class Clock
{
public:
  explicit Clock(TimeSource source);

  [[nodiscard]] TimeSource source() const { return source_; }

  /// False while simulated time has not been heard of; `now()` is zero until then.
  [[nodiscard]] bool known() const { return now() > Time{0}; }

  /// Time since the epoch, or since the simulation's origin [ns].
  [[nodiscard]] Time now() const;

  /// Time since an arbitrary origin that no clock step moves [ns].
  [[nodiscard]] static Time steady_now();

  /// Sets simulated time. Repeating the present value is accepted and changes nothing.
  /**
   * \return a refusal for zero, for the past, and on a system clock; the time is unchanged then
   */
  std::optional<Refusal> set(Time now);

  [[nodiscard]] ClockFaults faults() const;

private:
  Time system_now() const;

  const TimeSource source_;
  mutable std::mutex mutex_;
  mutable Time now_{0};            ///< last answer (system) or last setting (simulated)
  mutable Time steady_at_now_{0};  ///< steady time of that answer
  mutable ClockFaults faults_;
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__CLOCK_HPP_
