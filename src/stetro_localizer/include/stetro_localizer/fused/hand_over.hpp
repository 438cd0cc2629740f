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

#ifndef STETRO_LOCALIZER__FUSED__HAND_OVER_HPP_
#define STETRO_LOCALIZER__FUSED__HAND_OVER_HPP_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "stetro_localizer/samples.hpp"

namespace stetro_localizer
{

/// Hands the estimate over from sensor to sensor without a jump.
/**
 * A sensor that comes into sight finds what went unseen meanwhile, a slip above all, and the filter
 * is right to believe it at once. A controller that follows the pose had better not: when the set
 * of sensors in sight changes, the correction of that sample is withheld from what is published
 * and let out over time,
 *
 *   published = filter + h,   h <- h - correction at a change,   h(t + dt) = h(t) exp(-dt / tau)
 *
 * The filter itself knows nothing of it, and whoever publishes counts h as doubt.
 */
class HandOver
{
public:
  /// \param tau_s time in which two thirds of a correction are let out; 0 withholds nothing [s]
  explicit HandOver(double tau_s) : tau_s_(tau_s) {}

  /// A sample of ranges has been taken.
  /** \param in_sight a bit for each sensor that saw its target
   *  \param correction_m what it has moved the filter by, x and y [m] */
  void note(std::uint32_t in_sight, Nanoseconds time, const std::array<double, 2> & correction_m)
  {
    const bool changed = in_sight != in_sight_ && tau_s_ > 0.0;
    for (std::size_t axis = 0; axis < withheld_m_.size(); ++axis) {
      const double left_m = withheld_m(axis, time) - (changed ? correction_m[axis] : 0.0);
      withheld_m_[axis] = std::clamp(left_m, -kMost_m, kMost_m);
    }
    in_sight_ = in_sight;
    time_ = time;
  }

  /// What the published pose lacks of the filter's along an axis, x or y [m].
  [[nodiscard]] double withheld_m(std::size_t axis, Nanoseconds time) const
  {
    const double age_s = std::max(seconds(time - time_), 0.0);
    return tau_s_ > 0.0 ? withheld_m_[axis] * std::exp(-age_s / tau_s_) : 0.0;
  }

  /// The filter's pose is published as it is: a contact has told it.
  void let_out(std::size_t axis) { withheld_m_[axis] = 0.0; }

private:
  static constexpr double kMost_m = 0.03;  // what is more is a jump and shall be seen as one

  double tau_s_;
  std::array<double, 2> withheld_m_{};
  std::uint32_t in_sight_ = 0;
  Nanoseconds time_{0};
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__HAND_OVER_HPP_
