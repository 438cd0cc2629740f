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

#ifndef STETRO_LOCALIZER__FUSED__TREAD_GAUGE_HPP_
#define STETRO_LOCALIZER__FUSED__TREAD_GAUGE_HPP_

#include <array>
#include <optional>

#include "stetro_localizer/scalar_estimate.hpp"

namespace stetro_localizer
{

/// Offset and gain of the front pair, left and right, as they were known at one time.
struct FrontCalibration
{
  std::array<double, 2> offset_m{};  ///< [m]
  std::array<double, 2> gain{};      ///< [-]
  double depth_variance = 0.0;       ///< what they leave open of a depth, by the pair's mean [m^2]
};

/// The depth of the tread ahead by the front pair alone, from a touch of the riser ahead.
/**
 * The filter believes the site file: a tread that is off by many of its standard deviations shifts
 * offsets and x instead, or its ranges fail their gates. This one believes nothing. At the touch x
 * is known, a moment later block 1 stands and the pair looks at the far end of the tread, from as
 * near as it ever does.
 */
class TreadGauge
{
public:
  /// The riser ahead was touched: x, and the way since the beginning, of that moment.
  /** Once there are enough readings, later touches are of a robot that sweeps, and do not count. */
  void touch(double x_m, double travel_m);

  /// x by the touch and the wheels since; nothing without a touch, or after some way.
  [[nodiscard]] std::optional<double> x_m(double travel_m) const;

  /// Takes what a reading says of the depth, and its own variance.
  void add(double depth_m, double noise_variance);

  /// The mean, once there are enough readings of it.
  /** \param calibration_variance what the calibration leaves open [m^2] */
  [[nodiscard]] std::optional<ScalarEstimate> depth_m(double calibration_variance) const;

private:
  bool touched_ = false;
  double touched_x_m_ = 0.0;
  double touched_travel_m_ = 0.0;
  int count_ = 0;
  double sum_m_ = 0.0;
  double noise_sum_ = 0.0;  // of the variances
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__TREAD_GAUGE_HPP_
