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

#include "linux/tof/vl53l0x_reading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stetro_driver::linux_io
{

std::optional<int> parse_millimetres(std::string_view text) noexcept
{
  constexpr std::size_t kMostDigits = 4;
  if (text.size() < 2 || text.size() > kMostDigits + 1 || text.back() != '\n') {
    return std::nullopt;
  }
  text.remove_suffix(1);
  const bool digits =
    std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!digits || (text.size() > 1 && text.front() == '0')) {
    return std::nullopt;
  }
  int millimetres = 0;
  for (const char c : text) {
    millimetres = 10 * millimetres + (c - '0');
  }
  return millimetres <= kNoTargetAltMm ? std::optional<int>{millimetres} : std::nullopt;
}

RangeReading range_reading(int millimetres, const TofLimits & limits, Time stamp) noexcept
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  RangeReading reading;
  reading.stamp = stamp;
  if (millimetres == kNoTargetMm || millimetres == kNoTargetAltMm) {
    reading.range_m = kInfinity;
    reading.status = RangeStatus::kNoTarget;
    return reading;
  }
  const double range_m = millimetres / 1000.0;
  if (range_m < limits.min_range_m) {
    reading.range_m = -kInfinity;
    reading.status = RangeStatus::kTooNear;
    return reading;
  }
  reading.range_m = range_m;
  reading.std_dev_m = std::hypot(limits.sigma_m, limits.sigma_per_m * range_m);
  reading.status = range_m > limits.reliable_range_m ? RangeStatus::kWeak : RangeStatus::kValid;
  return reading;
}

}  // namespace stetro_driver::linux_io
