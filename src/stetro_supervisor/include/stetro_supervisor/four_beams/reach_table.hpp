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

#ifndef STETRO_SUPERVISOR__FOUR_BEAMS__REACH_TABLE_HPP_
#define STETRO_SUPERVISOR__FOUR_BEAMS__REACH_TABLE_HPP_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
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

/// How far a beam in one direction goes from each cell of a grid.
/**
 * **Unknown cells cannot exclude**: any of them may hold the first obstacle or be free, so `first`
 * counts them as obstacles and `last` as free; beyond the grid all is unknown. That makes (1) true
 * in every world that agrees with the map where the map knows something, which S-G's method 1
 * (unknown blocks, D4-7) is not: its answer can lack the truth. A sensor stands in a free cell; a
 * cell that is not free has the reach that allows nothing.
 *
 * Directions along rows and columns are swept in one pass. Any other is walked cell by cell over
 * the strip that the beams from a cell fill: a square and an obstacle's square seen along the beam
 * have the same width, so each obstacle touched hides one end of the strip or all of it, what
 * is left open is one interval, and the walk ends when that is empty. No rounding to pixels, no
 * sampling: (1) holds for every start in the cell.
 *
 * Immutable after construction: one instance may be shared between threads.
 */
class ReachTable
{
public:
  /**
   * \param heading_rad of the beam about the grid's x axis, CCW; within 1e-9 of a multiple of
   *   90 degrees it is that multiple
   * \throws std::invalid_argument for a heading that is not finite, or a grid of more than
   *   16 000 columns or rows
   */
  ReachTable(const stetro_site::OccupancyGrid & grid, double heading_rad);

  /// For a beam that starts `shift_cells` away from the sensor's cell, along the grid's axes.
  /**
   * The square of starts then covers parts of up to four cells: `first` is the least and `last`
   * the greatest of those that are not occupied.
   */
  ReachTable(
    const stetro_site::OccupancyGrid & grid, double heading_rad,
    const Eigen::Vector2d & shift_cells);

  /// Of the cell at `offset` of the grid's cells.
  [[nodiscard]] Reach at(std::size_t offset) const noexcept
  {
    return {first_[offset], last_[offset]};
  }

  /// Of the grid.
  [[nodiscard]] std::size_t cells() const noexcept { return cells_; }

  /// One number a cell, in the order of the grid's cells.
  /** Behind the last, up to a multiple of `kStretch`, are cells that allow nothing. */
  [[nodiscard]] const std::vector<CellDistance> & first() const noexcept { return first_; }
  [[nodiscard]] const std::vector<CellDistance> & last() const noexcept { return last_; }

  static constexpr std::size_t kStretch = 64;

private:
  void sweep(const stetro_site::OccupancyGrid & grid, stetro_site::CellIndex step);
  void walk(const stetro_site::OccupancyGrid & grid, double heading_rad);

  std::size_t cells_;
  std::vector<CellDistance> first_;
  std::vector<CellDistance> last_;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FOUR_BEAMS__REACH_TABLE_HPP_
