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

#include "profiles/grid_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stetro_bringup
{
namespace
{

constexpr double kTurn = 6.283185307179586;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// One coordinate of a beam on its way through the cells, in cells.
struct Walk
{
  Walk(double from, double direction)
  : cell(static_cast<int>(std::floor(from))),
    step(direction > 0.0 ? 1 : -1),
    per_cell(std::abs(1.0 / direction)),
    next((direction > 0.0 ? cell + 1.0 - from : from - cell) * per_cell)
  {
    if (direction == 0.0) {
      next = kInfinity;  // and not 0 times infinity
    }
  }

  int cell;
  int step;
  double per_cell;  ///< length of the beam from border to border
  double next;      ///< length of the beam at the next border
};

double range_in_cells(
  const stetro_site::OccupancyGrid & grid, const Eigen::Vector2d & from,
  const Eigen::Vector2d & direction, double reach)
{
  Walk x(from.x(), direction.x());
  Walk y(from.y(), direction.y());
  double length = 0.0;
  while (length < reach) {
    if (grid.at({x.cell, y.cell}) == stetro_site::Cell::kOccupied) {
      return length;
    }
    Walk & nearer = x.next < y.next ? x : y;
    length = nearer.next;
    nearer.next += nearer.per_cell;
    nearer.cell += nearer.step;
  }
  return kInfinity;
}

}  // namespace

stetro_supervisor::RangeProfile scanned(
  const stetro_site::OccupancyGrid & grid, const stetro_supervisor::ScannerPose & pose,
  std::size_t beams, double reach_m)
{
  stetro_supervisor::RangeProfile scan;
  scan.fan = {0.0, kTurn / static_cast<double>(beams), beams};
  const Eigen::Vector2d from = grid.to_cells(pose.position_m);
  const double resolution_m = grid.resolution_m();
  for (std::size_t i = 0; i < beams; ++i) {
    const double angle =
      pose.yaw_rad - grid.frame().yaw_rad + static_cast<double>(i) * scan.fan.step_rad;
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    scan.ranges_m.push_back(
      resolution_m * range_in_cells(grid, from, direction, reach_m / resolution_m));
  }
  return scan;
}

}  // namespace stetro_bringup
