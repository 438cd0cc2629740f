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

#ifndef STETRO_SUPERVISOR__FOUR_BEAMS__OPEN_CELLS_HPP_
#define STETRO_SUPERVISOR__FOUR_BEAMS__OPEN_CELLS_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"
#include "stetro_supervisor/four_beams/azimuth.hpp"
#include "stetro_supervisor/four_beams/reach_table.hpp"

namespace stetro_supervisor
{

/// Cells with a beam into the unknown, found by those of their beams that end on known obstacles.
/**
 * A table for each set of such beams, sorted by what they read. A query leaps from one stretch of
 * readings within the tolerance to the next, and looks at each cell found for what its other beams
 * may read. Cells of which no beam ends on a known obstacle are looked through one by one.
 *
 * Add all, sort, then find: then one instance may be shared between threads.
 */
class OpenCells
{
public:
  void add(const PerAzimuth<Reach> & reach, stetro_site::CellIndex cell);
  void sort();

  /// Appends the cells of (1) in `FourBeamIndex`.
  void find(
    const PerAzimuth<int> & distances, int tolerance,
    std::vector<stetro_site::CellIndex> & cells) const;

  [[nodiscard]] std::size_t size() const noexcept;

private:
  struct Open
  {
    std::uint64_t key;  ///< what the known beams read, the first of them in the highest bits
    PerAzimuth<Reach> reach;
    stetro_site::CellIndex cell;
  };

  static constexpr std::size_t kSets = 15;  ///< of known beams; those with all four are not here

  std::array<std::vector<Open>, kSets> tables_;  ///< by the set, a bit for each beam
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FOUR_BEAMS__OPEN_CELLS_HPP_
