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

#ifndef STETRO_SUPERVISOR__FLOOR__DRAWN_FLOOR_HPP_
#define STETRO_SUPERVISOR__FLOOR__DRAWN_FLOOR_HPP_

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "stetro_site/distance_field.hpp"
#include "stetro_site/free_space.hpp"
#include "stetro_site/occupancy_grid.hpp"
#include "stetro_site/profile_caster.hpp"
#include "stetro_site/site.hpp"
#include "stetro_supervisor/floor/grid_planner.hpp"

namespace stetro_supervisor
{

/// A floor that somebody has drawn: what a scanner sees of it, and where the robot may drive.
/**
 * The two differ at stairs. A scanner looks over them to the walls behind; the robot keeps off
 * them, whether they go up or down, so to drive every flight that joins the floor is a wall from
 * its first riser to its end, from side to side.
 *
 * Immutable after construction: one instance may be shared between threads.
 */
class DrawnFloor
{
public:
  /**
   * \param resolution_m of cells, where the floor is drawn as polygons
   * \throws std::invalid_argument if nobody has drawn it
   */
  DrawnFloor(const stetro_site::Site & site, const std::string & floor_id, double resolution_m);

  [[nodiscard]] const std::string & id() const noexcept { return floor_.id; }
  [[nodiscard]] const stetro_site::Floor & floor() const noexcept { return floor_; }

  /// The walls as a scanner sees them.
  [[nodiscard]] const stetro_site::ProfileCaster & walls() const noexcept { return *walls_; }
  /// Whether a scanner can stand at a place.
  [[nodiscard]] const stetro_site::FreeSpace & free_space() const noexcept { return *free_space_; }
  /// The same walls as cells.
  [[nodiscard]] const stetro_site::OccupancyGrid & grid() const noexcept { return *grid_; }

  /// The floor without its stairs, from the nearest wall on.
  [[nodiscard]] const std::shared_ptr<const stetro_site::DistanceField> & drivable() const noexcept
  {
    return drivable_;
  }

  /// The same, with walls also at places where something stands that is not drawn.
  [[nodiscard]] std::shared_ptr<const stetro_site::DistanceField> drivable_around(
    const std::vector<Eigen::Vector2d> & obstacles_m) const;

private:
  stetro_site::Floor floor_;
  std::shared_ptr<const stetro_site::OccupancyGrid> grid_;
  std::unique_ptr<const stetro_site::ProfileCaster> walls_;
  std::unique_ptr<const stetro_site::FreeSpace> free_space_;
  std::shared_ptr<const stetro_site::DistanceField> drivable_;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__DRAWN_FLOOR_HPP_
