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

#include "stetro_site/standing_place.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace stetro_site
{
namespace
{

std::string metres(double value_m)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3f m", value_m);
  return text;
}

std::string between(double low_m, double high_m)
{
  return ", accepted: " + metres(low_m) + " to " + metres(high_m);
}

}  // namespace

std::optional<std::string> misplaced(const Pose & pose, const Flight & flight)
{
  if (!std::isfinite(pose.x_m + pose.y_m + pose.z_m + pose.yaw_rad)) {
    return "a number of the pose is not finite";
  }
  const int step = flight.step_at(pose.x_m);
  const double z_m = flight.tread_z_m(step);
  const double half_riser_m = flight.riser_m(std::max(step, 1)) / 2.0;
  if (std::abs(pose.z_m - z_m) > half_riser_m) {
    return "z " + metres(pose.z_m) + " is not the height of step " + std::to_string(step) +
           ", which is under x " + metres(pose.x_m) +
           between(z_m - half_riser_m, z_m + half_riser_m);
  }
  const double width_m = flight.width_m(std::clamp(pose.x_m, 0.0, flight.total_run_m()));
  if (pose.y_m < 0.0 || pose.y_m > width_m) {
    return "y " + metres(pose.y_m) + " is not between the walls" + between(0.0, width_m);
  }
  return std::nullopt;
}

}  // namespace stetro_site
