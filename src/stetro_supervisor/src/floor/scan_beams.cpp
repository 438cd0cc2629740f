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

#include "stetro_supervisor/floor/scan_beams.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "stetro_supervisor/four_beams/cell_reach.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kTurn_rad = 6.283185307179586;
constexpr double kShare = 0.03;  // of the range: what a small error of the heading adds at a slant

/// The beam of a scan that points nearest to a direction in the lidar's axes; none if none near.
std::ptrdiff_t index_towards(const stetro_site::BeamFan & fan, double direction_rad)
{
  const double turns = std::remainder(direction_rad - fan.first_rad, kTurn_rad) / fan.step_rad;
  const double around = std::abs(kTurn_rad / fan.step_rad);
  const auto index = std::llround(turns < -0.5 ? turns + around : turns);
  return index >= 0 && index < static_cast<std::ptrdiff_t>(fan.count) ? index : -1;
}

/// What most of the three rays about a beam say, as REP 117; NaN where they say nothing together.
double median_about(const RangeProfile & profile, std::ptrdiff_t index)
{
  const auto count = static_cast<std::ptrdiff_t>(profile.ranges_m.size());
  std::vector<double> said_m;
  for (std::ptrdiff_t i = -1; i <= 1; ++i) {
    const double range_m = profile.ranges_m[static_cast<std::size_t>((index + i + count) % count)];
    if (!std::isnan(range_m)) {
      said_m.push_back(range_m);
    }
  }
  std::sort(said_m.begin(), said_m.end());
  if (said_m.size() < 2) {
    return std::nan("");
  }
  const double lower_m = said_m[(said_m.size() - 1) / 2];
  const double upper_m = said_m[said_m.size() / 2];
  const bool one_kind = std::isfinite(lower_m) && std::isfinite(upper_m);
  return lower_m == upper_m ? lower_m : one_kind ? 0.5 * (lower_m + upper_m) : std::nan("");
}

}  // namespace

ScanBeams beams_of(const Scan & scan, const stetro_site::Lidar & lidar, const FloorParams & params)
{
  RangeError error;
  error.short_m = error.long_m = params.beam_error_m;
  error.short_share = error.long_share = kShare;
  error.dependable_m = std::min(params.dependable_m, lidar.max_range_m);
  error.too_near_m = lidar.min_range_m;
  ScanBeams few;
  for (std::size_t i = 0; i < kScanBeams; ++i) {
    const double yaw_rad = kTurn_rad * static_cast<double>(i) / kScanBeams;
    const auto index = index_towards(scan.profile.fan, yaw_rad);
    few.beams.push_back({{lidar.x_m, lidar.y_m}, lidar.yaw_rad + yaw_rad, error});
    few.ranges_m.push_back(index < 0 ? std::nan("") : median_about(scan.profile, index));
  }
  return few;
}

bool beams_allow(const DrawnFloor & floor, const ScanBeams & beams, const FloorPlace & place)
{
  const auto & grid = floor.grid();
  const auto own = grid.cell_at(place.position_m);
  const double yaw_rad = place.yaw_rad - grid.frame().yaw_rad;
  std::array<std::size_t, 9> agreeing{};  // of the place's cell and those about it
  std::size_t speaking = 0;
  for (std::size_t i = 0; i < beams.beams.size(); ++i) {
    const RangeBeam & beam = beams.beams[i];
    const auto bounds = distance_bounds(beams.ranges_m[i], beam.error, grid.resolution_m());
    if (!bounds) {
      continue;
    }
    ++speaking;
    const Eigen::Vector2d shift_cells = rotation(yaw_rad) * beam.origin_m / grid.resolution_m();
    const CellReach reach(grid, yaw_rad + beam.yaw_rad, shift_cells);
    for (int near = 0; near < 9; ++near) {
      const Reach here = reach.from({own.column + near % 3 - 1, own.row + near / 3 - 1});
      agreeing[static_cast<std::size_t>(near)] +=
        here.allows(bounds->shortest, bounds->longest) ? 1 : 0;
    }
  }
  return speaking < kWrongBeams + 2 ||
         *std::max_element(agreeing.begin(), agreeing.end()) + kWrongBeams >= speaking;
}

}  // namespace stetro_supervisor
