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

#ifndef STETRO_DDS__MONOTONE_TIME_HPP_
#define STETRO_DDS__MONOTONE_TIME_HPP_

#include <chrono>
#include <cstdint>

namespace stetro_dds
{

/// Nanoseconds since the epoch, or since the origin of simulated time.
using Time = std::chrono::nanoseconds;

/// What went wrong with time so far; all zero on a good day.
struct ClockFaults
{
  std::uint64_t zero = 0;       ///< settings to zero or less, refused
  std::uint64_t backwards = 0;  ///< settings (simulated) or steps (system) backwards, refused
  std::uint64_t forwards = 0;   ///< steps of the system clock forwards of more than 1 s, followed
  Time behind{0};               ///< how far the system clock lies behind what `now()` says
};

/// The computer's clock without its steps backwards.
/**
 * When that clock is stepped back, time goes on at the steady clock's rate from where it was and
 * loses the excess at 1 in 1000; a step forwards is followed. Both are counted.
 */
class MonotoneTime
{
public:
  /// \param wall what the computer's clock says
  /// \param steady what the steady clock says at the same moment
  /// \return a time that is never less than the one before
  Time advance(Time wall, Time steady);

  [[nodiscard]] const ClockFaults & faults() const { return faults_; }

private:
  Time time_{0};
  Time steady_{0};
  ClockFaults faults_;
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__MONOTONE_TIME_HPP_
