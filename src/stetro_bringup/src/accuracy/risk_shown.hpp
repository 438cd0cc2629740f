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

#ifndef ACCURACY__RISK_SHOWN_HPP_
#define ACCURACY__RISK_SHOWN_HPP_

#include <cmath>
#include <cstdint>

#include "accuracy/estimator_totals.hpp"
#include "accuracy/proportion.hpp"

namespace stetro_bringup
{

/// What a campaign shows of the integrity risk that its estimates state.
struct RiskShown
{
  double stated = 0.0;              ///< per step; NaN: none
  std::uint64_t times = 0;          ///< treads with an error beyond its level for too long while OK
  std::uint64_t steps = 0;          ///< treads watched
  double at_most_95 = 0.0;          ///< the risk is below it with 95 % confidence
  double clean_steps_needed = 0.0;  ///< to claim what is stated: -ln(0.05) / stated
  /// The steps carry the claim. Without it nothing speaks against what is stated, nor for it.
  [[nodiscard]] bool carried() const { return at_most_95 <= stated; }
};

[[nodiscard]] inline RiskShown risk_shown(const EstimatorTotals & totals)
{
  constexpr double kOneSided95 = 0.90;  // two-sided, of which only the upper bound is used
  const ClimbScore & counts = totals.counts;
  return {
    totals.stated_risk, counts.treads_misled, counts.treads,
    garwood(counts.treads_misled, counts.treads, kOneSided95).high,
    std::ceil(-std::log(0.05) / totals.stated_risk)};
}

}  // namespace stetro_bringup

#endif  // ACCURACY__RISK_SHOWN_HPP_
