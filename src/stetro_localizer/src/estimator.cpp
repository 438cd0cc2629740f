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

#include "stetro_localizer/estimator.hpp"

#include <algorithm>
#include <cmath>

#include "stetro_site/standing_place.hpp"

namespace stetro_localizer
{

void note_reset(StairEstimate & estimate, ResetCause cause, const stetro_site::Pose & before)
{
  const stetro_site::Pose & after = estimate.pose;
  ++estimate.reset_counter;
  estimate.reset_cause = cause;
  estimate.reset_delta = {
    after.x_m - before.x_m, after.y_m - before.y_m, after.z_m - before.z_m,
    stetro_site::wrap_angle(after.yaw_rad - before.yaw_rad)};
}

std::optional<std::string> implausible(
  const stetro_site::Pose & pose, const stetro_site::Flight & flight, double most_yaw_rad)
{
  if (auto why = stetro_site::misplaced(pose, flight)) {
    return why;
  }
  if (std::abs(pose.yaw_rad) > most_yaw_rad) {
    return "its heading does not face the stairs";
  }
  return std::nullopt;
}

double told_variance(const stetro_site::Covariance & covariance, int i)
{
  constexpr double kLeast = 0.01 * 0.01;
  constexpr double kNotGiven = 0.1 * 0.1;
  const double given = covariance(i, i);
  return std::isfinite(given) ? std::max(given, kLeast) : kNotGiven;
}

}  // namespace stetro_localizer
