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

#include "stetro_localizer/fused/front_range_aiding.hpp"

#include <cmath>

namespace stetro_localizer
{

FrontRangeAiding::FrontRangeAiding(
  Ranger ranger, double mount_x_m, double mount_y_m, double cone_excess)
: ranger_(ranger), mount_x_m_(mount_x_m), mount_y_m_(mount_y_m), stretch_(1.0 + cone_excess)
{
}

Expectation FrontRangeAiding::expect(
  const StateVector & state, SeenRiser seen, double beyond_m) const
{
  const double c = std::cos(state[kStateYaw]);
  const double s = std::sin(state[kStateYaw]);
  const double along_m = mount_x_m_ * c - mount_y_m_ * s;  // of the beam's origin, in the flight
  const double across_m = mount_x_m_ * s + mount_y_m_ * c;
  const double off_middle_m = state[kStateY] + across_m - state[kStateWidth] / 2.0;

  double face_m = 0.0;
  double t = 0.0;  // tan rho; nothing is known of the riser after the next
  int direction = -1;
  if (seen == SeenRiser::kAhead) {
    direction = kStateRiserAhead;
  } else {
    face_m = state[kStateTreadAhead] + beyond_m;
    direction = seen == SeenRiser::kNext ? int{kStateRiserNext} : -1;
  }
  if (direction >= 0) {
    t = std::tan(state[direction]);
  }
  const double across_face = c - s * t;
  const double reach_m = (face_m + off_middle_m * t - state[kStateX] - along_m) / across_face;
  const double slope = stretch_ * (1.0 + state[gain_index(ranger_)]);
  const double per_metre = slope / across_face;

  Expectation expectation(slope * reach_m + state[offset_index(ranger_)]);
  expectation.depends_on(kStateX, -per_metre);
  expectation.depends_on(kStateY, per_metre * t);
  expectation.depends_on(kStateYaw, per_metre * (along_m * t + across_m + reach_m * (s + c * t)));
  expectation.depends_on(offset_index(ranger_), 1.0);
  expectation.depends_on(gain_index(ranger_), stretch_ * reach_m);
  if (seen != SeenRiser::kAhead) {
    expectation.depends_on(kStateTreadAhead, per_metre);
  }
  if (direction >= 0) {
    expectation.depends_on(direction, per_metre * (1.0 + t * t) * (off_middle_m + reach_m * s));
    expectation.depends_on(kStateWidth, -per_metre * t / 2.0);
  }
  return expectation;
}

}  // namespace stetro_localizer
