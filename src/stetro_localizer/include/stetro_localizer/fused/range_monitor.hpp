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

#ifndef STETRO_LOCALIZER__FUSED__RANGE_MONITOR_HPP_
#define STETRO_LOCALIZER__FUSED__RANGE_MONITOR_HPP_

#include "stetro_localizer/samples.hpp"

namespace stetro_localizer
{

/// Watches one range sensor for what no single reading shows: that it is dead or stuck.
/**
 * A reading of whole millimetres with noise of two repeats itself by chance once in seven times;
 * `kMostAlike` in a row have a chance of about 1e-9. So a stuck sensor shows without motion too.
 */
class RangeMonitor
{
public:
  void note(const RangeReading & reading)
  {
    const bool answers = reading.status != RangeStatus::kAbsent &&
                         reading.status != RangeStatus::kFault &&
                         reading.status != RangeStatus::kStale;
    if (!answers) {
      return;
    }
    answered_ = reading.stamp;
    if (reading.status != RangeStatus::kValid) {
      alike_ = 0;
      return;
    }
    missed_ = 0;
    alike_ = reading.range_m == last_m_ ? alike_ + 1 : 0;
    last_m_ = reading.range_m;
  }

  /// It has not answered for longer than `patience_s`, or never since `since`.
  [[nodiscard]] bool dead(Nanoseconds now, Nanoseconds since, double patience_s) const
  {
    return seconds(now - (answered_ > since ? answered_ : since)) > patience_s;
  }

  /// It has not seen what was in its reach.
  void miss() { ++missed_; }

  /// It has seen it, although it cannot say how far away it is; once it is blind, only a distance
  /// clears it.
  void meet() { missed_ = blind() ? missed_ : 0; }

  /// It has missed what was in its reach again and again.
  [[nodiscard]] bool blind() const { return missed_ >= kMostMissed; }

  /// It repeats itself to the millimetre.
  [[nodiscard]] bool stuck() const { return alike_ >= kMostAlike; }

private:
  static constexpr int kMostAlike = 11;
  static constexpr int kMostMissed = 15;  // half a second

  Nanoseconds answered_{0};
  double last_m_ = -1.0;
  int alike_ = 0;
  int missed_ = 0;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__RANGE_MONITOR_HPP_
