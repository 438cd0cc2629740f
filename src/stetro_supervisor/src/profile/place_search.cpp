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

#include "stetro_supervisor/profile/place_search.hpp"

#include <algorithm>
#include <cmath>

#include "stetro_site/frame_transform.hpp"
#include "stetro_supervisor/profile/circular_misfit.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kPi = 3.141592653589793;
/// Differences beyond this many spacings count alike.
constexpr double kCap = 2.0;

/// Spacing with which a disc takes no more than `most` places.
double spacing_of(const SearchArea & area, const SearchGrid & grid)
{
  const double finest = area.radius_m * std::sqrt(kPi / static_cast<double>(grid.most));
  return std::max(grid.spacing_m, finest);
}

/// Shifts of the scan, in beams, that a heading within the area stands for.
std::vector<int> shifts_of(const Beams & scan, const SearchArea & area)
{
  if (!scan.closed()) {
    return {0};
  }
  const int whole = static_cast<int>(scan.size());
  const int most = static_cast<int>(std::floor(area.yaw_half_width_rad / scan.step_rad() + 1e-9));
  std::vector<int> shifts;
  for (int k = std::max(-most, -(whole - 1) / 2); k <= std::min(most, whole / 2); ++k) {
    shifts.push_back(k);
  }
  return shifts;
}

/// Keeps the best places, one of each neighbourhood.
std::vector<Place> best_of(std::vector<Place> places, std::size_t kept, double apart_m, double turn)
{
  std::sort(places.begin(), places.end(), [](const Place & a, const Place & b) {
    return a.misfit < b.misfit;
  });
  std::vector<Place> best;
  for (const Place & place : places) {
    const bool neighbour = std::any_of(best.begin(), best.end(), [&](const Place & other) {
      const double yaw = stetro_site::wrap_angle(place.pose.yaw_rad - other.pose.yaw_rad);
      return std::abs(yaw) < turn &&
             (place.pose.position_m - other.pose.position_m).squaredNorm() < apart_m * apart_m;
    });
    if (!neighbour) {
      best.push_back(place);
    }
    if (best.size() == kept) {
      break;
    }
  }
  return best;
}

}  // namespace

std::vector<Place> likely_places(
  const stetro_site::ProfileCaster & map, const FreeSpace & is_free, const Beams & scan,
  const SearchArea & area, const SearchGrid & grid)
{
  const double spacing = spacing_of(area, grid);
  const int half = static_cast<int>(area.radius_m / spacing);
  const auto shifts = shifts_of(scan, area);
  const auto n = static_cast<int>(scan.size());
  std::vector<Place> places;
  std::vector<double> model_m;
  for (int row = -half; row <= half; ++row) {
    for (int column = -half; column <= half; ++column) {
      const Eigen::Vector2d offset = spacing * Eigen::Vector2d(column, row);
      const Eigen::Vector2d at = area.around.position_m + offset;
      if (offset.norm() > area.radius_m || !is_free(at)) {
        continue;
      }
      map.cast(at, scan.fan_at(area.around.yaw_rad), grid.reach_m, model_m);
      for (int k : shifts) {
        const auto shift = static_cast<std::size_t>(k < 0 ? k + n : k);
        places.push_back(
          {{at, area.around.yaw_rad + k * scan.fan_at(0.0).step_rad},
           circular_misfit(scan.ranges_m(), model_m, shift, kCap * spacing)});
      }
    }
  }
  return best_of(std::move(places), grid.kept, 1.5 * spacing, 2.5 * scan.step_rad());
}

}  // namespace stetro_supervisor
