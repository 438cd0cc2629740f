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

#ifndef LINUX__DEVICE_CLOCK_HPP_
#define LINUX__DEVICE_CLOCK_HPP_

#include <chrono>
#include <stdexcept>
#include <string>

#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// The time of the devices: CLOCK_MONOTONIC, counted from an epoch its owner chose.
/**
 *   now = epoch + rate (monotonic - monotonic when it was made)                           (1)
 *
 * The rate is 1 on a robot. An emulated climb may run faster, or slower where a busy computer is to
 * keep the time-outs of a robot: then device time runs `rate` times as fast as the machine's, every
 * time-out and period is device time, and only what is handed to the kernel to wait for goes
 * through real().
 *
 * A value: copies show the same time, and one may be read from any thread.
 */
class DeviceClock
{
public:
  static constexpr double kSlowest = 0.1;
  static constexpr double kFastest = 1000.0;

  /// \param epoch what it shows now
  /// \throws std::invalid_argument unless the rate is from kSlowest to kFastest
  explicit DeviceClock(Time epoch = Time::zero(), double rate = 1.0)
  : epoch_(epoch), rate_(rate), origin_(monotonic())
  {
    if (!(rate >= kSlowest && rate <= kFastest)) {
      throw std::invalid_argument(
        "rate of the device clock is " + std::to_string(rate) + ", accepted: 0.1 to 1000");
    }
  }

  [[nodiscard]] Time now() const noexcept { return at(monotonic()); }

  /// Device time of a stamp of CLOCK_MONOTONIC, as the kernel puts on events of lines: (1).
  [[nodiscard]] Time at(Time stamp) const noexcept
  {
    return epoch_ + scaled(stamp - origin_, rate_);
  }

  /// How long a duration of device time lasts for the machine: what poll() is to wait.
  [[nodiscard]] Time real(Time duration) const noexcept { return scaled(duration, 1.0 / rate_); }

  [[nodiscard]] double rate() const noexcept { return rate_; }

private:
  static Time monotonic() noexcept
  {
    // libstdc++ reads CLOCK_MONOTONIC here.
    return std::chrono::duration_cast<Time>(std::chrono::steady_clock::now().time_since_epoch());
  }

  /// Exact at rate 1: a double holds nanoseconds for a hundred days only.
  static Time scaled(Time duration, double by) noexcept
  {
    return by == 1.0 ? duration
                     : Time{static_cast<Time::rep>(static_cast<double>(duration.count()) * by)};
  }

  Time epoch_;
  double rate_;
  Time origin_;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__DEVICE_CLOCK_HPP_
