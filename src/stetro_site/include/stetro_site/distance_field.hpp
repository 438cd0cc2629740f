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

#ifndef STETRO_SITE__DISTANCE_FIELD_HPP_
#define STETRO_SITE__DISTANCE_FIELD_HPP_

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"

namespace stetro_site
{

/// How far each cell of a grid is from the nearest wall.
/**
 * A wall is a whole square cell, and the distance goes to its nearest edge or corner. From the
 * centre of a cell (c, w), in cells,
 *
 *   d^2(c, w) = min over walls (c', w') of g(c - c')^2 + g(w - w')^2,
 *   g(u) = max(|u| - 1/2, 0)                                                                 (1)
 *
 * It is exact, and found in time linear in the cells: along columns, then along rows as the lower
 * envelope of parabolas (Meijster, Roerdink and Hesselink, A general algorithm for computing
 * distance transforms in linear time, 2000; Felzenszwalb and Huttenlocher, Distance transforms of
 * sampled functions, 2012). Squares count by their edge lines, which makes (1) the usual form.
 *
 * Immutable after construction: one instance may be shared between threads.
 */
class DistanceField
{
public:
  /// \throws std::invalid_argument if there is no grid
  DistanceField(std::shared_ptr<const OccupancyGrid> grid, Unknown unknown);

  [[nodiscard]] const OccupancyGrid & grid() const noexcept { return *grid_; }
  [[nodiscard]] Unknown unknown() const noexcept { return unknown_; }

  /// Whether a cell is a wall.
  [[nodiscard]] bool is_wall(CellIndex cell) const noexcept;

  /// From a cell's centre, eq. (1) [m]; 0 in a wall, +inf if there is no wall.
  /** The cell must lie in the grid. */
  [[nodiscard]] double distance_m(CellIndex cell) const noexcept
  {
    return distances_m_[grid_->offset(cell)];
  }

  /// From a point of the floor, never more than the true distance [m].
  /**
   * What (1) of the four cells about it leaves, each less the way to its centre: exact at centres,
   * elsewhere short by less than 1.5 cells. Outside the grid 0 if unknown is a wall, else the way
   * to the grid.
   */
  [[nodiscard]] double clearance_m(const Eigen::Vector2d & point_m) const;

private:
  std::shared_ptr<const OccupancyGrid> grid_;
  Unknown unknown_;
  std::vector<float> distances_m_;
};

}  // namespace stetro_site

#endif  // STETRO_SITE__DISTANCE_FIELD_HPP_
