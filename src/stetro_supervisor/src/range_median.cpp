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
#include "stetro_supervisor/range_median.hpp"

#include <algorithm>
#include <limits>

namespace stetro_supervisor
{
namespace
{

/// The reading as a distance, or nothing if the sensor cannot be believed.
std::optional<double> distance_m(const Range & range)
{
  switch (range.status) {
    case RangeStatus::kValid:
      return range.range_m;
    case RangeStatus::kTooNear:
      return 0.0;
    case RangeStatus::kNoTarget:
      return std::numeric_limits<double>::infinity();
    default:
      return std::nullopt;
  }
}

}  // namespace

void RangeMedian::take(const Range & range)
{
  if (range.time <= last_) {
    return;
  }
  last_ = range.time;
  const auto distance = distance_m(range);
  sound_ = distance.has_value();
  if (sound_) {
    last_three_m_[count_ % last_three_m_.size()] = *distance;
    ++count_;
  }
}

std::optional<double> RangeMedian::value_m() const
{
  if (!sound_ || count_ < last_three_m_.size()) {
    return std::nullopt;
  }
  auto sorted = last_three_m_;
  std::sort(sorted.begin(), sorted.end());
  return sorted[1];
}

}  // namespace stetro_supervisor
