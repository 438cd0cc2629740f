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

#ifndef STETRO_SUPERVISOR__FOUR_BEAMS__PUBLISHED_SEARCH_HPP_
#define STETRO_SUPERVISOR__FOUR_BEAMS__PUBLISHED_SEARCH_HPP_

#include <optional>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"
#include "stetro_supervisor/four_beams/azimuth.hpp"

/**
 * \file
 * The search of S-G as published, with plain vectors: the yardstick of the fast ones.
 *
 * The formulas are lost in the paper's text; D4-1, D4-6 and D4-7 reconstruct them. A distance d is
 * the difference of the indices of two cells' centres, the sensor stands in a free cell, and
 *
 *   H_a = { c : g(c) = 0, g(c + d dir_a) = 1 }                                      method 2   (1)
 *   H_a = { c : (1) and g(c + k dir_a) = 0 for 0 < k < d }                          method 1   (2)
 *   P   = intersection of H_a over the four azimuths a                                         (3)
 *
 * So an unknown cell on the way blocks in method 1, where nothing unproven counts, and is ignored in
 * method 2. Cells come row by row from row 0.
 */

namespace stetro_supervisor
{

/// Whether the way between sensor and obstacle must be free: methods 1 and 2 of S-G.
enum class BeamPath { kTracked, kIgnored };

/// The two ways to find the same H: asking (1) or (2) of each cell, as the formulas are written, or
/// laying "the return path of the measuring beam" from each obstacle, as the text is.
enum class HypothesisSearch { kEveryCell, kFromObstacles };

/// What a beam from `cell` measures: the index difference to the first cell that is not free.
/** \return nothing if that cell is unknown or beyond the grid */
[[nodiscard]] std::optional<int> beam_distance(
  const stetro_site::OccupancyGrid & grid, stetro_site::CellIndex cell, Azimuth azimuth);

/// H of one beam, eq. (1) or (2).
[[nodiscard]] std::vector<stetro_site::CellIndex> hypotheses(
  const stetro_site::OccupancyGrid & grid, Azimuth azimuth, int distance, BeamPath path,
  HypothesisSearch search = HypothesisSearch::kEveryCell);

/// P, eq. (3). Each set is in the order of the grid's cells.
[[nodiscard]] std::vector<stetro_site::CellIndex> intersection(
  const PerAzimuth<std::vector<stetro_site::CellIndex>> & sets);

/// Method 1 or 2: P of four measured distances [cells].
[[nodiscard]] std::vector<stetro_site::CellIndex> published_search(
  const stetro_site::OccupancyGrid & grid, const PerAzimuth<int> & distances, BeamPath path,
  HypothesisSearch search = HypothesisSearch::kEveryCell);

/// What the paper proposes in its conclusion: method 2, each of whose P is verified with rays.
/** The same set as method 1. */
[[nodiscard]] std::vector<stetro_site::CellIndex> hybrid_search(
  const stetro_site::OccupancyGrid & grid, const PerAzimuth<int> & distances,
  HypothesisSearch search = HypothesisSearch::kEveryCell);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FOUR_BEAMS__PUBLISHED_SEARCH_HPP_
