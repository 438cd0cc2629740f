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

// What stands around each flight: the part of Building that knows surfaces.

#include <algorithm>
#include <cstddef>
#include <limits>

#include "sim/building.hpp"

namespace stetro_driver::sim
{
namespace
{

constexpr double kEdge = 1e-6;      // a wall drawn along a flight's edge is that edge [m]
constexpr double kShortest = 1e-9;  // what is left of a wall, as a share of it, and counts

Wall between(const Wall & wall, double from, double to)
{
  Wall part = wall;
  part.from_x_m = wall.from_x_m + from * (wall.to_x_m - wall.from_x_m);
  part.from_y_m = wall.from_y_m + from * (wall.to_y_m - wall.from_y_m);
  part.to_x_m = wall.from_x_m + to * (wall.to_x_m - wall.from_x_m);
  part.to_y_m = wall.from_y_m + to * (wall.to_y_m - wall.from_y_m);
  return part;
}

/// Narrows [enter, leave] to where start + share * length lies in [low, high].
void narrow(double start, double length, double low, double high, double & enter, double & leave)
{
  if (length == 0.0) {
    if (start < low || start > high) {
      leave = -1.0;
    }
    return;
  }
  const double a = (low - start) / length;
  const double b = (high - start) / length;
  enter = std::max(enter, std::min(a, b));
  leave = std::min(leave, std::max(a, b));
}

/// A wall seen from another upright frame; heights stay as they are.
Wall moved(
  const Wall & wall, const stetro_site::FrameTransform & from,
  const stetro_site::FrameTransform & to)
{
  const auto shifted = [&](double x_m, double y_m) {
    return to.to_frame(from.to_map(Eigen::Vector3d{x_m, y_m, 0.0}));
  };
  const Eigen::Vector3d begin = shifted(wall.from_x_m, wall.from_y_m);
  const Eigen::Vector3d end = shifted(wall.to_x_m, wall.to_y_m);
  return {begin.x(), begin.y(), end.x(), end.y(), wall.bottom_m, wall.top_m};
}

}  // namespace

std::vector<Wall> parts_outside(
  const Wall & wall, double min_x_m, double max_x_m, double min_y_m, double max_y_m)
{
  double enter = 0.0;
  double leave = 1.0;
  narrow(wall.from_x_m, wall.to_x_m - wall.from_x_m, min_x_m, max_x_m, enter, leave);
  narrow(wall.from_y_m, wall.to_y_m - wall.from_y_m, min_y_m, max_y_m, enter, leave);
  if (enter >= leave) {
    return {wall};
  }
  std::vector<Wall> parts;
  if (enter > kShortest) {
    parts.push_back(between(wall, 0.0, enter));
  }
  if (leave < 1.0 - kShortest) {
    parts.push_back(between(wall, leave, 1.0));
  }
  return parts;
}

// A drawing ends where a scanner's view over the stairs does. Where a flight is, its own risers and
// sides stand, as built, and what is drawn there does not.
std::vector<Wall> Building::standing_walls(std::size_t floor, const Stairs & seen_from) const
{
  std::vector<Wall> walls = floors_[floor].plan.walls();
  const stetro_site::FrameTransform * frame = &floors_[floor].in_map;
  for (const Stairs & stairs : flights_) {
    if (!joins(stairs, floor)) {
      continue;
    }
    std::vector<Wall> left;
    for (const Wall & wall : walls) {
      const std::vector<Wall> parts = parts_outside(
        moved(wall, *frame, stairs.in_map), kEdge, stairs.world.length_m(), -kEdge,
        stairs.widest_m + kEdge);
      left.insert(left.end(), parts.begin(), parts.end());
    }
    walls = left;
    frame = &stairs.in_map;
  }
  const double bottom_m = floors_[floor].pose_in_map.z_m - seen_from.pose_in_map.z_m;
  const double rise_m = seen_from.world.height_m(seen_from.world.steps());
  for (Wall & wall : walls) {
    wall = moved(wall, *frame, seen_from.in_map);
    wall.bottom_m = bottom_m;
    if (floor == seen_from.lower) {  // where the next floor begins
      wall.top_m = rise_m;
    }
  }
  return walls;
}

void Building::append_solid(
  const Stairs & solid, const Stairs & seen_from, std::vector<Wall> & walls) const
{
  const StairWorld & world = solid.world;
  const double foot_m = solid.pose_in_map.z_m - seen_from.pose_in_map.z_m;
  const auto append = [&](const Wall & wall) {
    walls.push_back(moved(wall, solid.in_map, seen_from.in_map));
  };
  for (int k = 1; k <= world.steps(); ++k) {
    const double width_m = world.width_m(world.riser_x_m(k, 0.0));
    append(
      {world.riser_x_m(k, 0.0), 0.0, world.riser_x_m(k, width_m), width_m,
       foot_m + world.height_m(k - 1), foot_m + world.height_m(k)});
  }
  const double from_m = -world.wall_overrun_m();
  const double to_m = world.length_m() + world.wall_overrun_m();
  constexpr double kUp = std::numeric_limits<double>::infinity();
  if (world.right_walled(0.0)) {
    append({from_m, 0.0, to_m, 0.0, foot_m, kUp});
  }
  if (world.left_walled(0.0)) {
    append({from_m, world.width_m(from_m), to_m, world.width_m(to_m), foot_m, kUp});
  }
}

void Building::surround(Stairs & stairs) const
{
  Surroundings around;
  around.open_below = standing_walls(stairs.lower, stairs);
  around.open_above = standing_walls(stairs.upper, stairs);
  around.at_stairs = around.open_below;
  around.at_stairs.insert(
    around.at_stairs.end(), around.open_above.begin(), around.open_above.end());
  for (const Stairs & other : flights_) {
    const bool itself = &other == &stairs;
    if (!itself && (joins(other, stairs.lower) || joins(other, stairs.upper))) {
      append_solid(other, stairs, around.at_stairs);
    }
    if (joins(other, stairs.lower)) {
      append_solid(other, stairs, around.open_below);
    }
    if (joins(other, stairs.upper)) {
      append_solid(other, stairs, around.open_above);
    }
  }
  stairs.around = around;
}

}  // namespace stetro_driver::sim
