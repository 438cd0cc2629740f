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

#ifndef LINUX__LOOP_STATISTICS_HPP_
#define LINUX__LOOP_STATISTICS_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// How well a loop of fixed rate keeps its time.
struct LoopSummary
{
  std::uint64_t cycles = 0;
  std::uint64_t overruns = 0;  ///< cycles that worked longer than a period
  Time mean_period{0};         ///< from wake-up to wake-up
  Time period_error_p50{0};    ///< of |wake-up to wake-up, less the period|
  Time period_error_p999{0};   ///< 99.9 %; quantiles are told 9 % too large at most
  Time period_error_max{0};    ///< exact
  Time mean_work{0};           ///< from wake-up to the end of the cycle
  Time longest_work{0};
};

/// Counts the cycles of a loop, without allocating: a histogram of fixed size, by octaves.
/** Reads no clock. One thread. */
class LoopStatistics
{
public:
  /// \param period the one wanted, above zero
  explicit LoopStatistics(Time period) : period_(period) {}

  /// A cycle begins: the loop woke up. \param now steady
  void begin(Time now);
  /// Its work is done.
  void end(Time now);

  [[nodiscard]] LoopSummary summary() const;

private:
  static constexpr int kPerOctave = 8;
  static constexpr std::size_t kBins = 24 * kPerOctave;  // from 1 us to some 16 s

  [[nodiscard]] static std::size_t bin_of(Time error);
  [[nodiscard]] Time quantile(double share) const;

  Time period_;
  std::optional<Time> begun_{};
  std::array<std::uint64_t, kBins> bins_{};  ///< of period errors
  std::uint64_t periods_ = 0;
  Time all_periods_{0};
  Time worst_{0};
  std::uint64_t cycles_ = 0;
  std::uint64_t overruns_ = 0;
  Time all_work_{0};
  Time longest_work_{0};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__LOOP_STATISTICS_HPP_
