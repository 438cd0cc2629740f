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

#ifndef STETRO_SUPERVISOR__FOUR_BEAMS__HEADING_SEARCH_HPP_
#define STETRO_SUPERVISOR__FOUR_BEAMS__HEADING_SEARCH_HPP_

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"
#include "stetro_supervisor/four_beams/beam_search.hpp"
#include "stetro_supervisor/four_beams/cell_cluster.hpp"
#include "stetro_supervisor/four_beams/range_error.hpp"
#include "stetro_supervisor/four_beams/reach_table.hpp"

namespace stetro_supervisor
{

/// A range sensor as it is mounted on the robot.
struct RangeBeam
{
  Eigen::Vector2d origin_m{0.0, 0.0};  ///< where its beam starts, in base_link [m]
  double yaw_rad = 0.0;                ///< where it points, in base_link, CCW
  RangeError error;
};

/// Where the robot may be.
struct PlaceAnswer
{
  AgreeingCells cells;                ///< of its base_link
  std::vector<CellCluster> clusters;  ///< of all those cells, the largest first
  std::vector<CellCluster> best;      ///< of those that most beams support, the largest first
  double area_m2 = 0.0;               ///< of all those cells
  double yaw_rad = 0.0;               ///< the heading that was believed, in the floor's frame
};

/// Finds a robot of one heading on a floor by the ranges it reads, all of which may err.
/**
 * Ranges agree with reaches as in (2) of `distance_bounds`.
 *
 * So wherever the robot stands in a cell, that cell is in the answer if enough ranges are within
 * their bounds and the map is right where it is not unknown. The heading is taken as it is said: a
 * heading that is not known is searched for with one `HeadingSearch` each.
 *
 * Immutable after construction: one instance may be shared between threads. `grid` must outlive it.
 */
class HeadingSearch
{
public:
  /**
   * \param yaw_rad of base_link in the floor's frame, CCW
   * \throws std::invalid_argument naming the beam and what is wrong with it
   */
  HeadingSearch(
    const stetro_site::OccupancyGrid & grid, std::vector<RangeBeam> beams, double yaw_rad);

  /// All places that agree with all but `wrong_beams` of the ranges, or fewer.
  /**
   * \param ranges_m one a beam, as REP 117: +inf nothing in range, -inf too near, NaN says nothing
   *   and is left out
   * \return no place if no range says anything, or as many as say something may be wrong
   */
  [[nodiscard]] PlaceAnswer find(
    const std::vector<double> & ranges_m, std::size_t wrong_beams = 0) const;

  /// The places that most ranges agree with (D4-12); `cells.least_agreeing` tells how many.
  [[nodiscard]] PlaceAnswer find_best(const std::vector<double> & ranges_m) const;

private:
  [[nodiscard]] std::vector<BeamInterval> intervals(const std::vector<double> & ranges_m) const;
  [[nodiscard]] PlaceAnswer answer(AgreeingCells cells) const;

  const stetro_site::OccupancyGrid & grid_;
  std::vector<RangeBeam> beams_;
  double yaw_rad_;
  std::vector<ReachTable> tables_;  // of each beam
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FOUR_BEAMS__HEADING_SEARCH_HPP_
