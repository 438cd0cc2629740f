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

#ifndef STETRO_SUPERVISOR__FOUR_BEAMS__BEAM_SEARCH_HPP_
#define STETRO_SUPERVISOR__FOUR_BEAMS__BEAM_SEARCH_HPP_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"
#include "stetro_supervisor/four_beams/reach_table.hpp"

namespace stetro_supervisor
{

/// What one beam measured, as index differences: the truth is from `shortest` to `longest`.
/** Nothing in range is an inequality: `longest` = kNoReturn (D4-11). */
struct BeamInterval
{
  const ReachTable * table = nullptr;  ///< of the beam's direction; outlives the interval
  int shortest = 0;                    ///< [cells]
  int longest = kNoReturn;             ///< [cells]
};

/// Cells that enough beams agree with.
/**
 * A beam agrees with a cell that it does not exclude. It supports the cell if it also fits the
 * nearest obstacle that is known: from cells where the map knows nothing every beam may come, and
 * such cells belong to the answer, but nothing speaks for them.
 */
struct AgreeingCells
{
  std::vector<stetro_site::CellIndex> cells;  ///< row by row from row 0
  std::vector<std::uint8_t> supporting;       ///< how many beams support each of them
  std::size_t beams = 0;                      ///< that were asked
  std::size_t least_agreeing = 0;             ///< that a cell needed

  /// Of the cells, those that as many beams support as any.
  [[nodiscard]] std::vector<stetro_site::CellIndex> best() const;
};

/// All cells that at least `least_agreeing` of the beams agree with.
/**
 * They contain the truth if no more than `beams.size() - least_agreeing` of the intervals are
 * wrong. Any number of beams in any directions; the whole grid is looked through.
 *
 * \throws std::invalid_argument if there is no beam, a beam has no table of this grid, or
 *   `least_agreeing` is 0 or more than there are beams
 */
[[nodiscard]] AgreeingCells cells_agreeing(
  const stetro_site::OccupancyGrid & grid, const std::vector<BeamInterval> & beams,
  std::size_t least_agreeing);

/// The cells that most beams agree with: of all, or else of all but one, and so on (D4-12).
/**
 * An empty set is the normal result of one wrong beam, so this asks for less until there is an
 * answer, and `least_agreeing` tells how much that was: the cells contain the truth if the beams
 * that disagree are the only wrong ones.
 */
[[nodiscard]] AgreeingCells best_agreeing(
  const stetro_site::OccupancyGrid & grid, const std::vector<BeamInterval> & beams);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FOUR_BEAMS__BEAM_SEARCH_HPP_
