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
#include <mutex>
#include <optional>

#include "stetro_dds/monotone_time.hpp"
#include "stetro_dds/refusal.hpp"

namespace stetro_dds
{

/// Where a clock's time comes from.
enum class TimeSource {
  kSystem,      ///< the computer's clock
  kClockTopic,  ///< `/clock`; unknown until the first message (`use_sim_time`)
  kByHand       ///< `Clock::set`, called by the process that owns simulated time
};

/// The time a node stamps with, and a steady companion to measure ages with.
/**
 * `now()` never runs backwards: see MonotoneTime for the computer's clock, `set` for a simulated one.
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
   * A jump ahead of more than ten seconds is refused until as many settings in a row have agreed on
   * it: one stray message must not take a node into a future that it can never leave, and a process
   * that was stopped for a while finds its time again.
   *
   * \return a refusal for zero, for the past, for a jump and on a system clock; the time is
   *   unchanged then
   */
  std::optional<Refusal> set(Time now);

  [[nodiscard]] ClockFaults faults() const;

private:
  const TimeSource source_;
  mutable std::mutex mutex_;
  mutable MonotoneTime system_;
  [[nodiscard]] bool is_stray_jump(Time now);

  Time simulated_{0};
  Time jumped_to_{0};  ///< last setting refused as a jump
  int agreeing_ = 0;   ///< settings in a row that agree with it
  ClockFaults simulated_faults_;
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__CLOCK_HPP_
