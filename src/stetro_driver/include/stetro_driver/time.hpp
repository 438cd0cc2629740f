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

#ifndef STETRO_DRIVER__TIME_HPP_
#define STETRO_DRIVER__TIME_HPP_

#include <chrono>

namespace stetro_driver
{

/// Time of measurement or of action: since the epoch, or since the origin of simulated time.
/** Cores never read a clock: whoever calls them says what time it is. */
using Time = std::chrono::nanoseconds;

/// Seconds as a Time, to the nanosecond.
[[nodiscard]] constexpr Time seconds_to_time(double seconds)
{
  return Time{static_cast<Time::rep>(seconds * 1e9 + (seconds < 0.0 ? -0.5 : 0.5))};
}

/// A Time as seconds; exact to a microsecond over centuries.
[[nodiscard]] constexpr double time_to_seconds(Time time)
{
  return 1e-9 * static_cast<double>(time.count());
}

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__TIME_HPP_
