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

#ifndef SUPPORT__CELL_ROOM_HPP_
#define SUPPORT__CELL_ROOM_HPP_

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "stetro_site/distance_field.hpp"
#include "stetro_site/grid_caster.hpp"
#include "stetro_site/occupancy_grid.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"

namespace stetro_supervisor
{

/// A room of 4 m x 3 m in cells of 5 cm, with a cupboard that makes it uneven.
class CellRoom
{
public:
  CellRoom();

  /// Occupies the cells from one point to another, along an axis.
  void add_wall(const Eigen::Vector2d & from_m, const Eigen::Vector2d & to_m);

  [[nodiscard]] std::shared_ptr<const stetro_site::OccupancyGrid> grid() const;
  [[nodiscard]] std::shared_ptr<const stetro_site::DistanceField> distances() const;
  [[nodiscard]] stetro_site::GridCaster caster() const;

  /// What a scanner of 360 beams sees there.
  [[nodiscard]] RangeProfile scanned(const ScannerPose & pose) const;

private:
  stetro_site::GridFrame frame_;
  std::vector<stetro_site::Cell> cells_;
};

}  // namespace stetro_supervisor

#endif  // SUPPORT__CELL_ROOM_HPP_
