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

#include "stetro_supervisor/profile/published_centre_of_mass.hpp"

#include <cmath>

#include "edge_moments.hpp"

namespace stetro_supervisor
{

std::optional<ProfileMoments> moments_of(const Beams & beams, const std::vector<double> & ranges_m)
{
  return edge_moments(
    beams, [&](std::size_t i) { return std::isfinite(ranges_m[i]); },
    [&](std::size_t i) { return ranges_m[i]; });
}

Eigen::Vector2d corrected_position(
  const ScannerPose & believed, const Eigen::Vector2d & model_centroid_m,
  const Eigen::Vector2d & robot_centroid_m)
{
  return believed.position_m + rotation(believed.yaw_rad) * (model_centroid_m - robot_centroid_m);
}

PublishedSearch published_search(
  const stetro_site::ProfileCaster & map, const Beams & scan, const ScannerPose & believed,
  const PublishedLimits & limits)
{
  PublishedSearch search;
  const auto robot = moments_of(scan, scan.ranges_m());
  ScannerPose at = believed;
  std::vector<double> model_m;
  for (int i = 0; robot && i < limits.iterations && !search.settled; ++i) {
    map.cast(at.position_m, scan.fan_at(at.yaw_rad), limits.reach_m, model_m);
    const auto model = moments_of(scan, model_m);
    if (!model) {
      break;
    }
    const Eigen::Vector2d next = corrected_position(at, model->centroid_m, robot->centroid_m);
    search.settled = (next - at.position_m).norm() < limits.settled_m;
    at.position_m = next;
    search.positions_m.push_back(next);
  }
  return search;
}

}  // namespace stetro_supervisor
