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

#ifndef STETRO_SUPERVISOR__FLOOR__HEADING_TABLES_HPP_
#define STETRO_SUPERVISOR__FLOOR__HEADING_TABLES_HPP_

#include <optional>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"
#include "stetro_supervisor/floor/scan_beams.hpp"
#include "stetro_supervisor/four_beams/beam_search.hpp"
#include "stetro_supervisor/four_beams/reach_table.hpp"

namespace stetro_supervisor
{

/// The four-beam search over all headings of one floor, with tables that are built once.
/**
 * It is what a `HeadingSearch` for each heading would answer, for the scanner instead of base_link.
 * A scanner's beams are an eighth of a turn apart, so with headings that divide that evenly a beam
 * of one heading points as another of another: a table for each heading serves all eight.
 *
 * For one thread.
 */
class HeadingTables
{
public:
  /// \param grid outlives the tables \param step_rad most, between headings
  HeadingTables(const stetro_site::OccupancyGrid & grid, double step_rad);

  [[nodiscard]] std::size_t headings() const { return tables_.size(); }

  /// Of the scanner, in the floor's frame [rad].
  [[nodiscard]] double heading_rad(std::size_t heading) const;

  /// Builds what this heading needs until beams have passed about so many cells.
  /** \return how many they have passed; 0 if nothing was missing */
  std::size_t build(std::size_t heading, std::size_t cells);

  /// All tables of this heading are built.
  [[nodiscard]] bool is_built(std::size_t heading) const;

  /// Where the scanner may stand if it faces so: `kWrongBeams` of the ranges may be wrong.
  /** \throws std::logic_error unless the heading is built */
  [[nodiscard]] AgreeingCells find(const ScanBeams & beams, std::size_t heading) const;

  /// The table of a direction, in eighths of a turn CCW from a heading that is built.
  [[nodiscard]] const ReachTable & towards(std::size_t heading, std::size_t eighths) const
  {
    return tables_[direction(heading, eighths)].value();
  }

private:
  [[nodiscard]] std::size_t direction(std::size_t heading, std::size_t beam) const;

  const stetro_site::OccupancyGrid & grid_;
  std::vector<std::optional<ReachTable>> tables_;  // by direction, in steps of a heading
  std::optional<ReachTableBuilder> building_;      // of one of them
  std::size_t built_direction_ = 0;                // which
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__HEADING_TABLES_HPP_
