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

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "stetro_site/floor_raster.hpp"
#include "stetro_site/wall_segments.hpp"
#include "stetro_supervisor/floor/grid_planner.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::Polygon;
using stetro_site::PolygonWalls;

constexpr double kClearance_m = 0.32;
constexpr double kCell_m = 0.05;

Polygon box(const Eigen::Vector2d & low, const Eigen::Vector2d & high)
{
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

std::shared_ptr<const stetro_site::DistanceField> field_of(const PolygonWalls & walls)
{
  return std::make_shared<const stetro_site::DistanceField>(
    std::make_shared<const stetro_site::OccupancyGrid>(stetro_site::rasterise(walls, kCell_m)),
    stetro_site::Unknown::kWall);
}

double to_walls_m(const PolygonWalls & walls, const Eigen::Vector2d & point)
{
  return stetro_site::distance_m(stetro_site::wall_segments(walls), point);
}

/// Least distance of a leg from the walls, at points a millimetre apart.
double least_m(const PolygonWalls & walls, const Eigen::Vector2d & a, const Eigen::Vector2d & b)
{
  double least = std::numeric_limits<double>::infinity();
  const int steps = static_cast<int>(std::ceil((b - a).norm() / 0.001)) + 1;
  for (int i = 0; i <= steps; ++i) {
    least = std::min(least, to_walls_m(walls, a + (b - a) * i / steps));
  }
  return least;
}

/// The shortest way by another road: Dijkstra over points about every corner, at the clearance,
/// and all straight lines between them that keep it. At most 0.5 % longer than the optimum.
double visibility_length_m(
  const PolygonWalls & walls, const Eigen::Vector2d & from, const Eigen::Vector2d & to)
{
  std::vector<Eigen::Vector2d> points{from, to};
  constexpr int kAbout = 16;
  const double radius = kClearance_m / std::cos(3.14159265358979 / kAbout) + 1e-3;
  for (const auto & wall : stetro_site::wall_segments(walls)) {
    for (int i = 0; i < kAbout; ++i) {
      const double angle = 2.0 * 3.14159265358979 * i / kAbout;
      const Eigen::Vector2d p =
        wall.from_m + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      if (stetro_site::encloses(walls.outline, p) && to_walls_m(walls, p) >= kClearance_m) {
        points.push_back(p);
      }
    }
  }
  std::vector<double> cost(points.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> done(points.size(), false);
  cost[0] = 0.0;
  const auto clear = [&](std::size_t a, std::size_t b) {
    const int steps = static_cast<int>(std::ceil((points[a] - points[b]).norm() / 0.02)) + 1;
    for (int i = 0; i <= steps; ++i) {
      if (
        to_walls_m(walls, points[a] + (points[b] - points[a]) * i / steps) < kClearance_m - 1e-6) {
        return false;
      }
    }
    return true;
  };
  for (;;) {
    std::size_t next = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!done[i] && std::isfinite(cost[i]) && (next == points.size() || cost[i] < cost[next])) {
        next = i;
      }
    }
    if (next == points.size() || next == 1) {
      return cost[1];
    }
    done[next] = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double through = cost[next] + (points[i] - points[next]).norm();
      if (!done[i] && through < cost[i] && clear(next, i)) {
        cost[i] = through;
      }
    }
  }
}

PolygonWalls random_room(std::mt19937 & random)
{
  PolygonWalls walls{box({0.0, 0.0}, {6.0, 5.0}), {}};
  std::uniform_real_distribution<double> x{0.6, 4.4};
  std::uniform_real_distribution<double> y{0.6, 3.4};
  std::uniform_real_distribution<double> size{0.2, 1.0};
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector2d low{x(random), y(random)};
    walls.obstacles.push_back(box(low, low + Eigen::Vector2d{size(random), size(random)}));
  }
  return walls;
}

}  // namespace

TEST(GridPlanner, GoesStraightWhereNothingStands)
{
  const PolygonWalls room{box({0.0, 0.0}, {4.0, 3.0}), {}};
  const FloorPath path = GridPlanner{field_of(room), kClearance_m}.plan({0.5, 0.5}, {3.5, 2.5});
  ASSERT_EQ(path.corners_m.size(), 2u) << path.refusal;
  EXPECT_NEAR(path.length_m(), std::hypot(3.0, 2.0), 1e-9);
}

TEST(GridPlanner, GoesRoundAWallByItsEnd)
{
  PolygonWalls room{box({0.0, 0.0}, {4.0, 4.0}), {box({1.91, 0.01}, {2.09, 1.99})}};
  const FloorPath path = GridPlanner{field_of(room), kClearance_m}.plan({1.0, 1.0}, {3.0, 1.0});
  ASSERT_FALSE(path.corners_m.empty()) << path.refusal;
  // The wall's cells reach from 1.9 to 2.1 m and up to 2 m. By hand: tangents from (1, 1) and
  // (3, 1) to circles of 0.32 m about (1.9, 2) and (2.1, 2). The centre is 1.3454 m off, so each
  // tangent is sqrt(1.3454^2 - 0.32^2) = 1.3068 m long and ends
  // acos(0.32 / 1.3454) = 1.3307 rad from the line to the centre; that line points
  // pi - atan(0.9) = 2.4088 rad off straight up, which leaves an arc of 1.0781 rad. With the 0.2 m
  // over the wall's end 2 (1.3068 + 0.32 * 1.0781) + 0.2 = 3.504 m.
  EXPECT_NEAR(path.length_m(), 3.504, 0.04 * 3.504);
}

TEST(GridPlanner, SaysWhyThereIsNoWay)
{
  PolygonWalls room{box({0.0, 0.0}, {4.0, 4.0}), {box({1.9, 0.4}, {2.1, 3.6})}};
  const GridPlanner planner{field_of(room), kClearance_m};
  EXPECT_NE(
    planner.plan({1.0, 1.0}, {3.0, 1.0}).refusal.find("no way wide enough"), std::string::npos);
  EXPECT_NE(
    planner.plan({2.0, 2.0}, {3.0, 1.0}).refusal.find("stands in a wall"), std::string::npos);
  EXPECT_NE(planner.plan({1.0, 1.0}, {3.9, 1.0}).refusal.find("the goal"), std::string::npos);
  EXPECT_NE(
    planner.plan({std::nan(""), 1.0}, {3.0, 1.0}).refusal.find("not a number"), std::string::npos);
}

TEST(GridPlanner, LeadsAStartThatIsTooNearAwayFromTheWallFirst)
{
  const PolygonWalls room{box({0.0, 0.0}, {4.0, 3.0}), {}};
  const FloorPath path = GridPlanner{field_of(room), kClearance_m}.plan({1.0, 0.2}, {3.5, 0.4});
  ASSERT_GE(path.corners_m.size(), 3u) << path.refusal;
  EXPECT_GE(least_m(room, path.corners_m[0], path.corners_m[1]), 0.2 - kCell_m);
  for (std::size_t i = 2; i < path.corners_m.size(); ++i) {
    EXPECT_GE(least_m(room, path.corners_m[i - 1], path.corners_m[i]), kClearance_m);
  }
}

// Property: in rooms of boxes no leg is nearer to a wall than the clearance, the way is at most 5 %
// longer than the shortest, and where the planner finds none there is hardly one: cells that a wall
// touches are all wall, so a gap must be wider than it by two cells.
TEST(GridPlanner, IsShortAndClearInRandomRooms)
{
  std::mt19937 random{20260301};
  double worst = 1.0;
  int found = 0;
  for (int i = 0; i < 40; ++i) {
    const PolygonWalls room = random_room(random);
    const Eigen::Vector2d from{0.45, 0.45};
    const Eigen::Vector2d to{5.5, 4.5};
    const FloorPath path = GridPlanner{field_of(room), kClearance_m}.plan(from, to);
    const double shortest = visibility_length_m(room, from, to);
    if (path.corners_m.empty()) {
      ADD_FAILURE() << "room " << i << ": " << path.refusal << ", shortest " << shortest;
      continue;
    }
    ++found;
    for (std::size_t k = 1; k < path.corners_m.size(); ++k) {
      EXPECT_GE(least_m(room, path.corners_m[k - 1], path.corners_m[k]), kClearance_m)
        << "room " << i << ", leg " << k;
    }
    EXPECT_LE(path.length_m(), 1.05 * shortest) << "room " << i;
    worst = std::max(worst, path.length_m() / shortest);
  }
  RecordProperty("worst_ratio", std::to_string(worst));
  std::cout << found << " rooms, at worst " << worst << " of the shortest way\n";
}

}  // namespace stetro_supervisor
