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

#ifndef STETRO_LOCALIZER__MEASUREMENT__SIDE_RANGE_HPP_
#define STETRO_LOCALIZER__MEASUREMENT__SIDE_RANGE_HPP_

namespace stetro_localizer
{

/// A side of the robot, and the wall beyond it.
enum class Side { kLeft, kRight };

/// Where a side beam starts.
struct SideRangeParams
{
  double mount_x_m = 0.0;  ///< beam origin in `base_link`, along x: the lever arm l [m]
  double mount_y_m = 0.0;  ///< beam origin in `base_link`, along y: + on the left [m]
};

/// Turns a side range into y, the distance of `base_link` from the right wall, and back.
/**
 * S-A and S-B eq. (1) take y = d_R, else W - d_L. That holds for sensors without offset at the
 * robot's centre. With a beam that starts at (l, m) in `base_link`, looking outward along -y
 * (right) or +y (left), a range d freed from its offset, the heading psi, and the width W between
 * the walls here (D1-4):
 *
 *   right:  y = (d - m) cos psi - l sin psi        m < 0
 *   left:   y = W - (d + m) cos psi - l sin psi    m > 0
 *
 * 10 cm of lever arm are 0.87 cm at 5 deg, the cosine is 0.46 cm at 1.2 m and 5 deg.
 * Immutable after construction.
 */
class SideRange
{
public:
  /// \throws std::invalid_argument naming the field: m on the wrong side
  SideRange(Side side, const SideRangeParams & params);

  /// y of `base_link` [m] for a corrected range.
  [[nodiscard]] double y_m(double range_m, double yaw_rad, double width_m) const;

  /// The corrected range that belongs to y: the inverse of `y_m`.
  [[nodiscard]] double range_m(double y_m, double yaw_rad, double width_m) const;

  /// dy/d(range) [-]: cos psi on the right, -cos psi on the left.
  [[nodiscard]] double slope_range(double yaw_rad) const;

  /// dy/d(psi) [m/rad].
  [[nodiscard]] double slope_yaw(double range_m, double yaw_rad) const;

  [[nodiscard]] Side side() const { return side_; }

private:
  // Range from the line through base_link along x, so that both sides share one formula.
  [[nodiscard]] double reach_m(double range_m) const;

  Side side_;
  SideRangeParams params_;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__MEASUREMENT__SIDE_RANGE_HPP_
