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

#include "sim/clutter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "sim/random_stream.hpp"

namespace stetro_driver::sim
{
namespace
{

constexpr double kNowhere = std::numeric_limits<double>::infinity();
constexpr double kHalfTurn = 3.14159265358979323846;
constexpr int kTries = 1000;           // then the floor is too small for another one
constexpr double kBeforeStairs = 1.0;  // kept free [m]
constexpr double kStartRoom = 0.6;     // around where the robot starts [m]
constexpr double kRobotRoom = 0.3;     // around the robot's middle [m]
constexpr double kWallGap = 0.05;      // between a wall and what stands or walks beside it [m]
constexpr double kWaist = 0.17;        // radius of a person [m]
constexpr double kStride = 0.1;        // between the looks along a person's line [m]
constexpr double kShortestWalk = 0.8;  // [m]

/// Where something may be on one floor.
struct Room
{
  const Building * building;
  std::size_t floor;
  bool start_here;
  Eigen::Vector3d start_m;  // in the floor's frame

  [[nodiscard]] bool takes(double x_m, double y_m, double radius_m) const
  {
    const Storey & storey = building->floor(floor);
    const Eigen::Vector3d in_map = storey.in_map.to_map(Eigen::Vector3d{x_m, y_m, 0.0});
    return storey.plan.inside(x_m, y_m) &&
           storey.plan.wall_distance_m(x_m, y_m) >= radius_m + kWallGap &&
           building->stairs_distance_m(floor, in_map) >= kBeforeStairs + radius_m &&
           (!start_here ||
            std::hypot(x_m - start_m.x(), y_m - start_m.y()) >= kStartRoom + radius_m);
  }
  [[nodiscard]] Disc drawn(double radius_m, RandomStream & random) const
  {
    const FloorPlan & plan = building->floor(floor).plan;
    const double x_m = random.uniform(plan.min_x_m(), plan.max_x_m());
    const double y_m = random.uniform(plan.min_y_m(), plan.max_y_m());
    return {x_m, y_m, radius_m};
  }
};

std::array<Wall, 4> sides_of(const Disc & around, double half_x_m, double half_y_m, double yaw_rad)
{
  const double c = std::cos(yaw_rad);
  const double s = std::sin(yaw_rad);
  std::array<Wall, 4> sides{};
  const std::array<double, 5> x{half_x_m, -half_x_m, -half_x_m, half_x_m, half_x_m};
  const std::array<double, 5> y{half_y_m, half_y_m, -half_y_m, -half_y_m, half_y_m};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    sides[i].from_x_m = around.x_m + c * x[i] - s * y[i];
    sides[i].from_y_m = around.y_m + s * x[i] + c * y[i];
    sides[i].to_x_m = around.x_m + c * x[i + 1] - s * y[i + 1];
    sides[i].to_y_m = around.y_m + s * x[i + 1] + c * y[i + 1];
  }
  return sides;
}

bool walkable(const Room & room, const Disc & from, const Disc & to)
{
  const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
  const int looks = static_cast<int>(std::ceil(length_m / kStride));
  for (int i = 0; i <= looks; ++i) {
    const double share = static_cast<double>(i) / std::max(1, looks);
    const double x_m = from.x_m + share * (to.x_m - from.x_m);
    const double y_m = from.y_m + share * (to.y_m - from.y_m);
    if (!room.takes(x_m, y_m, kWaist)) {
      return false;
    }
  }
  return length_m >= kShortestWalk;
}

}  // namespace

double distance_along(const Disc & disc, double x, double y, double dx, double dy)
{
  const double to_x = disc.x_m - x;
  const double to_y = disc.y_m - y;
  const double along = to_x * dx + to_y * dy;
  const double beside = to_x * dy - to_y * dx;
  const double room = disc.radius_m * disc.radius_m - beside * beside;
  const double distance = along - std::sqrt(std::max(0.0, room));
  return room >= 0.0 && distance > 0.0 ? distance : kNowhere;
}

Clutter::Clutter(
  const Building & building, int boxes, int people, std::uint64_t seed, std::size_t start_floor,
  const Eigen::Vector3d & start_m)
{
  floors_.resize(building.floors().size());
  for (std::size_t i = 0; i < floors_.size(); ++i) {
    const Storey & storey = building.floor(i);
    if (storey.plan.walls().empty()) {
      continue;
    }
    const Room room{&building, i, i == start_floor, storey.in_map.to_frame(start_m)};
    RandomStream box_random{seed, "boxes on " + storey.id};
    for (int tries = 0; tries < kTries && static_cast<int>(floors_[i].boxes.size()) < boxes;
         ++tries) {
      const double half_x_m = box_random.uniform(0.1, 0.3);
      const double half_y_m = box_random.uniform(0.1, 0.3);
      const double yaw_rad = box_random.uniform(-kHalfTurn, kHalfTurn);
      const Disc around = room.drawn(std::hypot(half_x_m, half_y_m), box_random);
      if (room.takes(around.x_m, around.y_m, around.radius_m)) {
        floors_[i].boxes.push_back(
          {around.x_m, around.y_m, around.radius_m, sides_of(around, half_x_m, half_y_m, yaw_rad)});
      }
    }
    RandomStream walk_random{seed, "people on " + storey.id};
    for (int tries = 0; tries < kTries && static_cast<int>(floors_[i].walks.size()) < people;
         ++tries) {
      const Disc from = room.drawn(kWaist, walk_random);
      const Disc to = room.drawn(kWaist, walk_random);
      const double speed_m_s = walk_random.uniform(0.5, 1.2);
      const double ahead_m = walk_random.uniform(0.0, 10.0);
      if (walkable(room, from, to)) {
        floors_[i].walks.push_back({from.x_m, from.y_m, to.x_m, to.y_m, speed_m_s, ahead_m});
      }
    }
    walls_.reserve(std::max(walls_.capacity(), 4 * floors_[i].boxes.size()));
    people_.reserve(std::max(people_.capacity(), floors_[i].walks.size()));
  }
}

Disc Clutter::at(const Walk & walk, double time_s)
{
  const double length_m = std::hypot(walk.to_x_m - walk.from_x_m, walk.to_y_m - walk.from_y_m);
  const double gone_m = std::fmod(walk.ahead_m + walk.speed_m_s * time_s, 2.0 * length_m);
  const double share = (gone_m < length_m ? gone_m : 2.0 * length_m - gone_m) / length_m;
  return {
    walk.from_x_m + share * (walk.to_x_m - walk.from_x_m),
    walk.from_y_m + share * (walk.to_y_m - walk.from_y_m), kWaist};
}

void Clutter::look(std::size_t floor, double time_s, double x_m, double y_m)
{
  walls_.clear();
  people_.clear();
  for (const Box & box : floors_[floor].boxes) {
    if (std::hypot(box.x_m - x_m, box.y_m - y_m) >= box.radius_m + kRobotRoom) {
      walls_.insert(walls_.end(), box.sides.begin(), box.sides.end());
    }
  }
  for (const Walk & walk : floors_[floor].walks) {
    Disc person = at(walk, time_s);
    const double away_m = std::hypot(person.x_m - x_m, person.y_m - y_m);
    const double least_m = person.radius_m + kRobotRoom;
    if (away_m < least_m) {  // steps aside, the way they are looking from the robot
      const double share = away_m > 0.0 ? least_m / away_m : 0.0;
      person.x_m = away_m > 0.0 ? x_m + share * (person.x_m - x_m) : x_m + least_m;
      person.y_m = y_m + share * (person.y_m - y_m);
    }
    people_.push_back(person);
  }
}

}  // namespace stetro_driver::sim
