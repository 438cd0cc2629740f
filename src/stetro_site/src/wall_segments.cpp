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

#include "stetro_site/wall_segments.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace stetro_site
{
namespace
{

void append_edges(const Polygon & polygon, std::vector<Segment> & segments)
{
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    segments.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
  }
}

}  // namespace

std::vector<Segment> wall_segments(const PolygonWalls & walls)
{
  std::vector<Segment> segments;
  append_edges(walls.outline, segments);
  for (const Polygon & obstacle : walls.obstacles) {
    append_edges(obstacle, segments);
  }
  return segments;
}

double distance_m(const Segment & wall, const Eigen::Vector2d & point_m)
{
  const Eigen::Vector2d along = wall.to_m - wall.from_m;
  const double square = along.squaredNorm();
  const double share =
    square > 0.0 ? std::clamp((point_m - wall.from_m).dot(along) / square, 0.0, 1.0) : 0.0;
  return (wall.from_m + share * along - point_m).norm();
}

double distance_m(const std::vector<Segment> & walls, const Eigen::Vector2d & point_m)
{
  double least_m = std::numeric_limits<double>::infinity();
  for (const Segment & wall : walls) {
    least_m = std::min(least_m, distance_m(wall, point_m));
  }
  return least_m;
}

}  // namespace stetro_site
