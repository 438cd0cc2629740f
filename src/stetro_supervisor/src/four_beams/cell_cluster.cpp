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

#include "stetro_supervisor/four_beams/cell_cluster.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <utility>

namespace stetro_supervisor
{

using stetro_site::CellIndex;
using stetro_site::OccupancyGrid;

namespace
{

/// Takes the cells that hang together with `seed` out of `left`.
std::vector<CellIndex> take_component(
  const OccupancyGrid & grid, CellIndex seed, std::unordered_set<std::size_t> & left)
{
  std::vector<CellIndex> component{seed};
  left.erase(grid.offset(seed));
  for (std::size_t next = 0; next < component.size(); ++next) {
    const CellIndex cell = component[next];
    for (int row = cell.row - 1; row <= cell.row + 1; ++row) {
      for (int column = cell.column - 1; column <= cell.column + 1; ++column) {
        const CellIndex neighbour{column, row};
        if (grid.contains(neighbour) && left.erase(grid.offset(neighbour)) > 0) {
          component.push_back(neighbour);
        }
      }
    }
  }
  return component;
}

CellCluster measured(const OccupancyGrid & grid, std::vector<CellIndex> cells)
{
  std::sort(cells.begin(), cells.end(), [&](CellIndex a, CellIndex b) {
    return grid.offset(a) < grid.offset(b);
  });
  CellCluster cluster;
  cluster.lowest = cluster.highest = cells.front();
  for (const CellIndex & cell : cells) {
    cluster.lowest.column = std::min(cluster.lowest.column, cell.column);
    cluster.lowest.row = std::min(cluster.lowest.row, cell.row);
    cluster.highest.column = std::max(cluster.highest.column, cell.column);
    cluster.highest.row = std::max(cluster.highest.row, cell.row);
    cluster.centroid_m += grid.centre_m(cell);
  }
  const auto count = static_cast<double>(cells.size());
  const double side_m = grid.resolution_m();
  cluster.centroid_m /= count;
  cluster.extent_m = side_m * Eigen::Vector2d(
                                cluster.highest.column - cluster.lowest.column + 1,
                                cluster.highest.row - cluster.lowest.row + 1);
  cluster.area_m2 = count * side_m * side_m;
  cluster.cells = std::move(cells);
  return cluster;
}

}  // namespace

std::vector<CellCluster> clusters(const OccupancyGrid & grid, const std::vector<CellIndex> & cells)
{
  std::unordered_set<std::size_t> left;
  for (const CellIndex & cell : cells) {
    if (!grid.contains(cell)) {
      throw std::invalid_argument(
        "cell (" + std::to_string(cell.column) + ", " + std::to_string(cell.row) +
        ") lies outside the grid");
    }
    left.insert(grid.offset(cell));
  }
  std::vector<CellCluster> found;
  for (const CellIndex & cell : cells) {
    if (left.count(grid.offset(cell)) > 0) {
      found.push_back(measured(grid, take_component(grid, cell, left)));
    }
  }
  std::sort(found.begin(), found.end(), [&](const CellCluster & a, const CellCluster & b) {
    if (a.cells.size() != b.cells.size()) {
      return a.cells.size() > b.cells.size();
    }
    return grid.offset(a.cells.front()) < grid.offset(b.cells.front());
  });
  return found;
}

}  // namespace stetro_supervisor
