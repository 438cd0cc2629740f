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

#ifndef STETRO_SUPERVISOR__FOUR_BEAMS__CELL_REACH_HPP_
#define STETRO_SUPERVISOR__FOUR_BEAMS__CELL_REACH_HPP_

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"

namespace stetro_supervisor
{

/// A distance in cells; farther than all of them when a beam need not return.
using CellDistance = std::int16_t;
constexpr CellDistance kNoReturn = std::numeric_limits<CellDistance>::max();

/// Between which distances a beam's first obstacle lies [cells].
/**
 * The length L of the beam, in cells, from wherever in the cell it starts, has
 *
 *   first - 1 <= L <= last                                                                   (1)
 *
 * Along a row or a column of known cells first = last: the index difference d of S-G (D4-6), for
 * which L, measured to the obstacle's face, is d - 1/2 -+ 1/2 as the start moves through its cell.
 */
struct Reach
{
  CellDistance first = kNoReturn;
  CellDistance last = -1;

  /// Whether a measured index difference from `shortest` to `longest` is possible.
  [[nodiscard]] bool allows(int shortest, int longest) const noexcept
  {
    return first <= longest && last >= shortest;
  }
};

/// Where the beam of a sensor that is mounted off the robot's centre starts, in whole cells.
/**
 * The square of starts then covers parts of up to four cells: `first` is the least and `last`
 * the greatest of those that are not occupied.
 */
class ShiftedStart
{
public:
  /// \throws std::invalid_argument unless the shift is finite and within a grid's greatest size
  explicit ShiftedStart(const Eigen::Vector2d & shift_cells);

  /// The beam starts in the sensor's own cell.
  [[nodiscard]] bool is_none() const noexcept
  {
    return columns_ == 0 && rows_ == 0 && right_ == 0 && up_ == 0;
  }

  /// The reach from a cell by `unshifted`, which tells that of a free cell.
  template <class Unshifted>
  [[nodiscard]] Reach reach(
    const stetro_site::OccupancyGrid & grid, stetro_site::CellIndex cell,
    const Unshifted & unshifted) const
  {
    Reach hull;
    for (int corner = 0; corner < 4; ++corner) {
      const stetro_site::CellIndex start{
        cell.column + columns_ + (corner & 1) * right_, cell.row + rows_ + (corner >> 1) * up_};
      Reach one;  // no sensor is in a wall
      if (grid.at(start) == stetro_site::Cell::kFree) {
        one = unshifted(start);
      } else if (grid.at(start) == stetro_site::Cell::kUnknown) {
        one = {1, kNoReturn};  // anything may be near, or nothing
      }
      hull.first = one.first < hull.first ? one.first : hull.first;
      hull.last = one.last > hull.last ? one.last : hull.last;
    }
    return hull;
  }

private:
  int columns_;
  int rows_;
  int right_;  ///< 1: parts of the next column, too
  int up_;
};

/// What a `ReachTable` holds of one cell, worked out when it is asked.
/**
 * For a few cells: a table takes a tenth of a second on a large map, this a thousandth of that.
 *
 * A direction that is no row or column is walked cell by cell over
 * the strip that the beams from a cell fill: a square and an obstacle's square seen along the beam
 * have the same width, so each obstacle touched hides one end of the strip or all of it, what
 * is left open is one interval, and the walk ends when that is empty. No rounding to pixels, no
 * sampling: (1) holds for every start in the cell.
 *
 * Immutable after construction: one instance may be shared between threads. `grid` must outlive it.
 */
class CellReach
{
public:
  /// As of `ReachTable`.
  CellReach(
    const stetro_site::OccupancyGrid & grid, double heading_rad,
    const Eigen::Vector2d & shift_cells = Eigen::Vector2d::Zero());

  [[nodiscard]] Reach from(stetro_site::CellIndex cell) const;

  /// The step along a row or column, if that is where the beam points.
  [[nodiscard]] const std::optional<stetro_site::CellIndex> & step() const noexcept
  {
    return step_;
  }

private:
  /// A cell that beams may touch, as seen from the cell where they start.
  struct StripCell
  {
    int columns = 0;
    int rows = 0;
    double along = 0.0;   ///< of its centre, along the beam
    double across = 0.0;  ///< of its centre, to the left of the beam
  };

  void lay_strip();
  void add(StripCell cell);
  [[nodiscard]] Reach along_axis(stetro_site::CellIndex from) const;
  [[nodiscard]] Reach across_strip(stetro_site::CellIndex from) const;
  [[nodiscard]] double half_width() const;
  [[nodiscard]] double leaves(stetro_site::CellIndex from) const;
  [[nodiscard]] CellDistance first(const StripCell & cell) const;
  [[nodiscard]] CellDistance last(const StripCell & cell) const;

  const stetro_site::OccupancyGrid & grid_;
  ShiftedStart start_;
  std::optional<stetro_site::CellIndex> step_;
  double cos_;
  double sin_;
  std::vector<StripCell> strip_;  ///< by their distance along the beam
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FOUR_BEAMS__CELL_REACH_HPP_
