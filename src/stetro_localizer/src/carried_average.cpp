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

#include "stetro_localizer/carried_average.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace stetro_localizer
{

CarriedAverage::CarriedAverage(std::size_t window, std::size_t least_count, Nanoseconds max_age)
: window_(window), least_count_(least_count), max_age_(max_age)
{
  if (window < 1 || window > kCapacity) {
    throw std::invalid_argument(
      "window: " + std::to_string(window) + " refused, accepted: 1 to " +
      std::to_string(kCapacity));
  }
  if (least_count < 1 || least_count > window) {
    throw std::invalid_argument(
      "least_count: " + std::to_string(least_count) + " refused, accepted: 1 to the window of " +
      std::to_string(window));
  }
  if (max_age <= Nanoseconds{0}) {
    throw std::invalid_argument(
      "max_age: " + std::to_string(seconds(max_age)) + " s refused, accepted: more than 0");
  }
}

void CarriedAverage::add(Nanoseconds stamp, double value, double carrier)
{
  entries_[next_] = {stamp, value - carrier};
  next_ = (next_ + 1) % window_;
  count_ = std::min(count_ + 1, window_);
}

std::optional<CarriedAverage::Mean> CarriedAverage::at(Nanoseconds now, double carrier) const
{
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t back = 1; back <= count_; ++back) {
    const Entry & entry = entries_[(next_ + window_ - back) % window_];
    if (entry.stamp + max_age_ >= now) {
      sum += entry.value;
      ++count;
    }
  }
  if (count < least_count_) {
    return std::nullopt;
  }
  return Mean{sum / static_cast<double>(count) + carrier, count};
}

}  // namespace stetro_localizer
