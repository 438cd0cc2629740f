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

#include "stetro_localizer/fused/bumper_aiding.hpp"

#include <cmath>

namespace stetro_localizer
{

Expectation expect_bumper(
  const StateVector & state, Side side, double block_x_m, double block_length_m,
  double contact_width_m)
{
  const double c = std::cos(state[kStateYaw]);
  const double s = std::sin(state[kStateYaw]);
  const bool left = side == Side::kLeft;
  const double away = left ? -1.0 : 1.0;  // d(gap)/dy
  const double half_m = contact_width_m / 2.0;
  const double end_m = block_x_m - away * std::copysign(block_length_m / 2.0, s);
  const double from_wall_m = left ? state[kStateWidth] - state[kStateY] : state[kStateY];

  Expectation gap(from_wall_m + away * end_m * s - half_m * c);
  gap.depends_on(kStateY, away);
  gap.depends_on(kStateYaw, away * end_m * c + half_m * s);
  if (left) {
    gap.depends_on(kStateWidth, 1.0);
  }
  return gap;
}

}  // namespace stetro_localizer
