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

#ifndef STETRO_LOCALIZER__FUSED__RISER_SWITCH_AIDING_HPP_
#define STETRO_LOCALIZER__FUSED__RISER_SWITCH_AIDING_HPP_

#include "stetro_localizer/fused/expectation.hpp"

namespace stetro_localizer
{

/// A riser switch that has just closed: its tip touches the riser ahead.
/**
 * With the tip at (l, m) in `base_link`:
 *
 *   0 = (y + l sin psi + m cos psi - W/2) tan rho - (x + l cos psi - m sin psi)
 *
 * One gives the distance, both give the heading against that riser.
 */
[[nodiscard]] Expectation expect_riser_switch(
  const StateVector & state, double tip_x_m, double tip_y_m);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__RISER_SWITCH_AIDING_HPP_
