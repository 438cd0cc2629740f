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

#include "stetro_site/free_space.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "stetro_site/wall_segments.hpp"

namespace stetro_site
{

PolygonFreeSpace::PolygonFreeSpace(PolygonWalls walls)
: walls_(std::move(walls)), segments_(wall_segments(walls_))
{
}

bool PolygonFreeSpace::is_free(const Eigen::Vector2d & point_m) const
{
  const auto is_around = [&](const Polygon & polygon) { return encloses(polygon, point_m); };
  return is_around(walls_.outline) &&
         std::none_of(walls_.obstacles.begin(), walls_.obstacles.end(), is_around) &&
         distance_m(segments_, point_m) > 0.0;
}

double PolygonFreeSpace::clearance_m(const Eigen::Vector2d & point_m) const
{
  return is_free(point_m) ? distance_m(segments_, point_m) : 0.0;
}

GridFreeSpace::GridFreeSpace(std::shared_ptr<const OccupancyGrid> grid, Unknown unknown)
: distances_(std::move(grid), unknown)
{
}

bool GridFreeSpace::is_free(const Eigen::Vector2d & point_m) const
{
  const OccupancyGrid & grid = distances_.grid();
  const Eigen::Array2d at = grid.to_cells(point_m).array();
  const Eigen::Array2d size(grid.columns(), grid.rows());
  return (at >= 0.0).all() && (at < size).all() && !distances_.is_wall(grid.cell_at(point_m));
}

double GridFreeSpace::clearance_m(const Eigen::Vector2d & point_m) const
{
  return distances_.clearance_m(point_m);
}

std::unique_ptr<FreeSpace> free_space_of(const FloorDrawing & drawing)
{
  if (const auto * walls = std::get_if<PolygonWalls>(&drawing)) {
    return std::make_unique<PolygonFreeSpace>(*walls);
  }
  if (const auto * map = std::get_if<GridMapFile>(&drawing)) {
    return std::make_unique<GridFreeSpace>(map->grid);
  }
  return nullptr;
}

}  // namespace stetro_site
