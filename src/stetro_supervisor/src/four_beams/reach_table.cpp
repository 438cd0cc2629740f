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
#include <optional>
#include <stdexcept>
#include <string>

namespace stetro_supervisor
{

using stetro_site::Cell;
using stetro_site::CellIndex;
using stetro_site::OccupancyGrid;

namespace
{

constexpr double kPi = 3.14159265358979323846;
constexpr double kAlongAxis = 1e-9;  // headings nearer than this to an axis are that axis [rad]
constexpr double kRounding = 1e-9;   // bounds are widened by what adding up costs [cells]
constexpr int kLongestSide = 16000;  // the diagonal still fits a CellDistance

void check(const OccupancyGrid & grid, double heading_rad)
{
  if (!std::isfinite(heading_rad)) {
    throw std::invalid_argument(
      "beam heading = " + std::to_string(heading_rad) + ", a finite angle wanted");
  }
  if (std::max(grid.columns(), grid.rows()) > kLongestSide) {
    throw std::invalid_argument(
      "grid of " + std::to_string(grid.columns()) + " x " + std::to_string(grid.rows()) +
      " cells, at most " + std::to_string(kLongestSide) + " a side wanted");
  }
}

/// The step along a row or column, if that is where the heading points.
std::optional<CellIndex> axis_step(double heading_rad)
{
  const double quarters = heading_rad / (kPi / 2.0);
  const double whole = std::round(quarters);
  if (std::abs(quarters - whole) * (kPi / 2.0) > kAlongAxis) {
    return std::nullopt;
  }
  constexpr CellIndex kSteps[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  return kSteps[static_cast<int>(std::fmod(whole, 4.0) + 4.0) % 4];
}

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

/// A cell that beams in one heading may touch, as seen from the cell where they start.
struct StripCell
{
  int columns = 0;
  int rows = 0;
  double along = 0.0;   // of its centre, along the beam
  double across = 0.0;  // of its centre, to the left of the beam
};

/// The strip of the beams in one heading from all over a cell.
/**
 * With the heading's c = |cos| and s = |sin|, a cell reaches w = (c + s) / 2 from its centre, both
 * along and across the beam; the side that faces the sensor ends at most m = |c - s| / 2 behind the
 * centre. So a beam to an obstacle at t along has t - 2w <= L <= t + m + w.
 */
class Strip
{
public:
  Strip(double heading_rad, int longest_columns, int longest_rows)
  : cos_(std::cos(heading_rad)), sin_(std::sin(heading_rad))
  {
    const int column_step = cos_ > 0.0 ? 1 : -1;
    const int row_step = sin_ > 0.0 ? 1 : -1;
    for (int columns = 0; columns < longest_columns; ++columns) {
      // Rows for which |across| < 2w.
      const double middle = columns * std::abs(sin_ / cos_);
      const double margin = 2.0 * half_width() / std::abs(cos_);
      const double last = std::min(middle + margin, longest_rows - 1.0);
      if (middle - margin > last) {
        break;
      }
      const auto first = static_cast<int>(std::max(0.0, std::floor(middle - margin)));
      for (int rows = first; rows <= last; ++rows) {
        add({columns * column_step, rows * row_step, 0.0, 0.0});
      }
    }
    std::sort(cells_.begin(), cells_.end(), [](const StripCell & a, const StripCell & b) {
      return a.along < b.along;
    });
  }

  [[nodiscard]] Reach reach(const OccupancyGrid & grid, CellIndex from) const
  {
    Reach reach{kNoReturn, kNoReturn};
    double open_left = half_width();
    double open_right = -half_width();
    const double beyond_grid = leaves(grid, from);
    for (const StripCell & cell : cells_) {
      if (cell.along > beyond_grid && reach.first != kNoReturn) {
        break;
      }
      const Cell met = grid.at({from.column + cell.columns, from.row + cell.rows});
      if (met == Cell::kFree) {
        continue;
      }
      if (reach.first == kNoReturn) {
        reach.first = first(cell);
      }
      if (met == Cell::kUnknown) {
        continue;
      }
      if (cell.across >= 0.0) {
        open_left = std::min(open_left, cell.across - half_width());
      }
      if (cell.across <= 0.0) {
        open_right = std::max(open_right, cell.across + half_width());
      }
      if (open_left <= open_right) {
        reach.last = last(cell);
        break;
      }
    }
    return reach;
  }

private:
  [[nodiscard]] double half_width() const { return (std::abs(cos_) + std::abs(sin_)) / 2.0; }

  /// From where on along the beam all cells of the strip lie outside the grid.
  /** Its cells have columns along |cos| - across |sin|, likewise rows, and |across| < 2w. */
  [[nodiscard]] double leaves(const OccupancyGrid & grid, CellIndex from) const
  {
    const double c = std::abs(cos_);
    const double s = std::abs(sin_);
    const double columns = cos_ > 0.0 ? grid.columns() - from.column : from.column + 1.0;
    const double rows = sin_ > 0.0 ? grid.rows() - from.row : from.row + 1.0;
    const double width = 2.0 * half_width();
    return std::min((columns + width * s) / c, (rows + width * c) / s);
  }

  void add(StripCell cell)
  {
    cell.along = cell.columns * cos_ + cell.rows * sin_;
    cell.across = -cell.columns * sin_ + cell.rows * cos_;
    const bool is_start = cell.columns == 0 && cell.rows == 0;
    if (!is_start && std::abs(cell.across) < 2.0 * half_width()) {
      cells_.push_back(cell);
    }
  }

  [[nodiscard]] CellDistance first(const StripCell & cell) const
  {
    const double shortest = std::floor(cell.along - 2.0 * half_width() - kRounding);
    return static_cast<CellDistance>(std::max(1.0, shortest + 1.0));
  }

  [[nodiscard]] CellDistance last(const StripCell & cell) const
  {
    const double behind = std::abs(std::abs(cos_) - std::abs(sin_)) / 2.0;
    return static_cast<CellDistance>(std::ceil(cell.along + behind + half_width() + kRounding));
  }

  double cos_;
  double sin_;
  std::vector<StripCell> cells_;  // by their distance along the beam
};

/// The hull of what beams from parts of several cells may do.
void widen(Reach & reach, const Reach & other)
{
  reach.first = std::min(reach.first, other.first);
  reach.last = std::max(reach.last, other.last);
}

}  // namespace

ReachTable::ReachTable(const OccupancyGrid & grid, double heading_rad) : cells_(grid.cells().size())
{
  check(grid, heading_rad);
  const std::size_t padded = (cells_ + kStretch - 1) / kStretch * kStretch;
  first_.assign(padded, Reach{}.first);
  last_.assign(padded, Reach{}.last);
  if (const auto step = axis_step(heading_rad)) {
    sweep(grid, *step);
  } else {
    walk(grid, heading_rad);
  }
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

void ReachTable::walk(const OccupancyGrid & grid, double heading_rad)
{
  // One column and row beyond the grid, where a beam meets the unknown.
  const Strip strip(heading_rad, grid.columns() + 1, grid.rows() + 1);
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const CellIndex cell{column, row};
      const std::size_t offset = grid.offset(cell);
      if (grid.cells()[offset] == Cell::kFree) {
        const Reach reach = strip.reach(grid, cell);
        first_[offset] = reach.first;
        last_[offset] = reach.last;
      }
    }
  }
}

ReachTable::ReachTable(
  const OccupancyGrid & grid, double heading_rad, const Eigen::Vector2d & shift_cells)
: ReachTable(grid, heading_rad)
{
  if (!shift_cells.allFinite() || shift_cells.cwiseAbs().maxCoeff() > kLongestSide) {
    throw std::invalid_argument("beam origin: finite lengths within the grid wanted");
  }
  const Eigen::Vector2d whole = shift_cells.array().floor();
  const int columns = static_cast<int>(whole.x());
  const int rows = static_cast<int>(whole.y());
  const int right = shift_cells.x() > whole.x() ? 1 : 0;
  const int up = shift_cells.y() > whole.y() ? 1 : 0;
  if (columns == 0 && rows == 0 && right == 0 && up == 0) {
    return;
  }
  const ReachTable unshifted(*this);
  const auto reach_from = [&](CellIndex start) {
    switch (grid.at(start)) {
      case Cell::kFree:
        return unshifted.at(grid.offset(start));
      case Cell::kOccupied:
        return Reach{};  // no sensor is in a wall
      default:
        return Reach{1, kNoReturn};  // anything may be near, or nothing
    }
  };
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const CellIndex start{column + columns, row + rows};
      Reach reach = reach_from(start);
      widen(reach, reach_from({start.column + right, start.row}));
      widen(reach, reach_from({start.column, start.row + up}));
      widen(reach, reach_from({start.column + right, start.row + up}));
      const std::size_t offset = grid.offset({column, row});
      const bool free = grid.cells()[offset] == Cell::kFree;
      first_[offset] = free ? reach.first : Reach{}.first;
      last_[offset] = free ? reach.last : Reach{}.last;
    }
  }
}

}  // namespace stetro_supervisor
