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

#ifndef STETRO_LOCALIZER__STAIRCASE_AS_BUILT_HPP_
#define STETRO_LOCALIZER__STAIRCASE_AS_BUILT_HPP_

#include <optional>
#include <vector>

#include "stetro_localizer/scalar_estimate.hpp"
#include "stetro_site/flight.hpp"

namespace stetro_localizer
{

/// One step as an estimator found it; what the robot's sensors could not tell is missing.
struct StepAsBuilt
{
  int step = 0;                           ///< 1 to N; 0: none
  std::optional<ScalarEstimate> tread_m;  ///< depth of its tread at mid width [m]
  std::optional<ScalarEstimate> width_m;  ///< between the walls [m]
};

enum class StepMeasure { kTread, kWidth };

/// "tread", "width".
[[nodiscard]] const char * to_string(StepMeasure measure);

/// A measure of a step as found, beside the site file's.
struct Deviation
{
  int step = 0;
  StepMeasure measure = StepMeasure::kTread;
  ScalarEstimate found_m;  ///< [m]
  double site_m = 0.0;     ///< [m]

  [[nodiscard]] double by_m() const { return found_m.value - site_m; }

  /// Larger than the bound, and no doubt of the estimate explains it: 3 of its standard deviations.
  [[nodiscard]] bool exceeds(double bound_m) const;
};

/// Every measure that was found, in the order of `steps`. The width is that at the tread's middle.
[[nodiscard]] std::vector<Deviation> deviations(
  const std::vector<StepAsBuilt> & steps, const stetro_site::Flight & flight);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__STAIRCASE_AS_BUILT_HPP_
