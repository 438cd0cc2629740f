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

#ifndef STETRO_SUPERVISOR__FLOOR__GRID_PLANNER_HPP_
#define STETRO_SUPERVISOR__FLOOR__GRID_PLANNER_HPP_

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stetro_site/distance_field.hpp"

namespace stetro_supervisor
{

/// Straight legs over a floor.
struct FloorPath
{
  std::vector<Eigen::Vector2d> corners_m;  ///< start, turning points, goal; in the floor's frame
  std::string refusal;                     ///< why there is none, in words; then no corner

  [[nodiscard]] double length_m() const;
};

/// Finds the way of a round body among walls.
/**
 * Lazy Theta* (Nash, Koenig and Tovey, 2010): A* over the cells that leave the clearance, to all
 * eight neighbours, but a cell's parent may be any cell it sees, so the way is of straight legs and
 * not of grid steps. Then its corners are pulled taut, each towards the line between its
 * neighbours as far as the clearance lets it.
 *
 * Between two points that are 2 h apart and leave D each, every point leaves sqrt(D^2 - h^2) at
 * least, for a wall beside the middle is no farther than sqrt(d^2 + h^2) from one of the two. So a
 * leg is tried at points, and still no part of it is nearer to a wall than the clearance; but for
 * the first leg from a start that stands nearer itself: that one leads straight off the wall.
 *
 * Immutable after construction: one instance may be shared between threads.
 */
class GridPlanner
{
public:
  /**
   * \param clearance_m least distance of the body's centre from a wall
   * \throws std::invalid_argument if there is no field, or the clearance is not positive
   */
  GridPlanner(std::shared_ptr<const stetro_site::DistanceField> field, double clearance_m);

  /// The legs from one place to another, or why there are none.
  [[nodiscard]] FloorPath plan(const Eigen::Vector2d & from_m, const Eigen::Vector2d & to_m) const;

  /// Whether a straight leg leaves the clearance everywhere.
  [[nodiscard]] bool is_clear(const Eigen::Vector2d & from_m, const Eigen::Vector2d & to_m) const
  {
    return leaves(clearance_m_, from_m, to_m);
  }

private:
  using Cells = std::vector<stetro_site::CellIndex>;
  class Search;

  [[nodiscard]] bool leaves(
    double clearance_m, const Eigen::Vector2d & from_m, const Eigen::Vector2d & to_m) const;
  [[nodiscard]] bool is_passable(stetro_site::CellIndex cell) const;
  [[nodiscard]] std::optional<stetro_site::CellIndex> cell_near(
    const Eigen::Vector2d & point_m) const;
  void pull_taut(std::vector<Eigen::Vector2d> & corners_m, std::size_t first) const;
  void pull_corner(std::vector<Eigen::Vector2d> & corners_m, std::size_t i) const;

  std::shared_ptr<const stetro_site::DistanceField> field_;
  double clearance_m_;
  double passable_m_;  ///< that both ends of a grid step must leave
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__GRID_PLANNER_HPP_
