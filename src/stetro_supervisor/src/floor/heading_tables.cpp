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
#include <stdexcept>
#include <string>

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

bool HeadingTables::is_built(std::size_t heading) const
{
  for (std::size_t beam = 0; beam < kScanBeams; ++beam) {
    if (!tables_[direction(heading, beam)]) {
      return false;
    }
  }
  return true;
}

std::size_t HeadingTables::build(std::size_t heading, std::size_t cells)
{
  std::size_t passed = 0;
  for (std::size_t beam = 0; beam < kScanBeams && passed < cells; ++beam) {
    const std::size_t towards = direction(heading, beam);
    if (tables_[towards]) {
      continue;
    }
    if (!building_ || built_direction_ != towards) {
      building_.emplace(grid_, heading_rad(towards) - grid_.frame().yaw_rad);
      built_direction_ = towards;
    }
    passed += building_->work(cells - passed);
    if (building_->is_done()) {
      tables_[towards] = building_->take();
      building_.reset();
    }
  }
  return passed;
}

AgreeingCells HeadingTables::find(const ScanBeams & beams, std::size_t heading) const
{
  if (!is_built(heading)) {
    throw std::logic_error("heading " + std::to_string(heading) + " has not been built");
  }
  std::vector<BeamInterval> asked;
  for (std::size_t beam = 0; beam < kScanBeams; ++beam) {
    const auto & table = tables_[direction(heading, beam)];
    const auto bounds =
      distance_bounds(beams.ranges_m[beam], beams.beams[beam].error, grid_.resolution_m());
    if (bounds) {
      asked.push_back({&*table, bounds->shortest, bounds->longest});
    }
  }
  return asked.size() <= kWrongBeams ? AgreeingCells{}
                                     : cells_agreeing(grid_, asked, asked.size() - kWrongBeams);
}

}  // namespace stetro_supervisor
