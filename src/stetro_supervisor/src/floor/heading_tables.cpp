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

#include "stetro_supervisor/floor/heading_tables.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_supervisor
{
namespace
{

constexpr double kTurn_rad = 6.283185307179586;

}  // namespace

HeadingTables::HeadingTables(const stetro_site::OccupancyGrid & grid, double step_rad) : grid_(grid)
{
  const double between = kTurn_rad / kScanBeams / step_rad;
  tables_.resize(kScanBeams * static_cast<std::size_t>(std::max(1.0, std::ceil(between))));
}

double HeadingTables::heading_rad(std::size_t heading) const
{
  return kTurn_rad * static_cast<double>(heading) / static_cast<double>(tables_.size());
}

std::size_t HeadingTables::direction(std::size_t heading, std::size_t beam) const
{
  return (heading + beam * (tables_.size() / kScanBeams)) % tables_.size();
}

std::size_t HeadingTables::missing(std::size_t heading) const
{
  std::size_t count = 0;
  for (std::size_t beam = 0; beam < kScanBeams; ++beam) {
    count += tables_[direction(heading, beam)] ? 0 : 1;
  }
  return count;
}

AgreeingCells HeadingTables::find(const ScanBeams & beams, std::size_t heading)
{
  std::vector<BeamInterval> asked;
  for (std::size_t beam = 0; beam < kScanBeams; ++beam) {
    const std::size_t towards = direction(heading, beam);
    if (!tables_[towards]) {
      tables_[towards].emplace(
        grid_, heading_rad(towards) - grid_.frame().yaw_rad, Eigen::Vector2d(0.0, 0.0));
    }
    const auto bounds =
      distance_bounds(beams.ranges_m[beam], beams.beams[beam].error, grid_.resolution_m());
    if (bounds) {
      asked.push_back({&*tables_[towards], bounds->shortest, bounds->longest});
    }
  }
  return asked.size() <= kWrongBeams ? AgreeingCells{}
                                     : cells_agreeing(grid_, asked, asked.size() - kWrongBeams);
}

}  // namespace stetro_supervisor
