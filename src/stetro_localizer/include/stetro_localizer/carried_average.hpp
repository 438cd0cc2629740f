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

#ifndef STETRO_LOCALIZER__CARRIED_AVERAGE_HPP_
#define STETRO_LOCALIZER__CARRIED_AVERAGE_HPP_

#include <array>
#include <cstddef>
#include <optional>

#include "stetro_localizer/samples.hpp"

namespace stetro_localizer
{

/// The papers' moving average, without its lag.
/**
 * S-A and S-B smooth the ranges with a moving average and give no window. A plain average of n
 * readings lags by (n - 1)/2 periods: 6 readings at 30 Hz and 0.15 m/s are 12.5 mm behind. Each
 * reading is therefore kept with the value that a faster sensor (odometry for distances, the
 * integrated gyroscope for turns) had at that time, its carrier c, and the average is taken of the
 * readings carried to the present:
 *
 *   mean(t) = 1/n sum_k (v_k - c_k) + c(t)
 *
 * With a carrier held at zero it is the papers' plain average. Readings older than `max_age` have
 * left the window, and fewer than `least_count` make no average.
 *
 * No heap memory: the window has at most `kCapacity` readings.
 */
class CarriedAverage
{
public:
  static constexpr std::size_t kCapacity = 64;

  struct Mean
  {
    double value;       ///< average carried to the present
    std::size_t count;  ///< readings in it
  };

  /// \throws std::invalid_argument unless 1 <= least_count <= window <= kCapacity and max_age > 0
  CarriedAverage(std::size_t window, std::size_t least_count, Nanoseconds max_age);

  /// Takes a reading; the oldest leaves a full window.
  void add(Nanoseconds stamp, double value, double carrier);

  /// The average as it stands at `now`, where the carrier reads `carrier`.
  [[nodiscard]] std::optional<Mean> at(Nanoseconds now, double carrier) const;

  void clear() { count_ = 0; }

private:
  struct Entry
  {
    Nanoseconds stamp{0};
    double value = 0.0;  // with the carrier taken off
  };

  std::size_t window_;
  std::size_t least_count_;
  Nanoseconds max_age_;
  std::array<Entry, kCapacity> entries_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__CARRIED_AVERAGE_HPP_
