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

#ifndef STETRO_SUPERVISOR__FOUR_BEAMS__CELL_CLUSTER_HPP_
#define STETRO_SUPERVISOR__FOUR_BEAMS__CELL_CLUSTER_HPP_

#include <Eigen/Core>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"

namespace stetro_supervisor
{

/// Cells of an answer that touch one another, by a side or a corner.
struct CellCluster
{
  std::vector<stetro_site::CellIndex> cells;  ///< row by row from row 0
  stetro_site::CellIndex lowest;              ///< least column and least row that occur
  stetro_site::CellIndex highest;             ///< greatest column and greatest row that occur
  Eigen::Vector2d centroid_m = Eigen::Vector2d::Zero();  ///< of the cells, in the floor's frame
  Eigen::Vector2d extent_m = Eigen::Vector2d::Zero();    ///< along the grid's axes, outer edges
  double area_m2 = 0.0;
};

/// The connected components of a set of cells, the largest first.
/**
 * Clusters of one size come in the order of their first cells. Cells may come in any order and more
 * than once. \throws std::invalid_argument naming a cell that lies outside the grid
 */
[[nodiscard]] std::vector<CellCluster> clusters(
  const stetro_site::OccupancyGrid & grid, const std::vector<stetro_site::CellIndex> & cells);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FOUR_BEAMS__CELL_CLUSTER_HPP_
