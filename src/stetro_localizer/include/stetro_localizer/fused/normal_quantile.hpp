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

#ifndef STETRO_LOCALIZER__FUSED__NORMAL_QUANTILE_HPP_
#define STETRO_LOCALIZER__FUSED__NORMAL_QUANTILE_HPP_

#include <cmath>

namespace stetro_localizer
{

/// k such that a normal variable lies outside +-k standard deviations with this probability.
/** Bisection on erfc: P(|z| > k) = erfc(k / sqrt 2). \param probability in (0, 1) */
[[nodiscard]] inline double two_sided_quantile(double probability)
{
  double low = 0.0;
  double high = 40.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2.0;
    (std::erfc(middle / std::sqrt(2.0)) > probability ? low : high) = middle;
  }
  return (low + high) / 2.0;
}

/// Standard deviations of the levels along, across and in heading, for the risk of all three.
/** That one of three errors is beyond its level is at most as likely as the three together. */
[[nodiscard]] inline double protection_quantile(double integrity_risk)
{
  return two_sided_quantile(integrity_risk / 3.0);
}

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__NORMAL_QUANTILE_HPP_
