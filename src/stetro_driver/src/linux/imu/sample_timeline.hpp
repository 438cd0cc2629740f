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

#ifndef LINUX__IMU__SAMPLE_TIMELINE_HPP_
#define LINUX__IMU__SAMPLE_TIMELINE_HPP_

#include <algorithm>
#include <optional>

#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// When a sensor that counts its own time measured, in ours.
/**
 * A sample arrives late by an adapter's buffer and a thread's sleep, never early. So the least
 * delayed of all arrivals tells the distance of the two clocks,
 *
 *   offset_k = min(offset_{k-1} + creep (uptime_k - uptime_{k-1}), arrival_k - uptime_k)     (1)
 *   stamp_k  = uptime_k + offset_k
 *
 * where the creep lets a sensor's clock that runs slow by that much be followed. Samples that pile
 * up keep their distances, which arrivals alone would squeeze together.
 */
class SampleTimeline
{
public:
  static constexpr double kCreep = 2e-4;  ///< of two crystals, generously

  /// \param uptime of the sensor; later than the last time's
  /// \param arrival when its first bit came, as far as we know
  [[nodiscard]] Time stamp(Time uptime, Time arrival)
  {
    const Time seen = arrival - uptime;
    if (offset_) {
      const Time creep{
        static_cast<Time::rep>(kCreep * static_cast<double>((uptime - last_).count()))};
      offset_ = std::min(*offset_ + creep, seen);
    } else {
      offset_ = seen;
    }
    last_ = uptime;
    return uptime + *offset_;
  }

private:
  std::optional<Time> offset_{};
  Time last_{0};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__IMU__SAMPLE_TIMELINE_HPP_
