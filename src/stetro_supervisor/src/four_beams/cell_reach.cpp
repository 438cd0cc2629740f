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

#include "stetro_supervisor/four_beams/cell_reach.hpp"

#include <algorithm>
#include <cmath>
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

}  // namespace

ShiftedStart::ShiftedStart(const Eigen::Vector2d & shift_cells)
{
  if (!shift_cells.allFinite() || shift_cells.cwiseAbs().maxCoeff() > kLongestSide) {
    throw std::invalid_argument("beam origin: finite lengths within the grid wanted");
  }
  const Eigen::Vector2d whole = shift_cells.array().floor();
  columns_ = static_cast<int>(whole.x());
  rows_ = static_cast<int>(whole.y());
  right_ = shift_cells.x() > whole.x() ? 1 : 0;
  up_ = shift_cells.y() > whole.y() ? 1 : 0;
}

CellReach::CellReach(
  const OccupancyGrid & grid, double heading_rad, const Eigen::Vector2d & shift_cells)
: grid_(grid), start_(shift_cells), cos_(std::cos(heading_rad)), sin_(std::sin(heading_rad))
{
  check(grid, heading_rad);
  step_ = axis_step(heading_rad);
  if (!step_) {
    lay_strip();
  }
}

Reach CellReach::from(CellIndex cell) const
{
  if (grid_.at(cell) != Cell::kFree) {
    return {};
  }
  const auto unshifted = [this](CellIndex at) { return step_ ? along_axis(at) : across_strip(at); };
  return start_.is_none() ? unshifted(cell) : start_.reach(grid_, cell, unshifted);
}

Reach CellReach::along_axis(CellIndex from) const
{
  Reach reach{kNoReturn, kNoReturn};
  for (int distance = 1; reach.last == kNoReturn; ++distance) {
    const CellIndex at{from.column + distance * step_->column, from.row + distance * step_->row};
    const Cell met = grid_.at(at);
    const auto here = static_cast<CellDistance>(distance);
    reach.first = met != Cell::kFree ? std::min(reach.first, here) : reach.first;
    reach.last = met == Cell::kOccupied ? here : reach.last;
    if (!grid_.contains(at)) {
      break;
    }
  }
  return reach;
}

/// Lays out the strip of the beams from all over a cell.
/**
 * With the heading's c = |cos| and s = |sin|, a cell reaches w = (c + s) / 2 from its centre, both
 * along and across the beam; the side that faces the sensor ends at most m = |c - s| / 2 behind the
 * centre. So a beam to an obstacle at t along has t - 2w <= L <= t + m + w. One column and row
 * beyond the grid belong to it, where a beam meets the unknown.
 */
void CellReach::lay_strip()
{
  const int column_step = cos_ > 0.0 ? 1 : -1;
  const int row_step = sin_ > 0.0 ? 1 : -1;
  for (int columns = 0; columns <= grid_.columns(); ++columns) {
    // Rows for which |across| < 2w.
    const double middle = columns * std::abs(sin_ / cos_);
    const double margin = 2.0 * half_width() / std::abs(cos_);
    const double last = std::min(middle + margin, static_cast<double>(grid_.rows()));
    if (middle - margin > last) {
      break;
    }
    const auto first = static_cast<int>(std::max(0.0, std::floor(middle - margin)));
    for (int rows = first; rows <= last; ++rows) {
      add({columns * column_step, rows * row_step, 0.0, 0.0});
    }
  }
  std::sort(strip_.begin(), strip_.end(), [](const StripCell & a, const StripCell & b) {
    return a.along < b.along;
  });
}

Reach CellReach::across_strip(CellIndex from) const
{
  Reach reach{kNoReturn, kNoReturn};
  double open_left = half_width();
  double open_right = -half_width();
  const double beyond_grid = leaves(from);
  for (const StripCell & cell : strip_) {
    if (cell.along > beyond_grid && reach.first != kNoReturn) {
      break;
    }
    const Cell met = grid_.at({from.column + cell.columns, from.row + cell.rows});
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

double CellReach::half_width() const { return (std::abs(cos_) + std::abs(sin_)) / 2.0; }

/// From where on along the beam all cells of the strip lie outside the grid.
/** Its cells have columns along |cos| - across |sin|, likewise rows, and |across| < 2w. */
double CellReach::leaves(CellIndex from) const
{
  const double c = std::abs(cos_);
  const double s = std::abs(sin_);
  const double columns = cos_ > 0.0 ? grid_.columns() - from.column : from.column + 1.0;
  const double rows = sin_ > 0.0 ? grid_.rows() - from.row : from.row + 1.0;
  const double width = 2.0 * half_width();
  return std::min((columns + width * s) / c, (rows + width * c) / s);
}

void CellReach::add(StripCell cell)
{
  cell.along = cell.columns * cos_ + cell.rows * sin_;
  cell.across = -cell.columns * sin_ + cell.rows * cos_;
  const bool is_start = cell.columns == 0 && cell.rows == 0;
  if (!is_start && std::abs(cell.across) < 2.0 * half_width()) {
    strip_.push_back(cell);
  }
}

CellDistance CellReach::first(const StripCell & cell) const
{
  const double shortest = std::floor(cell.along - 2.0 * half_width() - kRounding);
  return static_cast<CellDistance>(std::max(1.0, shortest + 1.0));
}

CellDistance CellReach::last(const StripCell & cell) const
{
  const double behind = std::abs(std::abs(cos_) - std::abs(sin_)) / 2.0;
  return static_cast<CellDistance>(std::ceil(cell.along + behind + half_width() + kRounding));
}

}  // namespace stetro_supervisor
