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

#ifndef STETRO_LOCALIZER__MEASUREMENT__FRONT_PAIR_HPP_
#define STETRO_LOCALIZER__MEASUREMENT__FRONT_PAIR_HPP_

namespace stetro_localizer
{

/// S-A and S-B eq. (2), counter-clockwise positive: psi = atan2(d_left - d_right, D) [rad].
/**
 * The papers' text turns left and calls that positive, their formula makes it negative, and their
 * Algorithm I then turns the robot further away. This is the consistent reading (D1-6): psi > 0
 * asks for a clockwise turn. D is the distance between the two beams, not the body's width (D1-7).
 *
 * \param difference_m d_left - d_right, freed from its constant bias [m]
 * \param baseline_m D [m], positive
 */
[[nodiscard]] double heading_from_pair(double difference_m, double baseline_m);

/// Variance of eq. (2) for a variance of the difference [rad^2].
/**
 *   d psi / d delta = D / (D^2 + delta^2) = cos^2 psi / D,   var psi = (cos^2 psi / D)^2 var delta
 */
[[nodiscard]] double heading_variance(
  double difference_m, double baseline_m, double difference_variance_m2);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__MEASUREMENT__FRONT_PAIR_HPP_
