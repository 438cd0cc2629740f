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

#ifndef STETRO_LOCALIZER__MEASUREMENT__TOF_NOISE_HPP_
#define STETRO_LOCALIZER__MEASUREMENT__TOF_NOISE_HPP_

#include <cstddef>

namespace stetro_localizer
{

/// What averaging does not take out of a time-of-flight reading.
struct TofSystematics
{
  double slow_m = 0.0012;       ///< standard deviation of the drift that averaging leaves [m]
  double gain_sigma = 0.03;     ///< standard deviation of the gain about 1 [-]
  double offset_sigma = 0.010;  ///< standard deviation of the offset before calibration [m]
};

/// How a time-of-flight reading errs.
/**
 * White noise of sqrt(white^2 + (white_per_m d)^2) shrinks with averaging. Slow drift does not: on
 * a recorded VL53L0X the mean of many readings does not settle below about 1 mm
 * (docs/derivations/range_noise.md). The gain error grows with the distance from where the offset
 * was calibrated.
 */
struct TofNoise
{
  double white_m = 0.0021;     ///< white standard deviation at zero range [m]
  double white_per_m = 0.015;  ///< growth of the white standard deviation with range [m/m]
  TofSystematics systematic;
};

/// Variance of the white noise of one reading at a range [m^2].
[[nodiscard]] double white_variance_m2(const TofNoise & noise, double range_m);

/// Variance of an average of `count` readings at a range [m^2].
/**
 *   var = white(d)^2 / n + slow^2 + (gain_sigma (d - d_c))^2 + var_b
 *
 * \param offset_variance_m2 var_b of the calibrated offset
 * \param calibrated_at_m range d_c at which the offset was found; 0 before any calibration
 */
[[nodiscard]] double mean_variance_m2(
  const TofNoise & noise, double range_m, std::size_t count, double offset_variance_m2,
  double calibrated_at_m);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__MEASUREMENT__TOF_NOISE_HPP_
