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

#ifndef STETRO_LOCALIZER__FUSED__BUMPER_AIDING_HPP_
#define STETRO_LOCALIZER__FUSED__BUMPER_AIDING_HPP_

#include "stetro_localizer/fused/expectation.hpp"
#include "stetro_localizer/measurement/side_range.hpp"

namespace stetro_localizer
{

/// A bumper that has just closed: its nearer end touches the wall.
/**
 * With that end at (l, +-R_w/2) in `base_link` the gap is zero at this moment (D1-2, D1-4):
 *
 *   right:  0 = y + l sin psi - (R_w/2) cos psi
 *   left:   0 = W - y - l sin psi - (R_w/2) cos psi
 *
 * A bumper spans its block, and the end nearer to the wall is the one that the heading leans
 * towards it. Each of the three closes by itself, so that two tell y and the heading.
 */
[[nodiscard]] Expectation expect_bumper(
  const StateVector & state, Side side, double block_x_m, double block_length_m,
  double contact_width_m);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__BUMPER_AIDING_HPP_
