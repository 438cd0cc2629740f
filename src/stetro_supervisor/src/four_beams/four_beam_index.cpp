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

#include "stetro_supervisor/four_beams/four_beam_index.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace stetro_supervisor
{

using stetro_site::CellIndex;
using stetro_site::OccupancyGrid;

namespace
{

constexpr std::size_t kNorth = position(Azimuth::kNorth);
constexpr std::size_t kEast = position(Azimuth::kEast);
constexpr std::size_t kSouth = position(Azimuth::kSouth);
constexpr std::size_t kWest = position(Azimuth::kWest);
constexpr std::int32_t kNoRun = -1;

std::uint32_t pack(int west, int east)
{
  return static_cast<std::uint32_t>(west) << 16 | static_cast<std::uint32_t>(east);
}

/// Calls `each` with the offset and the four reaches of the cells that a sensor can stand in.
template <class Each>
void for_each_free(const PerAzimuth<ReachTable> & tables, Each && each)
{
  for (std::size_t offset = 0; offset < tables[0].cells(); ++offset) {
    const PerAzimuth<Reach> reach{
      tables[0].at(offset), tables[1].at(offset), tables[2].at(offset), tables[3].at(offset)};
    if (reach[0].last > 0) {
      each(offset, reach);
    }
  }
}

bool is_closed(const PerAzimuth<Reach> & reach)
{
  return std::all_of(reach.begin(), reach.end(), [](Reach r) { return r.first == r.last; });
}

}  // namespace

FourBeamIndex::FourBeamIndex(const OccupancyGrid & grid)
{
  // In the order of kAzimuths.
  const Tables tables{
    ReachTable(grid, yaw_rad(Azimuth::kNorth)), ReachTable(grid, yaw_rad(Azimuth::kEast)),
    ReachTable(grid, yaw_rad(Azimuth::kSouth)), ReachTable(grid, yaw_rad(Azimuth::kWest))};
  number_groups(grid, tables);
  fill_groups(grid, tables);
}

void FourBeamIndex::number_groups(const OccupancyGrid & grid, const Tables & tables)
{
  first_group_.assign(static_cast<std::size_t>(grid.rows()) + 1, kNoRun);
  std::int32_t groups = 0;
  for_each_free(tables, [&](std::size_t, const PerAzimuth<Reach> & reach) {
    const int run = reach[kNorth].last + reach[kSouth].last;
    if (is_closed(reach) && first_group_[static_cast<std::size_t>(run)] == kNoRun) {
      first_group_[static_cast<std::size_t>(run)] = groups;
      groups += run - 1;  // south is 1 .. run - 1
    }
  });
  begin_.assign(static_cast<std::size_t>(groups) + 1, 0);
}

void FourBeamIndex::fill_groups(const OccupancyGrid & grid, const Tables & tables)
{
  const auto group = [&](const PerAzimuth<Reach> & reach) {
    const int run = reach[kNorth].last + reach[kSouth].last;
    return static_cast<std::size_t>(
      first_group_[static_cast<std::size_t>(run)] + reach[kSouth].last - 1);
  };
  for_each_free(tables, [&](std::size_t offset, const PerAzimuth<Reach> & reach) {
    if (is_closed(reach)) {
      ++begin_[group(reach)];
    } else {
      open_.add(reach, grid.cell(offset));
    }
  });
  open_.sort();
  std::uint32_t end = 0;
  for (std::uint32_t & count : begin_) {
    end += count;
    count = end;  // for now the end: filled from the back, it becomes the beginning
  }
  closed_.resize(end);
  for_each_free(tables, [&](std::size_t offset, const PerAzimuth<Reach> & reach) {
    if (is_closed(reach)) {
      const CellIndex cell = grid.cell(offset);
      closed_[--begin_[group(reach)]] = {
        pack(reach[kWest].last, reach[kEast].last), static_cast<std::uint16_t>(cell.column),
        static_cast<std::uint16_t>(cell.row)};
    }
  });
  for (std::size_t i = 0; i + 1 < begin_.size(); ++i) {
    std::sort(
      closed_.begin() + begin_[i], closed_.begin() + begin_[i + 1],
      [](const Closed & a, const Closed & b) { return a.west_east < b.west_east; });
  }
}

void FourBeamIndex::find(
  const PerAzimuth<int> & distances, int tolerance, std::vector<CellIndex> & cells) const
{
  if (tolerance < 0) {
    throw std::invalid_argument(
      "tolerance = " + std::to_string(tolerance) + " cells, none or more wanted");
  }
  cells.clear();
  find_closed(distances, tolerance, cells);
  open_.find(distances, tolerance, cells);
}

void FourBeamIndex::find_closed(
  const PerAzimuth<int> & distances, int tolerance, std::vector<CellIndex> & cells) const
{
  const auto longest_run = static_cast<int>(first_group_.size()) - 1;
  const auto nearest = [&](std::size_t i) { return std::max(1, distances[i] - tolerance); };
  // No closed reach is as long as kNoReturn: beyond it distances need not fit their half of a key.
  const auto farthest = [&](std::size_t i) {
    return std::min<int>(kNoReturn, std::min<int>(kNoReturn, distances[i]) + tolerance);
  };
  for (int south = nearest(kSouth); south <= farthest(kSouth); ++south) {
    for (int north = nearest(kNorth); north <= farthest(kNorth); ++north) {
      const int run = north + south;
      if (run > longest_run || first_group_[static_cast<std::size_t>(run)] == kNoRun) {
        continue;
      }
      const auto group =
        static_cast<std::size_t>(first_group_[static_cast<std::size_t>(run)] + south - 1);
      auto at = closed_.begin() + begin_[group];
      const auto end = closed_.begin() + begin_[group + 1];
      for (int west = nearest(kWest); west <= farthest(kWest) && at != end; ++west) {
        at = std::lower_bound(
          at, end, pack(west, nearest(kEast)),
          [](const Closed & cell, std::uint32_t key) { return cell.west_east < key; });
        const std::uint32_t last = pack(west, farthest(kEast));
        for (; at != end && at->west_east <= last; ++at) {
          cells.push_back({at->column, at->row});
        }
      }
    }
  }
}

}  // namespace stetro_supervisor
