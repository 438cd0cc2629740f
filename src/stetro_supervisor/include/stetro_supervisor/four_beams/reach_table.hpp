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
#include <utility>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"
#include "stetro_supervisor/four_beams/cell_reach.hpp"

namespace stetro_supervisor
{

/// How far a beam in one direction goes from each cell of a grid.
/**
 * **Unknown cells cannot exclude**: any of them may hold the first obstacle or be free, so `first`
 * counts them as obstacles and `last` as free; beyond the grid all is unknown. That makes (1) true
 * in every world that agrees with the map where the map knows something, which S-G's method 1
 * (unknown blocks, D4-7) is not: its answer can lack the truth. A sensor stands in a free cell; a
 * cell that is not free has the reach that allows nothing.
 *
 * Directions along rows and columns are swept in one pass, any other is walked as `CellReach` does.
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
  friend class ReachTableBuilder;

  explicit ReachTable(std::size_t cells);
  void sweep(const stetro_site::OccupancyGrid & grid, stetro_site::CellIndex step);

  std::size_t cells_;
  std::vector<CellDistance> first_;
  std::vector<CellDistance> last_;
};

/// Builds a `ReachTable` of unshifted beams part by part: a large one takes a tenth of a second.
class ReachTableBuilder
{
public:
  /// As of `ReachTable`; `grid` outlives the builder.
  ReachTableBuilder(const stetro_site::OccupancyGrid & grid, double heading_rad);

  /// Works on until beams have passed about so many cells, or until the table is done.
  /** \return how many they have passed */
  std::size_t work(std::size_t cells);

  [[nodiscard]] bool is_done() const noexcept { return next_ == table_.cells_; }

  /// The table, done as far as it has been worked on.
  [[nodiscard]] ReachTable take() { return std::move(table_); }

private:
  const stetro_site::OccupancyGrid & grid_;
  CellReach reach_;
  ReachTable table_;
  std::size_t next_ = 0;  ///< offset of the cell that is worked out next
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FOUR_BEAMS__REACH_TABLE_HPP_
