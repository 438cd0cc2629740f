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

#ifndef STETRO_SUPERVISOR__FOUR_BEAMS__FOUR_BEAM_INDEX_HPP_
#define STETRO_SUPERVISOR__FOUR_BEAMS__FOUR_BEAM_INDEX_HPP_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"
#include "stetro_supervisor/four_beams/azimuth.hpp"
#include "stetro_supervisor/four_beams/open_cells.hpp"
#include "stetro_supervisor/four_beams/reach_table.hpp"

namespace stetro_supervisor
{

/// The four-beam search of S-G as a look-up: which cells read these four distances?
/**
 * Cells whose four beams all end on known obstacles are sorted by what they read: into groups of one
 * pair (north, south), and within a group by (west, east). Along a free run of a column north +
 * south is the run's length, the same for all its cells, so the groups are numbered run length by
 * run length and are no more than the cells: a pair is found without searching. A query of
 * tolerance k asks for (2k + 1)^2 pairs and takes out of each group found one stretch for each of
 * 2k + 1 distances west.
 *
 * Cells with a beam into the unknown read no single distance; they are kept apart (`OpenCells`). So
 * the answer is exactly
 *
 *   { c free : for each azimuth a, first_a(c) <= d_a + k and last_a(c) >= d_a - k }          (1)
 *
 * with `Reach` of `ReachTable`. It contains the truth when each |error of d| <= k; where all cells
 * are known and k = 0 it is the set of S-G's method 1.
 *
 * Immutable after construction: one instance may be shared between threads.
 */
class FourBeamIndex
{
public:
  explicit FourBeamIndex(const stetro_site::OccupancyGrid & grid);

  /// The cells of (1), in no particular order.
  /**
   * \param distances index differences, `round(d / r)` [cells]
   * \param tolerance k, not negative [cells]
   * \param cells emptied first; nothing is allocated when it has room
   */
  void find(
    const PerAzimuth<int> & distances, int tolerance,
    std::vector<stetro_site::CellIndex> & cells) const;

  /// How many cells can be found at all, and how many of them have a beam into the unknown.
  [[nodiscard]] std::size_t size() const noexcept { return closed_.size() + open_.size(); }
  [[nodiscard]] std::size_t open_size() const noexcept { return open_.size(); }

private:
  /// A cell, and what it reads in the west and in the east: west in the upper half.
  struct Closed
  {
    std::uint32_t west_east;
    std::uint16_t column;
    std::uint16_t row;
  };

  using Tables = PerAzimuth<ReachTable>;

  void number_groups(const stetro_site::OccupancyGrid & grid, const Tables & tables);
  void fill_groups(const stetro_site::OccupancyGrid & grid, const Tables & tables);
  void find_closed(
    const PerAzimuth<int> & distances, int tolerance,
    std::vector<stetro_site::CellIndex> & cells) const;

  std::vector<std::int32_t> first_group_;  // by north + south; -1: no run of that length
  std::vector<std::uint32_t> begin_;       // of each group in closed_, and the end of the last
  std::vector<Closed> closed_;
  OpenCells open_;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FOUR_BEAMS__FOUR_BEAM_INDEX_HPP_
