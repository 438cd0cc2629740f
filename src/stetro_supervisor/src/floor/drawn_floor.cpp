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

#include "stetro_supervisor/floor/drawn_floor.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "stetro_site/floor_raster.hpp"
#include "stetro_site/frame_transform.hpp"
#include "stetro_site/grid_caster.hpp"
#include "stetro_site/segment_caster.hpp"
#include "stetro_site/wall_segments.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::Cell;
using stetro_site::DistanceField;
using stetro_site::Flight;
using stetro_site::Floor;
using stetro_site::FrameTransform;
using stetro_site::OccupancyGrid;
using stetro_site::Site;
using stetro_site::Unknown;

std::unique_ptr<const stetro_site::ProfileCaster> caster_of(
  const Floor & floor, const OccupancyGrid & grid)
{
  if (const auto * walls = std::get_if<stetro_site::PolygonWalls>(&floor.drawing)) {
    return std::make_unique<stetro_site::SegmentCaster>(stetro_site::wall_segments(*walls));
  }
  return std::make_unique<stetro_site::GridCaster>(grid, Unknown::kFree);
}

/// Marks the cells that a flight touches, or that come near it by a fraction of a cell.
void wall_off(
  const Flight & flight, const Floor & floor, const OccupancyGrid & grid, std::vector<Cell> & cells)
{
  const FrameTransform T_map_floor{floor.pose_in_map};
  const double half_m = std::sqrt(0.5) * grid.resolution_m();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Eigen::Vector2d centre = grid.centre_m(grid.cell(i));
    const Eigen::Vector3d on_map = T_map_floor.to_map(Eigen::Vector3d{centre.x(), centre.y(), 0.0});
    const Eigen::Vector3d at = flight.T_map_flight().to_frame(on_map);
    const bool along = at.x() > -half_m && at.x() < flight.total_run_m() + half_m;
    const bool across = at.y() > -half_m && at.y() < flight.widest_m() + half_m;
    if (along && across) {
      cells[i] = Cell::kOccupied;
    }
  }
}

OccupancyGrid without_stairs(const Site & site, const Floor & floor, const OccupancyGrid & grid)
{
  std::vector<Cell> cells = grid.cells();
  for (const std::string & id : site.neighbours(floor.id)) {
    wall_off(site.flight(id), floor, grid, cells);
  }
  return OccupancyGrid{grid.frame(), std::move(cells)};
}

std::shared_ptr<const DistanceField> distances_of(OccupancyGrid grid)
{
  return std::make_shared<const DistanceField>(
    std::make_shared<const OccupancyGrid>(std::move(grid)), Unknown::kWall);
}

}  // namespace

DrawnFloor::DrawnFloor(const Site & site, const std::string & floor_id, double resolution_m)
: floor_(site.floor(floor_id)), grid_(stetro_site::grid_of(floor_.drawing, resolution_m))
{
  if (!grid_) {
    throw std::invalid_argument("floor '" + floor_id + "' is not drawn, walls or a map wanted");
  }
  walls_ = caster_of(floor_, *grid_);
  free_space_ = stetro_site::free_space_of(floor_.drawing);
  drivable_ = distances_of(without_stairs(site, floor_, *grid_));
}

std::shared_ptr<const DistanceField> DrawnFloor::drivable_around(
  const std::vector<Eigen::Vector2d> & obstacles_m) const
{
  const OccupancyGrid & grid = drivable_->grid();
  std::vector<Cell> cells = grid.cells();
  for (const Eigen::Vector2d & point_m : obstacles_m) {
    const auto cell = grid.cell_at(point_m);
    if (grid.contains(cell)) {
      cells[grid.offset(cell)] = Cell::kOccupied;
    }
  }
  return distances_of(OccupancyGrid{grid.frame(), std::move(cells)});
}

}  // namespace stetro_supervisor
