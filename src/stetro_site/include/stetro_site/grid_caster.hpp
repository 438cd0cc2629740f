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

#ifndef STETRO_SITE__GRID_CASTER_HPP_
#define STETRO_SITE__GRID_CASTER_HPP_

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"
#include "stetro_site/profile_caster.hpp"

namespace stetro_site
{

class WallTree;

/// Casts profiles on a grid map, exactly: a beam stops at the border of the first cell that stops.
/**
 * An occupied cell stops beams, an unknown one if it is taken for a wall. The cells that stop
 * belong together with their borders: a beam that touches the corner of one, within 1e-12 rad,
 * stops there, and none passes between two that share but a corner. A scanner stands in the cell
 * `cell_at` names, and at least 1e-11 cells inside it; in a cell that stops it reads 0 in every
 * direction.
 *
 * The borders between cells that stop and cells that do not, joined to the longest straight pieces,
 * are cast as segments that are seen from the free side: real maps have far fewer of them than
 * cells.
 */
class GridCaster : public ProfileCaster
{
public:
  GridCaster(OccupancyGrid grid, Unknown unknown);

  /// See `ProfileCaster::cast`. The fan may be more than a turn, of any step, either way round.
  /** Place, fan or reach that are not numbers read NaN; without a positive reach nothing is met. */
  void cast(
    const Eigen::Vector2d & from_m, const BeamFan & fan, double reach_m,
    std::vector<double> & ranges_m) const override;

private:
  [[nodiscard]] bool stops_at(const Eigen::Vector2d & in_cells) const;

  OccupancyGrid grid_;
  Unknown unknown_;
  std::shared_ptr<const WallTree> borders_;  ///< in cells
};

}  // namespace stetro_site

#endif  // STETRO_SITE__GRID_CASTER_HPP_
