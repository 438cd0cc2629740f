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

#ifndef STETRO_LOCALIZER__FUSED__CONE_HPP_
#define STETRO_LOCALIZER__FUSED__CONE_HPP_

#include <cmath>

namespace stetro_localizer
{

/// What a cone of light measures of a flat wall at a slant, against the distance square to it.
/**
 * A ray at angle theta to the wall's normal meets it at D / cos theta, D the distance square to the
 * wall, and brings back light in proportion to cos(theta) / (D / cos theta)^2, which is cos^3
 * theta. Over a cone whose axis is at the incidence psi,
 *
 *   range = D f(psi),   f(psi) = E[cos^2 theta] / E[cos^3 theta].
 *
 * A ray at the angle a off the axis, turned by phi about it, has cos theta = cos psi cos a +
 * sin psi sin a cos phi. With E over phi, and over cos a even in [c0, 1] (equal solid angles), c0
 * the cosine of half the cone,
 *
 *   E[cos^2 theta] = cos^2 psi E[cos^2 a] + (1/2) sin^2 psi E[sin^2 a]
 *   E[cos^3 theta] = cos^3 psi E[cos^3 a] + (3/2) cos psi sin^2 psi E[cos a sin^2 a]
 *
 * A cone of zero is a ray: f = 1 / cos psi. One of 25 deg reads 1.2 % too much when square, and
 * grows with the slant a little less than its axis does: f(psi) / f(0) is 0.07 % below 1 / cos psi
 * at 10 deg, 0.8 % at 30 deg. It reads less than the axis alone beyond 35 deg only.
 */
class ConeOnWall
{
public:
  /// \param cone_rad full angle of the cone, below pi [rad]; 0 is a ray
  explicit ConeOnWall(double cone_rad)
  {
    const double c0 = std::cos(cone_rad / 2.0);
    // Means of c^n over [c0, 1], without the difference of nearly equal numbers.
    cos2_ = (1.0 + c0 + c0 * c0) / 3.0;
    cos3_ = (1.0 + c0) * (1.0 + c0 * c0) / 4.0;
    cos_sin2_ = (1.0 + c0) / 2.0 - cos3_;
  }

  /// f: what it measures for each metre square to the wall [-]. \param incidence_rad below pi/2
  [[nodiscard]] double stretch(double incidence_rad) const
  {
    const double c = std::cos(incidence_rad);
    const double s = std::sin(incidence_rad);
    return squares(c, s) / cubes(c, s);
  }

  /// df/d(incidence) [1/rad]
  [[nodiscard]] double slope(double incidence_rad) const
  {
    const double c = std::cos(incidence_rad);
    const double s = std::sin(incidence_rad);
    const double top = squares(c, s);
    const double bottom = cubes(c, s);
    const double d_top = s * c * (1.0 - 3.0 * cos2_);
    const double d_bottom =
      -3.0 * c * c * s * cos3_ + 1.5 * cos_sin2_ * (2.0 * s * c * c - s * s * s);
    return (d_top * bottom - top * d_bottom) / (bottom * bottom);
  }

private:
  [[nodiscard]] double squares(double c, double s) const
  {
    return c * c * cos2_ + 0.5 * s * s * (1.0 - cos2_);
  }
  [[nodiscard]] double cubes(double c, double s) const
  {
    return c * c * c * cos3_ + 1.5 * c * s * s * cos_sin2_;
  }

  double cos2_;      // E[cos^2 a]
  double cos3_;      // E[cos^3 a]
  double cos_sin2_;  // E[cos a sin^2 a]
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__CONE_HPP_
