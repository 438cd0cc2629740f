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

#ifndef SUPPORT__RANDOM_ROOM_HPP_
#define SUPPORT__RANDOM_ROOM_HPP_

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"

namespace stetro_supervisor
{

/// A grid as it is drawn, the top row first: '.' free, '#' occupied, '?' unknown. Cells of 1 m.
inline stetro_site::OccupancyGrid drawn(const std::vector<std::string> & rows)
{
  stetro_site::GridFrame frame;
  frame.columns = static_cast<int>(rows.front().size());
  frame.rows = static_cast<int>(rows.size());
  frame.resolution_m = 1.0;
  std::vector<stetro_site::Cell> cells;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char mark : *row) {
      cells.push_back(
        mark == '.'   ? stetro_site::Cell::kFree
        : mark == '#' ? stetro_site::Cell::kOccupied
                      : stetro_site::Cell::kUnknown);
    }
  }
  return stetro_site::OccupancyGrid(frame, std::move(cells));
}

/// What a room holds besides its walls.
struct RoomContents
{
  int boxes = 12;           ///< outlines, unknown inside, as a mapping robot sees furniture
  int unknown_patches = 0;  ///< where nobody looked, walls included
  int grain = 1;            ///< cells that positions and sizes are multiples of
  int loose_cells = 0;      ///< single occupied cells: legs of chairs and tables
};

/// A walled room of `columns` x `rows` cells, furnished by chance.
inline stetro_site::OccupancyGrid random_room(
  const stetro_site::GridFrame & frame, const RoomContents & contents, std::mt19937 & random)
{
  using stetro_site::Cell;
  const int columns = frame.columns;
  const int rows = frame.rows;
  std::vector<Cell> cells(static_cast<std::size_t>(columns * rows), Cell::kFree);
  const auto pick = [&](int first, int last) {
    return std::uniform_int_distribution<int>(first, last)(random);
  };
  const auto fill = [&](int left, int low, int right, int high, Cell cell) {
    for (int row = low; row <= high; ++row) {
      for (int column = left; column <= right; ++column) {
        cells[static_cast<std::size_t>(row * columns + column)] = cell;
      }
    }
  };
  const auto patch = [&](Cell edge, Cell inside) {
    const int across = (columns - 2) / contents.grain;
    const int up = (rows - 2) / contents.grain;
    const int width = pick(2, 2 + across / 6) * contents.grain;
    const int height = pick(2, 2 + up / 6) * contents.grain;
    const int left = pick(0, across - width / contents.grain) * contents.grain;
    const int low = pick(0, up - height / contents.grain) * contents.grain;
    fill(left, low, left + width, low + height, edge);
    fill(left + 1, low + 1, left + width - 1, low + height - 1, inside);
  };
  for (int i = 0; i < contents.boxes; ++i) {
    patch(Cell::kOccupied, Cell::kUnknown);
  }
  for (int i = 0; i < contents.loose_cells; ++i) {
    const int column = pick(0, columns - 1);
    const int row = pick(0, rows - 1);
    fill(column, row, column, row, Cell::kOccupied);
  }
  fill(0, 0, columns - 1, 0, Cell::kOccupied);
  fill(0, rows - 1, columns - 1, rows - 1, Cell::kOccupied);
  fill(0, 0, 0, rows - 1, Cell::kOccupied);
  fill(columns - 1, 0, columns - 1, rows - 1, Cell::kOccupied);
  for (int i = 0; i < contents.unknown_patches; ++i) {
    patch(Cell::kUnknown, Cell::kUnknown);
  }
  return stetro_site::OccupancyGrid(frame, std::move(cells));
}

/// The free cells of a grid, row by row.
inline std::vector<stetro_site::CellIndex> free_cells(const stetro_site::OccupancyGrid & grid)
{
  std::vector<stetro_site::CellIndex> cells;
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      if (grid.at({column, row}) == stetro_site::Cell::kFree) {
        cells.push_back({column, row});
      }
    }
  }
  return cells;
}

}  // namespace stetro_supervisor

#endif  // SUPPORT__RANDOM_ROOM_HPP_
