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

#include "stetro_supervisor/four_beams/heading_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace stetro_supervisor
{

using stetro_site::OccupancyGrid;

namespace
{

void check(const RangeBeam & beam, std::size_t number)
{
  const auto refuse = [&](const char * name, double value, const char * wanted) {
    throw std::invalid_argument(
      "beam " + std::to_string(number) + ": " + name + " = " + std::to_string(value) + ", " +
      wanted + " wanted");
  };
  const auto check_length = [&](const char * name, double value) {
    if (!std::isfinite(value) || value < 0.0) {
      refuse(name, value, "a finite number of 0 or more");
    }
  };
  const RangeError & error = beam.error;
  check_length("short_m", error.short_m);
  check_length("long_m", error.long_m);
  check_length("short_share", error.short_share);
  check_length("long_share", error.long_share);
  check_length("dependable_m", error.dependable_m);
  check_length("too_near_m", error.too_near_m);
  if (error.short_share >= 1.0) {
    refuse("short_share", error.short_share, "less than 1");
  }
  if (!beam.origin_m.allFinite() || !std::isfinite(beam.yaw_rad)) {
    refuse("yaw_rad", beam.yaw_rad, "a finite angle and a finite origin_m");
  }
}

}  // namespace

HeadingSearch::HeadingSearch(
  const OccupancyGrid & grid, std::vector<RangeBeam> beams, double yaw_rad)
: grid_(grid), beams_(std::move(beams)), yaw_rad_(yaw_rad)
{
  const double in_grid_rad = yaw_rad - grid.frame().yaw_rad;
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    check(beams_[i], i);
    const Eigen::Vector2d shift_m =
      Eigen::Rotation2Dd(in_grid_rad).toRotationMatrix() * beams_[i].origin_m;
    tables_.emplace_back(
      grid, in_grid_rad + beams_[i].yaw_rad, Eigen::Vector2d(shift_m / grid.resolution_m()));
  }
}

PlaceAnswer HeadingSearch::find(const std::vector<double> & ranges_m, std::size_t wrong_beams) const
{
  const std::vector<BeamInterval> beams = intervals(ranges_m);
  if (beams.size() <= wrong_beams) {
    return answer({});
  }
  return answer(cells_agreeing(grid_, beams, beams.size() - wrong_beams));
}

PlaceAnswer HeadingSearch::find_best(const std::vector<double> & ranges_m) const
{
  const std::vector<BeamInterval> beams = intervals(ranges_m);
  return answer(beams.empty() ? AgreeingCells{} : best_agreeing(grid_, beams));
}

std::vector<BeamInterval> HeadingSearch::intervals(const std::vector<double> & ranges_m) const
{
  if (ranges_m.size() != beams_.size()) {
    throw std::invalid_argument(
      std::to_string(ranges_m.size()) + " ranges, " + std::to_string(beams_.size()) + " wanted");
  }
  std::vector<BeamInterval> beams;
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    const auto bounds = distance_bounds(ranges_m[i], beams_[i].error, grid_.resolution_m());
    if (bounds) {
      beams.push_back({&tables_[i], bounds->shortest, bounds->longest});
    }
  }
  return beams;
}

PlaceAnswer HeadingSearch::answer(AgreeingCells cells) const
{
  PlaceAnswer answer;
  answer.clusters = clusters(grid_, cells.cells);
  answer.best = clusters(grid_, cells.best());
  answer.area_m2 =
    static_cast<double>(cells.cells.size()) * grid_.resolution_m() * grid_.resolution_m();
  answer.yaw_rad = yaw_rad_;
  answer.cells = std::move(cells);
  return answer;
}

}  // namespace stetro_supervisor
