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

#include "profiles/roughened.hpp"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace stetro_bringup
{
namespace
{

using stetro_site::Cell;
using stetro_site::CellIndex;
using stetro_site::OccupancyGrid;

constexpr std::array<CellIndex, 4> kSides{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

CellIndex beside(CellIndex cell, CellIndex side)
{
  return {cell.column + side.column, cell.row + side.row};
}

bool is_beside_a_wall(const OccupancyGrid & grid, CellIndex cell)
{
  for (const CellIndex side : kSides) {
    if (grid.at(beside(cell, side)) == Cell::kOccupied) {
      return true;
    }
  }
  return false;
}

/// Free on one side, and wall on the other.
bool is_a_face(const OccupancyGrid & grid, CellIndex cell)
{
  for (const CellIndex side : kSides) {
    const CellIndex behind{-side.column, -side.row};
    if (
      grid.at(beside(cell, side)) == Cell::kFree &&
      grid.at(beside(cell, behind)) == Cell::kOccupied) {
      return true;
    }
  }
  return false;
}

}  // namespace

OccupancyGrid roughened(const OccupancyGrid & grid, double share, std::mt19937_64 & random)
{
  std::bernoulli_distribution changes(share);
  std::vector<Cell> cells = grid.cells();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CellIndex at = grid.cell(i);
    if (grid.cells()[i] == Cell::kFree && is_beside_a_wall(grid, at) && changes(random)) {
      cells[i] = Cell::kOccupied;
    } else if (grid.cells()[i] == Cell::kOccupied && is_a_face(grid, at) && changes(random)) {
      cells[i] = Cell::kFree;
    }
  }
  return OccupancyGrid{grid.frame(), std::move(cells)};
}

}  // namespace stetro_bringup
