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

#ifndef LINUX__CLOCK_SHIFT_HPP_
#define LINUX__CLOCK_SHIFT_HPP_

#include <algorithm>
#include <optional>

#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// What to add to device time to have the caller's.
/**
 * The caller has read its clock a little before we read ours, so the largest difference is the
 * truest, and as long as it holds the stamps of one measurement do not change. A caller's clock
 * that runs slower, as one does that makes up for a step back of the wall clock, is followed: a
 * difference that was not reached for a second is given up, and one of half a second at once.
 */
class ClockShift
{
public:
  [[nodiscard]] Time take(Time caller, Time device)
  {
    const Time seen = caller - device;
    if (!shift_ || seen > *shift_ || seen < *shift_ - kStep) {
      shift_ = seen;
      begin_anew(device, seen);
      return *shift_;
    }
    largest_ = std::max(largest_, seen);
    if (device - since_ >= kWindow) {
      if (largest_ < *shift_ - kTolerance) {
        shift_ = largest_;
      }
      begin_anew(device, seen);
    }
    return *shift_;
  }

private:
  static constexpr Time kStep = std::chrono::milliseconds{500};
  static constexpr Time kWindow = std::chrono::seconds{1};
  static constexpr Time kTolerance = std::chrono::milliseconds{1};

  void begin_anew(Time device, Time seen)
  {
    since_ = device;
    largest_ = seen;
  }

  std::optional<Time> shift_{};
  Time since_{0};    // the window's begin, in device time
  Time largest_{0};  // of the window
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__CLOCK_SHIFT_HPP_
