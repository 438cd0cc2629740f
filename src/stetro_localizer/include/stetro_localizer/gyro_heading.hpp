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

#ifndef STETRO_LOCALIZER__GYRO_HEADING_HPP_
#define STETRO_LOCALIZER__GYRO_HEADING_HPP_

#include "stetro_localizer/samples.hpp"
#include "stetro_localizer/scalar_estimate.hpp"

namespace stetro_localizer
{

/// Noise of the gyroscope.
struct GyroParams
{
  double white_radps = 0.0018;       ///< standard deviation of one sample [rad/s]
  double bias_sigma_radps = 0.0052;  ///< of the bias before it is learned [rad/s]
  double bias_walk = 1.0e-5;         ///< random walk of the bias [rad/s/sqrt(s)]
  double still_limit_radps = 0.035;  ///< a faster turn is not learned as bias [rad/s]
  double longest_gap_s = 0.1;        ///< longer silence is not bridged by the gyroscope [s]
  double gap_rate_radps = 0.1;       ///< turn rate assumed possible in a silence [rad/s]
};

/// Turn by the gyroscope: what bridges the time in which the front pair has no riser ahead.
/**
 * This is ours, not the papers', which have no heading then. The bias is learned while the robot
 * stands, one scalar Kalman update a sample, and taken off:
 *
 *   angle(t) = sum (rate - bias) dt
 *   var(t) = sum (white dt)^2 + (sigma_bias T)^2 + gaps        since the last mark, T ago
 */
class GyroHeading
{
public:
  explicit GyroHeading(const GyroParams & params);

  /// Integrates one sample, and learns the bias if the robot stands.
  /**
   * \return false if the silence before it was too long: the turn in it is unknown, and the
   *   variance has grown by what it may have been
   */
  bool add(const GyroSample & sample, bool standing);

  /// Turned angle since the beginning, not wrapped [rad].
  [[nodiscard]] double angle_rad() const { return angle_rad_; }

  /// Forgets the drift: the heading was just fixed by other means.
  void mark();

  /// Variance of the turned angle since the last mark [rad^2].
  [[nodiscard]] double variance_since_mark() const;

  [[nodiscard]] const ScalarEstimate & bias() const { return bias_; }
  void set_bias(const ScalarEstimate & bias) { bias_ = bias; }

private:
  GyroParams params_;
  ScalarEstimate bias_;
  Nanoseconds last_{0};
  double angle_rad_ = 0.0;
  double time_since_mark_s_ = 0.0;
  double white_since_mark_ = 0.0;  // rad^2
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__GYRO_HEADING_HPP_
