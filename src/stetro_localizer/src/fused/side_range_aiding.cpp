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

#include "stetro_localizer/fused/side_range_aiding.hpp"

#include <cmath>

namespace stetro_localizer
{

SideRangeAiding::SideRangeAiding(Side side, const SideRangeParams & mount, double cone_excess)
: left_(side == Side::kLeft),
  ranger_(left_ ? Ranger::kSideLeft : Ranger::kSideRight),
  mount_(mount),
  stretch_(1.0 + cone_excess)
{
}

Expectation SideRangeAiding::expect(const StateVector & state) const
{
  const double c = std::cos(state[kStateYaw]);
  const double s = std::sin(state[kStateYaw]);
  const double away = left_ ? -1.0 : 1.0;  // d(distance)/dy
  const double from_wall_m = left_ ? state[kStateWidth] - state[kStateY] : state[kStateY];
  const double reach_m = (from_wall_m + away * (mount_.mount_x_m * s + mount_.mount_y_m * c)) / c;
  const double slope = stretch_ * (1.0 + state[gain_index(ranger_)]);

  Expectation expectation(slope * reach_m + state[offset_index(ranger_)]);
  expectation.depends_on(kStateY, away * slope / c);
  expectation.depends_on(kStateYaw, slope * (from_wall_m * s + away * mount_.mount_x_m) / (c * c));
  expectation.depends_on(offset_index(ranger_), 1.0);
  expectation.depends_on(gain_index(ranger_), stretch_ * reach_m);
  if (left_) {
    expectation.depends_on(kStateWidth, slope / c);
  }
  return expectation;
}

}  // namespace stetro_localizer
