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

SideRangeAiding::SideRangeAiding(Side side, const SideRangeParams & mount, const ConeOnWall & cone)
: left_(side == Side::kLeft),
  ranger_(left_ ? Ranger::kSideLeft : Ranger::kSideRight),
  mount_(mount),
  cone_(cone)
{
}

Expectation SideRangeAiding::expect(const StateVector & state) const
{
  const double yaw = state[kStateYaw];
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  const double away = left_ ? -1.0 : 1.0;  // d(distance)/dy
  const double from_wall_m = left_ ? state[kStateWidth] - state[kStateY] : state[kStateY];
  const double square_m = from_wall_m + away * (mount_.mount_x_m * s + mount_.mount_y_m * c);
  const double square_slope = away * (mount_.mount_x_m * c - mount_.mount_y_m * s);
  const double stretch = cone_.stretch(yaw);
  const double gain = 1.0 + state[gain_index(ranger_)];

  Expectation expectation(gain * stretch * square_m + state[offset_index(ranger_)]);
  expectation.depends_on(kStateY, away * gain * stretch);
  expectation.depends_on(kStateYaw, gain * (cone_.slope(yaw) * square_m + stretch * square_slope));
  expectation.depends_on(offset_index(ranger_), 1.0);
  expectation.depends_on(gain_index(ranger_), stretch * square_m);
  if (left_) {
    expectation.depends_on(kStateWidth, gain * stretch);
  }
  return expectation;
}

}  // namespace stetro_localizer
