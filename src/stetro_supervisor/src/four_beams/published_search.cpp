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

#include "stetro_supervisor/four_beams/published_search.hpp"

#include <algorithm>
#include <iterator>

namespace stetro_supervisor
{

using stetro_site::Cell;
using stetro_site::CellIndex;
using stetro_site::OccupancyGrid;

namespace
{

CellIndex along(CellIndex from, Azimuth azimuth, int cells)
{
  const CellIndex one = step(azimuth);
  return {from.column + cells * one.column, from.row + cells * one.row};
}

bool is_free_between(const OccupancyGrid & grid, CellIndex cell, Azimuth azimuth, int distance)
{
  for (int k = 1; k < distance; ++k) {
    if (grid.at(along(cell, azimuth, k)) != Cell::kFree) {
      return false;
    }
  }
  return true;
}

bool reads(const OccupancyGrid & grid, CellIndex cell, Azimuth azimuth, int distance, BeamPath path)
{
  return grid.at(cell) == Cell::kFree &&
         grid.at(along(cell, azimuth, distance)) == Cell::kOccupied &&
         (path == BeamPath::kIgnored || is_free_between(grid, cell, azimuth, distance));
}

/// Calls `each` for the cells of the grid in their order.
template <class Each>
void for_each_cell(const OccupancyGrid & grid, Each && each)
{
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      each(CellIndex{column, row});
    }
  }
}

}  // namespace

std::optional<int> beam_distance(const OccupancyGrid & grid, CellIndex cell, Azimuth azimuth)
{
  int distance = 1;
  while (grid.at(along(cell, azimuth, distance)) == Cell::kFree) {
    ++distance;
  }
  if (grid.at(along(cell, azimuth, distance)) != Cell::kOccupied) {
    return std::nullopt;
  }
  return distance;
}

std::vector<CellIndex> hypotheses(
  const OccupancyGrid & grid, Azimuth azimuth, int distance, BeamPath path, HypothesisSearch search)
{
  std::vector<CellIndex> found;
  if (distance < 1) {
    return found;  // the sensor's own cell is free: nothing is that near
  }
  for_each_cell(grid, [&](CellIndex cell) {
    if (search == HypothesisSearch::kEveryCell) {
      if (reads(grid, cell, azimuth, distance, path)) {
        found.push_back(cell);
      }
    } else if (grid.at(cell) == Cell::kOccupied) {
      // All are shifted alike, so the order of the obstacles is that of the places.
      const CellIndex place = along(cell, azimuth, -distance);
      if (reads(grid, place, azimuth, distance, path)) {
        found.push_back(place);
      }
    }
  });
  return found;
}

std::vector<CellIndex> intersection(const PerAzimuth<std::vector<CellIndex>> & sets)
{
  const auto earlier = [](CellIndex a, CellIndex b) {
    return a.row < b.row || (a.row == b.row && a.column < b.column);
  };
  std::vector<CellIndex> common = sets[0];
  for (std::size_t i = 1; i < sets.size(); ++i) {
    std::vector<CellIndex> next;
    std::set_intersection(
      common.begin(), common.end(), sets[i].begin(), sets[i].end(), std::back_inserter(next),
      earlier);
    common = std::move(next);
  }
  return common;
}

std::vector<CellIndex> published_search(
  const OccupancyGrid & grid, const PerAzimuth<int> & distances, BeamPath path,
  HypothesisSearch search)
{
  PerAzimuth<std::vector<CellIndex>> sets;
  for (const Azimuth azimuth : kAzimuths) {
    const std::size_t i = position(azimuth);
    sets[i] = hypotheses(grid, azimuth, distances[i], path, search);
  }
  return intersection(sets);
}

std::vector<CellIndex> hybrid_search(
  const OccupancyGrid & grid, const PerAzimuth<int> & distances, HypothesisSearch search)
{
  std::vector<CellIndex> places = published_search(grid, distances, BeamPath::kIgnored, search);
  const auto sees_through = [&](CellIndex place) {
    return std::any_of(kAzimuths.begin(), kAzimuths.end(), [&](Azimuth azimuth) {
      return !is_free_between(grid, place, azimuth, distances[position(azimuth)]);
    });
  };
  places.erase(std::remove_if(places.begin(), places.end(), sees_through), places.end());
  return places;
}

}  // namespace stetro_supervisor
