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

#ifndef STETRO_LOCALIZER__FUSED__ERROR_STATE_FILTER_HPP_
#define STETRO_LOCALIZER__FUSED__ERROR_STATE_FILTER_HPP_

#include <array>
#include <cstddef>

#include "stetro_localizer/fused/expectation.hpp"
#include "stetro_localizer/fused/state.hpp"
#include "stetro_localizer/stored_state.hpp"

namespace stetro_localizer
{

/// How fast each state wanders: square roots of spectral densities.
struct ProcessNoise
{
  double acceleration = 0.3;     ///< what the speed may have changed by from sample to sample [m/s]
  double turn = 2e-4;            ///< of the gyroscope's reading [rad/s/sqrt(Hz)]
  double gyro_bias = 2e-6;       ///< [rad/s/sqrt(s)]
  double odom_scale = 1e-5;      ///< [1/sqrt(s)]
  double range_offset = 1.2e-4;  ///< slow drift of a range sensor [m/sqrt(s)]
  double range_gain = 1e-5;      ///< [1/sqrt(s)]
  double creep = 1e-4;           ///< position while the wheels stand [m/sqrt(s)]
  double slip = 3e-3;            ///< position along the motion while they turn [m/sqrt(s)]
};

/// Innovation of one scalar measurement, before it is used.
struct Innovation
{
  double value = 0.0;     ///< measured less expected
  double variance = 0.0;  ///< H P H^T + R

  /// Its square in standard deviations: chi-square of one degree of freedom if the model is right.
  [[nodiscard]] double nis() const { return value * value / variance; }
};

/// The states that a measurement corrects; the doubt in all the others still counts (Schmidt).
class Corrects
{
public:
  static Corrects all() { return Corrects(StateVector::Ones()); }
  static Corrects only(int index) { return Corrects(StateVector::Unit(index)); }

  /// \return these but one
  [[nodiscard]] Corrects but(int index) const
  {
    Corrects fewer = *this;
    fewer.of_[index] = 0.0;
    return fewer;
  }

  /// Zero where nothing is corrected.
  [[nodiscard]] StateVector of(const StateVector & vector) const
  {
    return of_.cwiseProduct(vector);
  }

private:
  explicit Corrects(const StateVector & of) : of_(of) {}

  StateVector of_;  // ones and zeros
};

/// Kalman filter over the error of the state: covariance propagation and scalar updates.
/**
 * The error is additive in every state; the heading's is an angle about +z. Trivially copyable, so
 * that the past can be kept and resumed. Nothing here allocates or throws.
 *
 * Beside the states goes the edge, the riser ahead in the flight frame: the sum of the treads below
 * as they were believed when block 2 left them. No measurement corrects it, but its doubt and what
 * it has in common with the states are kept (Schmidt): the place in the flight frame is edge + x.
 *
 * Derivation: docs/derivations/fused_estimator.md.
 */
class ErrorStateFilter
{
public:
  [[nodiscard]] const StateVector & state() const { return x_; }
  [[nodiscard]] const StateMatrix & covariance() const { return P_; }
  [[nodiscard]] double operator[](int index) const { return x_[index]; }
  [[nodiscard]] double variance(int index) const { return P_(index, index); }

  /// Variance of the edge [m^2].
  [[nodiscard]] double edge_variance() const { return edge_variance_; }
  /// Covariance of the edge with each state.
  [[nodiscard]] const StateVector & edge_covariance() const { return edge_covariance_; }

  /// Begins the edge anew, by the site file.
  /** \param of_tread_here the part of the variance that is the doubt of the tread here */
  void begin_edge(double variance, double of_tread_here);

  /// Makes a state known as `value` with `variance`, independent of all the others.
  void set(int index, double value, double variance);

  /// Makes several states known together, independent of all the others.
  template <int kSize>
  void set(
    const std::array<int, kSize> & indices, const Eigen::Matrix<double, kSize, 1> & values,
    const Eigen::Matrix<double, kSize, kSize> & covariance)
  {
    for (int i = 0; i < kSize; ++i) {
      set(indices[static_cast<std::size_t>(i)], values[i], 0.0);
    }
    for (int i = 0; i < kSize; ++i) {
      for (int j = 0; j < kSize; ++j) {
        P_(indices[static_cast<std::size_t>(i)], indices[static_cast<std::size_t>(j)]) =
          covariance(i, j);
      }
    }
  }

  /// Adds independent noise to one state.
  void inflate(int index, double variance) { P_(index, index) += variance; }

  /// Adds noise that moves all states together, by so much in standard deviations of one.
  void inflate(const StateVector & along, double variance)
  {
    P_.noalias() += variance * along * along.transpose();
  }

  /// Moves one state by what is known with `variance`, independently of all the others.
  void shift(int index, double by, double variance)
  {
    x_[index] += by;
    P_(index, index) += variance;
  }

  /// Moves on by dt [s] with the gyroscope's reading [rad/s].
  /**
   *   x += (vx cos psi - vy sin psi) dt,  y += (vx sin psi + vy cos psi) dt,
   *   psi += (rate - bias) dt
   *
   * \param slipping the wheels turn: they may slip along the motion
   */
  void predict(double dt_s, double rate_radps, const ProcessNoise & noise, bool slipping);

  [[nodiscard]] Innovation innovation(
    const Expectation & expectation, double measured, double variance) const;

  /// Uses the measurement whose innovation this is; `expectation` is of the present state.
  void correct(
    const Expectation & expectation, const Innovation & innovation,
    const Corrects & corrects = Corrects::all());

  /// Offsets and gains of the range sensors and the scale of the wheels, to be kept.
  [[nodiscard]] FusedCalibration calibration() const;

  /// Takes them from where they were kept. They are then independent of all other states.
  void set_calibration(const FusedCalibration & calibration);

  /// Block 2 came to stand one tread higher: the next riser is the one ahead now.
  /**
   *   x -= tread ahead,  tread here = tread ahead,  rho ahead = rho next,
   * and a new tread and riser, known by the site file, come into sight. The edge moves on by the
   * tread ahead.
   */
  void climb(double tread_m, double tread_variance, double riser_variance);

  /// The reverse; the tread that comes back into use is known by the site file alone.
  void descend(double tread_m, double tread_variance, double riser_variance);

private:
  void add_noise(double dt_s, const ProcessNoise & noise, bool slipping);
  void copy_row(int to, int from);

  StateVector x_ = StateVector::Zero();
  StateMatrix P_ = StateMatrix::Zero();
  StateVector edge_covariance_ = StateVector::Zero();
  double edge_variance_ = 0.0;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__ERROR_STATE_FILTER_HPP_
