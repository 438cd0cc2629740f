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

#include "support/cell_room.hpp"

#include <cmath>

namespace stetro_supervisor
{
namespace
{

constexpr double kCell = 0.05;

}  // namespace

CellRoom::CellRoom()
: frame_{84, 64, kCell, Eigen::Vector2d(-2.0 * kCell, -2.0 * kCell), 0.0},
  cells_(84 * 64, stetro_site::Cell::kFree)
{
  add_wall({0.0, 0.0}, {3.99, 0.0});
  add_wall({0.0, 2.99}, {3.99, 2.99});
  add_wall({0.0, 0.0}, {0.0, 2.99});
  add_wall({3.99, 0.0}, {3.99, 2.99});
  add_wall({0.0, 2.2}, {1.0, 2.2});
  add_wall({1.0, 2.2}, {1.0, 2.99});
}

void CellRoom::add_wall(const Eigen::Vector2d & from_m, const Eigen::Vector2d & to_m)
{
  const double length = (to_m - from_m).norm();
  for (double along = 0.0; along <= length; along += 0.5 * kCell) {
    const Eigen::Vector2d at = from_m + along / length * (to_m - from_m);
    const Eigen::Array2d cell = ((at - frame_.origin_m) / kCell).array().floor();
    cells_[static_cast<std::size_t>(cell.y()) * 84 + static_cast<std::size_t>(cell.x())] =
      stetro_site::Cell::kOccupied;
  }
}

std::shared_ptr<const stetro_site::OccupancyGrid> CellRoom::grid() const
{
  return std::make_shared<const stetro_site::OccupancyGrid>(frame_, cells_);
}

std::shared_ptr<const stetro_site::DistanceField> CellRoom::distances() const
{
  return std::make_shared<const stetro_site::DistanceField>(grid(), stetro_site::Unknown::kFree);
}

stetro_site::GridCaster CellRoom::caster() const
{
  return stetro_site::GridCaster(*grid(), stetro_site::Unknown::kFree);
}

RangeProfile CellRoom::scanned(const ScannerPose & pose) const
{
  RangeProfile scan;
  scan.fan = {0.0, 6.283185307179586 / 360.0, 360};
  caster().cast(pose.position_m, {pose.yaw_rad, scan.fan.step_rad, 360}, 12.0, scan.ranges_m);
  return scan;
}

}  // namespace stetro_supervisor
