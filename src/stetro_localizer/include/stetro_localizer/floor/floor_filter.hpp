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

#ifndef STETRO_LOCALIZER__FLOOR__FLOOR_FILTER_HPP_
#define STETRO_LOCALIZER__FLOOR__FLOOR_FILTER_HPP_

#include "stetro_localizer/floor/floor_params.hpp"
#include "stetro_localizer/floor/floor_state.hpp"

namespace stetro_localizer
{

/// A pose on a floor that was found by another road, and its covariance.
struct PoseFix
{
  Eigen::Vector3d pose = Eigen::Vector3d::Zero();            ///< x, y [m], heading [rad]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< [m^2, m rad, rad^2]
};

/// A fix against the state, before it is used.
struct FixInnovation
{
  Eigen::Vector3d value;       ///< fix less state, the heading wrapped
  Eigen::Matrix3d covariance;  ///< S = H P H^T + R

  /// nu^T S^-1 nu: chi-square of three degrees of freedom if the model is right.
  [[nodiscard]] double nis() const;
};

/// Kalman filter over the error of the pose on a floor, of the gyroscope and of the wheels.
/**
 * With the counted speed (ux, uy) in `base_link`, v = u / (1 + s), and the gyroscope's reading w,
 * each over the interval that ends at its own stamp:
 *
 *   roll:  x += (vx cos psi - vy sin psi) dt,   y += (vx sin psi + vy cos psi) dt
 *   turn:  psi += (w - b) dt
 *
 * The error is additive in every state; the heading's is an angle about +z. Trivially copyable, so
 * that the past can be kept and resumed. Nothing here allocates or throws.
 *
 * Derivation: docs/derivations/floor_filter.md.
 */
class FloorFilter
{
public:
  [[nodiscard]] const FloorVector & state() const { return x_; }
  [[nodiscard]] const FloorMatrix & covariance() const { return P_; }
  [[nodiscard]] double operator[](int index) const { return x_[index]; }
  [[nodiscard]] double variance(int index) const { return P_(index, index); }

  /// Begins from a state and its covariance, which must be symmetric and positive.
  void set(const FloorVector & state, const FloorMatrix & covariance);

  /// Makes the pose known by a fix alone, independent of the other states.
  void set_pose(const PoseFix & fix);

  /// Wheels that count `ux_mps`, `uy_mps` for dt [s].
  /** \param along density of the position along the motion [m/sqrt(s)], 0 while standing */
  void roll(double dt_s, double ux_mps, double uy_mps, double along, double across);

  /// A gyroscope that reads `rate_radps` for dt [s].
  /** \param density of its noise [rad/s/sqrt(Hz)] */
  void turn(double dt_s, double rate_radps, double density);

  /// Lets the constant errors wander for dt [s].
  void wander(double dt_s, const FloorNoise & noise);

  /// A standing robot's gyroscope reads its bias.
  /** \return false if it lies beyond `gate` squared standard deviations, and changes nothing */
  bool stand(double rate_radps, double variance, double gate);

  [[nodiscard]] FixInnovation innovation(const PoseFix & fix) const;

  /// Uses a fix (Joseph's form, so that the covariance stays positive for any R).
  void correct(const PoseFix & fix);

private:
  FloorVector x_ = FloorVector::Zero();
  FloorMatrix P_ = FloorMatrix::Identity();
};

/// g such that a chi-square variable of three degrees of freedom exceeds it with this probability.
/** Bisection on P(X > g) = erfc(sqrt(g / 2)) + sqrt(2 g / pi) exp(-g / 2). */
[[nodiscard]] double chi_square_3_quantile(double probability);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FLOOR__FLOOR_FILTER_HPP_
