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
  Ranger ranger, double mount_x_m, double mount_y_m, const ConeOnWall & cone)
: ranger_(ranger), mount_x_m_(mount_x_m), mount_y_m_(mount_y_m), cone_(cone)
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
  double rho = 0.0;  // nothing is known of the riser behind and of the one after the next
  int direction = -1;
  if (seen == SeenRiser::kBehind) {
    face_m = -state[kStateTreadHere];
  } else if (seen == SeenRiser::kAhead) {
    direction = kStateRiserAhead;
  } else {
    face_m = state[kStateTreadAhead] + beyond_m;
    direction = seen == SeenRiser::kNext ? int{kStateRiserNext} : -1;
  }
  if (direction >= 0) {
    rho = state[direction];
  }
  const double t = std::tan(rho);
  const double cos_rho = std::cos(rho);
  const double along_x_m = face_m + off_middle_m * t - state[kStateX] - along_m;
  const double square_m = along_x_m * cos_rho;
  const double incidence = state[kStateYaw] + rho;
  const double gain = 1.0 + state[gain_index(ranger_)];
  const double stretch = cone_.stretch(incidence);
  const double turning = gain * cone_.slope(incidence) * square_m;
  const double per_metre = gain * stretch * cos_rho;

  Expectation expectation(gain * stretch * square_m + state[offset_index(ranger_)]);
  expectation.depends_on(kStateX, -per_metre);
  expectation.depends_on(kStateY, per_metre * t);
  expectation.depends_on(kStateYaw, turning + per_metre * (along_m * t + across_m));
  expectation.depends_on(offset_index(ranger_), 1.0);
  expectation.depends_on(gain_index(ranger_), stretch * square_m);
  if (seen == SeenRiser::kBehind) {
    expectation.depends_on(kStateTreadHere, -per_metre);
  } else if (seen != SeenRiser::kAhead) {
    expectation.depends_on(kStateTreadAhead, per_metre);
  }
  if (direction >= 0) {
    expectation.depends_on(
      direction, turning + per_metre * (off_middle_m * (1.0 + t * t) - along_x_m * t));
    expectation.depends_on(kStateWidth, -per_metre * t / 2.0);
  }
  return expectation;
}

}  // namespace stetro_localizer
