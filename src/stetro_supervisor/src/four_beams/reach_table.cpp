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

#include "stetro_supervisor/four_beams/reach_table.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_supervisor
{

using stetro_site::Cell;
using stetro_site::CellIndex;
using stetro_site::OccupancyGrid;

namespace
{

/// What lies ahead of a cell on its row or column, seen from the next cell.
struct Ahead
{
  CellDistance unknown = 1;  // the first unknown cell; here: the grid's edge is next
  CellDistance wall = kNoReturn;

  void pass(Cell cell)
  {
    unknown = cell == Cell::kUnknown ? CellDistance{1} : farther(unknown);
    wall = cell == Cell::kOccupied ? CellDistance{1} : farther(wall);
  }

  static CellDistance farther(CellDistance distance)
  {
    return distance == kNoReturn ? kNoReturn : static_cast<CellDistance>(distance + 1);
  }
};

}  // namespace

ReachTable::ReachTable(std::size_t cells) : cells_(cells)
{
  const std::size_t padded = (cells_ + kStretch - 1) / kStretch * kStretch;
  first_.assign(padded, Reach{}.first);
  last_.assign(padded, Reach{}.last);
}

ReachTable::ReachTable(const OccupancyGrid & grid, double heading_rad) : cells_(0)
{
  ReachTableBuilder builder(grid, heading_rad);
  while (!builder.is_done()) {
    builder.work(grid.cells().size());
  }
  *this = builder.take();
}

void ReachTable::sweep(const OccupancyGrid & grid, CellIndex step)
{
  const bool along_rows = step.column != 0;
  const bool forwards = step.column + step.row > 0;
  const int lines = along_rows ? grid.rows() : grid.columns();
  const int length = along_rows ? grid.columns() : grid.rows();
  for (int line = 0; line < lines; ++line) {
    Ahead ahead;
    for (int i = 0; i < length; ++i) {
      const int here = forwards ? length - 1 - i : i;  // from the far end to the sensor
      const std::size_t offset =
        grid.offset(along_rows ? CellIndex{here, line} : CellIndex{line, here});
      const Cell cell = grid.cells()[offset];
      if (cell == Cell::kFree) {
        first_[offset] = std::min(ahead.unknown, ahead.wall);
        last_[offset] = ahead.wall;
      }
      ahead.pass(cell);
    }
  }
}

ReachTable::ReachTable(
  const OccupancyGrid & grid, double heading_rad, const Eigen::Vector2d & shift_cells)
: ReachTable(grid, heading_rad)
{
  const ShiftedStart shifted(shift_cells);
  if (shifted.is_none()) {
    return;
  }
  const ReachTable unshifted(*this);
  for (std::size_t offset = 0; offset < cells_; ++offset) {
    Reach reach;
    if (grid.cells()[offset] == Cell::kFree) {
      reach = shifted.reach(
        grid, grid.cell(offset), [&](CellIndex start) { return unshifted.at(grid.offset(start)); });
    }
    first_[offset] = reach.first;
    last_[offset] = reach.last;
  }
}

ReachTableBuilder::ReachTableBuilder(const OccupancyGrid & grid, double heading_rad)
: grid_(grid), reach_(grid, heading_rad), table_(grid.cells().size())
{
}

/// A row or column is swept in one pass, at the price of a look at each cell.
std::size_t ReachTableBuilder::work(std::size_t cells)
{
  if (reach_.step() && !is_done()) {
    table_.sweep(grid_, *reach_.step());
    next_ = table_.cells_;
    return table_.cells_;
  }
  const auto diagonal = static_cast<std::size_t>(std::hypot(grid_.columns(), grid_.rows()));
  std::size_t passed = 0;
  for (; passed < cells && !is_done(); ++next_) {
    const Reach here = reach_.from(grid_.cell(next_));
    table_.first_[next_] = here.first;
    table_.last_[next_] = here.last;
    passed += 1 + (here.last > 0 ? std::min<std::size_t>(here.last, diagonal) : 0);
  }
  return passed;
}

}  // namespace stetro_supervisor
