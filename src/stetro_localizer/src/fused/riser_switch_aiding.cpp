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

#include "stetro_localizer/fused/riser_switch_aiding.hpp"

#include <cmath>

namespace stetro_localizer
{

Expectation expect_riser_switch(const StateVector & state, double tip_x_m, double tip_y_m)
{
  const double c = std::cos(state[kStateYaw]);
  const double s = std::sin(state[kStateYaw]);
  const double t = std::tan(state[kStateRiserAhead]);
  const double along_m = tip_x_m * c - tip_y_m * s;
  const double across_m = tip_x_m * s + tip_y_m * c;
  const double off_middle_m = state[kStateY] + across_m - state[kStateWidth] / 2.0;

  Expectation gap(off_middle_m * t - state[kStateX] - along_m);
  gap.depends_on(kStateX, -1.0);
  gap.depends_on(kStateY, t);
  gap.depends_on(kStateYaw, along_m * t + across_m);
  gap.depends_on(kStateRiserAhead, off_middle_m * (1.0 + t * t));
  gap.depends_on(kStateWidth, -t / 2.0);
  return gap;
}

}  // namespace stetro_localizer
