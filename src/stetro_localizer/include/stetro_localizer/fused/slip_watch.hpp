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

#ifndef STETRO_LOCALIZER__FUSED__SLIP_WATCH_HPP_
#define STETRO_LOCALIZER__FUSED__SLIP_WATCH_HPP_

#include <algorithm>
#include <cmath>

namespace stetro_localizer
{

/// Notices that the body has moved without its wheels.
/**
 * A slip shifts all innovations along one axis the same way. Two one-sided cumulative sums of the
 * normalised innovations z, each less a drift of half the shift to be found, rise when the mean is
 * no longer zero (Page 1954):
 *
 *   S+ = max(0, S+ + z - drift),   S- = max(0, S- - z - drift),   alarm when either passes `limit`
 *
 * With drift 0.75 and limit 4.5 a sound filter alarms about once in 2000 innovations, a shift of
 * three standard deviations within three.
 */
class SlipWatch
{
public:
  /// \param normalised innovation along the axis in its own standard deviations, signed by the axis
  /// \return the axis has shifted; both sums start again
  bool add(double normalised)
  {
    const double z = std::clamp(normalised, -kMostOfOne, kMostOfOne);
    up_ = std::max(0.0, up_ + z - kDrift);
    down_ = std::max(0.0, down_ - z - kDrift);
    const bool alarm = std::max(up_, down_) > kLimit;
    if (alarm) {
      clear();
    }
    return alarm;
  }

  void clear() { up_ = down_ = 0.0; }

private:
  static constexpr double kDrift = 0.75;
  static constexpr double kLimit = 4.5;
  static constexpr double kMostOfOne = 3.5;  // one wild reading alone is no slip

  double up_ = 0.0;
  double down_ = 0.0;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__SLIP_WATCH_HPP_
