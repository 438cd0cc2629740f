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

#include "stetro_supervisor/four_beams/beam_search.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string>

namespace stetro_supervisor
{

using stetro_site::CellIndex;
using stetro_site::OccupancyGrid;

namespace
{

void check(const OccupancyGrid & grid, const std::vector<BeamInterval> & beams)
{
  if (beams.empty() || beams.size() > std::numeric_limits<std::uint8_t>::max()) {
    throw std::invalid_argument(std::to_string(beams.size()) + " beams, 1 to 255 wanted");
  }
  for (const BeamInterval & beam : beams) {
    if (beam.table == nullptr || beam.table->cells() != grid.cells().size()) {
      throw std::invalid_argument("a beam has no table of this grid");
    }
  }
}

/// What a beam's interval asks of a reach, in the type of reaches.
struct Bounds
{
  explicit Bounds(const BeamInterval & beam)
  : first(beam.table->first().data()),
    last(beam.table->last().data()),
    shortest(bounded(beam.shortest)),
    longest(bounded(beam.longest)),
    longest_known(std::min<CellDistance>(longest, kNoReturn - 1))
  {
  }

  static CellDistance bounded(int distance)
  {
    return static_cast<CellDistance>(std::clamp<int>(distance, 0, kNoReturn));
  }

  const CellDistance * first;
  const CellDistance * last;
  CellDistance shortest;
  CellDistance longest;
  CellDistance longest_known;  // what a beam meets at no known distance supports nothing
};

/// How many beams agree with each cell of a stretch, and how many support it.
struct Counts
{
  std::array<CellDistance, ReachTable::kStretch> agreeing{};
  std::array<CellDistance, ReachTable::kStretch> supporting{};
};

/// Of a known length, in one type, into memory of its own: so the compiler compares cells in bulk.
Counts count(const std::vector<Bounds> & beams, std::size_t begin)
{
  Counts counts;
  for (const Bounds & beam : beams) {
    const CellDistance * const first = beam.first + begin;
    const CellDistance * const last = beam.last + begin;
    const Bounds bounds = beam;
    for (std::size_t i = 0; i < ReachTable::kStretch; ++i) {
      const int not_shorter = last[i] >= bounds.shortest ? 1 : 0;
      const int agrees = not_shorter & (first[i] <= bounds.longest ? 1 : 0);
      const int supports = not_shorter & (last[i] <= bounds.longest_known ? 1 : 0);
      counts.agreeing[i] = static_cast<CellDistance>(counts.agreeing[i] + agrees);
      counts.supporting[i] = static_cast<CellDistance>(counts.supporting[i] + supports);
    }
  }
  return counts;
}

/// Calls `each` with the beginning of each stretch of the grid's cells and its counts.
template <class Each>
void for_each_stretch(const std::vector<BeamInterval> & beams, Each && each)
{
  const std::vector<Bounds> bounds(beams.begin(), beams.end());
  for (std::size_t begin = 0; begin < beams.front().table->first().size();
       begin += ReachTable::kStretch) {
    each(begin, count(bounds, begin));
  }
}

AgreeingCells pick(
  const OccupancyGrid & grid, const std::vector<BeamInterval> & beams, std::size_t least_agreeing)
{
  AgreeingCells picked;
  picked.beams = beams.size();
  picked.least_agreeing = least_agreeing;
  const auto least = static_cast<CellDistance>(least_agreeing);
  for_each_stretch(beams, [&](std::size_t begin, const Counts & counts) {
    if (*std::max_element(counts.agreeing.begin(), counts.agreeing.end()) < least) {
      return;
    }
    for (std::size_t i = 0; i < counts.agreeing.size(); ++i) {
      if (counts.agreeing[i] >= least) {
        picked.cells.push_back(grid.cell(begin + i));
        picked.supporting.push_back(static_cast<std::uint8_t>(counts.supporting[i]));
      }
    }
  });
  return picked;
}

}  // namespace

std::vector<CellIndex> AgreeingCells::best() const
{
  std::uint8_t most = 0;
  for (const std::uint8_t count : supporting) {
    most = std::max(most, count);
  }
  std::vector<CellIndex> chosen;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (supporting[i] == most) {
      chosen.push_back(cells[i]);
    }
  }
  return chosen;
}

AgreeingCells cells_agreeing(
  const OccupancyGrid & grid, const std::vector<BeamInterval> & beams, std::size_t least_agreeing)
{
  check(grid, beams);
  if (least_agreeing == 0 || least_agreeing > beams.size()) {
    throw std::invalid_argument(
      "least_agreeing = " + std::to_string(least_agreeing) + ", 1 to " +
      std::to_string(beams.size()) + " wanted");
  }
  return pick(grid, beams, least_agreeing);
}

AgreeingCells best_agreeing(const OccupancyGrid & grid, const std::vector<BeamInterval> & beams)
{
  check(grid, beams);
  CellDistance most = 1;
  for_each_stretch(beams, [&](std::size_t, const Counts & counts) {
    most = std::max(most, *std::max_element(counts.agreeing.begin(), counts.agreeing.end()));
  });
  return pick(grid, beams, static_cast<std::size_t>(most));
}

}  // namespace stetro_supervisor
