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

#include "stetro_site/floor_raster.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "stetro_site/wall_segments.hpp"

namespace stetro_site
{
namespace
{

constexpr double kRounding = 1e-6;  // [cells] a wall this near to an edge runs along it
constexpr double kMostCells = 1U << 26U;

/// First and last cell that the closed interval [low, high] touches, of `count` cells.
std::pair<int, int> touched(double low, double high, int count)
{
  const double last = count - 1.0;
  return {
    static_cast<int>(std::clamp(std::ceil(low - kRounding) - 1.0, 0.0, last + 1.0)),
    static_cast<int>(std::clamp(std::floor(high + kRounding), -1.0, last))};
}

/// A frame of square cells that covers the outline and the cells that its walls touch.
GridFrame frame_around(const Polygon & outline, double resolution_m)
{
  if (outline.empty() || !std::isfinite(resolution_m) || resolution_m <= 0.0) {
    throw std::invalid_argument(
      "rasterise: resolution_m = " + std::to_string(resolution_m) +
      ", a positive length and an outline wanted");
  }
  Eigen::Array2d low = outline.front().array();
  Eigen::Array2d high = low;
  for (const Eigen::Vector2d & corner : outline) {
    low = low.min(corner.array());
    high = high.max(corner.array());
  }
  const Eigen::Array2d first = (low / resolution_m - kRounding).ceil() - 1.0;
  const Eigen::Array2d size = (high / resolution_m + kRounding).floor() + 1.0 - first;
  if (!(size.x() * size.y() <= kMostCells)) {
    throw std::invalid_argument(
      "rasterise: resolution_m = " + std::to_string(resolution_m) + " makes more than " +
      std::to_string(static_cast<int>(kMostCells)) + " cells, a coarser one wanted");
  }
  GridFrame frame;
  frame.columns = static_cast<int>(size.x());
  frame.rows = static_cast<int>(size.y());
  frame.resolution_m = resolution_m;
  frame.origin_m = resolution_m * first.matrix();
  return frame;
}

/// What a cell is that no wall touches: its centre tells for all of it.
Cell untouched(const PolygonWalls & walls, const Eigen::Vector2d & centre_m)
{
  if (!encloses(walls.outline, centre_m)) {
    return Cell::kUnknown;
  }
  const bool is_in_obstacle = std::any_of(
    walls.obstacles.begin(), walls.obstacles.end(),
    [&](const Polygon & obstacle) { return encloses(obstacle, centre_m); });
  return is_in_obstacle ? Cell::kOccupied : Cell::kFree;
}

}  // namespace

std::vector<CellIndex> touched_cells(const OccupancyGrid & grid, const Segment & wall)
{
  std::vector<CellIndex> cells;
  Eigen::Vector2d from = grid.to_cells(wall.from_m);
  Eigen::Vector2d to = grid.to_cells(wall.to_m);
  if (from.y() > to.y()) {
    std::swap(from, to);
  }
  const Eigen::Vector2d along = to - from;
  const auto [first_row, last_row] = touched(from.y(), to.y(), grid.rows());
  for (int row = first_row; row <= last_row; ++row) {
    // The piece of the wall within the row, widened as the row itself was when it was chosen.
    const auto x_at = [&](double y) {
      const double share = along.y() > 0.0 ? std::clamp((y - from.y()) / along.y(), 0.0, 1.0) : 0.0;
      return from.x() + share * along.x();
    };
    const double enter = x_at(row - kRounding);
    const double leave = along.y() > 0.0 ? x_at(row + 1.0 + kRounding) : to.x();
    const auto [first, last] =
      touched(std::min(enter, leave), std::max(enter, leave), grid.columns());
    for (int column = first; column <= last; ++column) {
      cells.push_back({column, row});
    }
  }
  return cells;
}

OccupancyGrid rasterise(const PolygonWalls & walls, double resolution_m)
{
  const GridFrame frame = frame_around(walls.outline, resolution_m);
  const auto count = static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
  const OccupancyGrid blank{frame, std::vector<Cell>(count, Cell::kUnknown)};
  std::vector<Cell> cells = blank.cells();
  for (const Segment & wall : wall_segments(walls)) {
    for (const CellIndex cell : touched_cells(blank, wall)) {
      cells[blank.offset(cell)] = Cell::kOccupied;
    }
  }
  std::vector<Cell> filled = cells;
  for (int row = 0; row < frame.rows; ++row) {
    bool is_after_wall = true;  // else the cell is what the one before it is
    for (int column = 0; column < frame.columns; ++column) {
      const std::size_t i = blank.offset({column, row});
      if (cells[i] != Cell::kOccupied) {
        filled[i] = is_after_wall ? untouched(walls, blank.centre_m({column, row})) : filled[i - 1];
      }
      is_after_wall = cells[i] == Cell::kOccupied;
    }
  }
  return OccupancyGrid{frame, std::move(filled)};
}

std::shared_ptr<const OccupancyGrid> grid_of(const FloorDrawing & drawing, double resolution_m)
{
  if (const auto * walls = std::get_if<PolygonWalls>(&drawing)) {
    return std::make_shared<const OccupancyGrid>(rasterise(*walls, resolution_m));
  }
  if (const auto * map = std::get_if<GridMapFile>(&drawing)) {
    return map->grid;
  }
  return nullptr;
}

}  // namespace stetro_site
