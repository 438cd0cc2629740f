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

#include "stetro_site/grid_caster.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cast_walls.hpp"
#include "cell_borders.hpp"
#include "wall_tree.hpp"

namespace stetro_site
{

namespace
{

/// Off the borders of its cell, as on one it would stand on a wall.
double inside_cell(double at)
{
  constexpr double kMargin = 1.5e-11;
  const double cell = std::floor(at);
  return cell + std::clamp(at - cell, kMargin, 1.0 - kMargin);
}

}  // namespace

GridCaster::GridCaster(OccupancyGrid grid, Unknown unknown)
: grid_(std::move(grid)),
  unknown_(unknown),
  borders_(std::make_shared<const WallTree>(cell_borders(grid_, unknown), WallSides::kLeft))
{
}

bool GridCaster::stops_at(const Eigen::Vector2d & in_cells) const
{
  // A place far outside has a cell whose number is none.
  const bool inside =
    in_cells.minCoeff() >= 0.0 && in_cells.x() < grid_.columns() && in_cells.y() < grid_.rows();
  const auto index = [](double at) { return static_cast<int>(at); };
  return is_wall(
    inside ? grid_.at({index(in_cells.x()), index(in_cells.y())}) : Cell::kUnknown, unknown_);
}

void GridCaster::cast(
  const Eigen::Vector2d & from_m, const BeamFan & fan, double reach_m,
  std::vector<double> & ranges_m) const
{
  const Eigen::Vector2d at = grid_.to_cells(from_m);
  const double resolution_m = grid_.resolution_m();
  const BeamFan in_grid{fan.first_rad - grid_.frame().yaw_rad, fan.step_rad, fan.count};
  const Scanner scanner{
    {inside_cell(at.x()), inside_cell(at.y())}, in_grid, reach_m / resolution_m, resolution_m};
  if (is_number(scanner) && reach_m > 0.0 && stops_at(at)) {
    ranges_m.assign(fan.count, 0.0);
    return;
  }
  cast_walls(*borders_, scanner, best_instructions(), ranges_m);
}

}  // namespace stetro_site
