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

#ifndef STETRO_SITE__FLOOR_RASTER_HPP_
#define STETRO_SITE__FLOOR_RASTER_HPP_

#include <memory>
#include <vector>

#include "stetro_site/floor.hpp"
#include "stetro_site/occupancy_grid.hpp"
#include "stetro_site/profile_caster.hpp"

namespace stetro_site
{

/// The cells of a grid that a wall touches, row by row; one that runs along an edge touches both.
[[nodiscard]] std::vector<CellIndex> touched_cells(
  const OccupancyGrid & grid, const Segment & wall);

/// Draws polygon walls as a grid along the floor's axes, with corners at whole multiples of a cell.
/**
 * Conservative: a cell that a wall touches is occupied, and so is all of an obstacle; a cell is
 * free only if all of it is. Outside the outline nothing is known.
 *
 * \throws std::invalid_argument if the resolution is not positive, or a grid of it too large
 */
[[nodiscard]] OccupancyGrid rasterise(const PolygonWalls & walls, double resolution_m);

/// A floor as a grid: its map, or its walls drawn at a resolution; null if nobody has drawn it.
/** \throws std::invalid_argument as `rasterise`; a map keeps its own resolution */
[[nodiscard]] std::shared_ptr<const OccupancyGrid> grid_of(
  const FloorDrawing & drawing, double resolution_m);

}  // namespace stetro_site

#endif  // STETRO_SITE__FLOOR_RASTER_HPP_
