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

#include "linux/loop_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kFinest = 1e-6;  // upper edge of the first bin [s]

Time mean(Time sum, std::uint64_t count)
{
  return count == 0 ? Time{0} : sum / static_cast<Time::rep>(count);
}

}  // namespace

void LoopStatistics::begin(Time now)
{
  if (begun_) {
    const Time period = now - *begun_;
    const Time error = period > period_ ? period - period_ : period_ - period;
    ++periods_;
    all_periods_ += period;
    worst_ = std::max(worst_, error);
    ++bins_[bin_of(error)];
  }
  begun_ = now;
}

void LoopStatistics::end(Time now)
{
  if (!begun_) {
    return;
  }
  const Time work = now - *begun_;
  ++cycles_;
  overruns_ += work > period_ ? 1 : 0;
  all_work_ += work;
  longest_work_ = std::max(longest_work_, work);
}

/// Bin b holds errors up to kFinest 2^(b / kPerOctave).
std::size_t LoopStatistics::bin_of(Time error)
{
  const double octaves = std::log2(time_to_seconds(error) / kFinest);  // -inf of none
  const double bin = std::ceil(kPerOctave * std::max(octaves, 0.0));
  return static_cast<std::size_t>(std::min(bin, static_cast<double>(kBins - 1)));
}

Time LoopStatistics::quantile(double share) const
{
  const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(periods_)));
  std::uint64_t count = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    count += bins_[bin];
    if (count >= wanted && count > 0) {
      const double edge = kFinest * std::exp2(static_cast<double>(bin) / kPerOctave);
      return std::min(seconds_to_time(edge), worst_);
    }
  }
  return worst_;
}

LoopSummary LoopStatistics::summary() const
{
  return {cycles_,         overruns_, mean(all_periods_, periods_), quantile(0.5),
          quantile(0.999), worst_,    mean(all_work_, cycles_),     longest_work_};
}

}  // namespace stetro_driver::linux_io
