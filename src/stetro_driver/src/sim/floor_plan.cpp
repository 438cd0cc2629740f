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

#include "sim/floor_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stetro_driver::sim
{
namespace
{

double distance_m(const Wall & wall, double x_m, double y_m)
{
  const double along_x = wall.to_x_m - wall.from_x_m;
  const double along_y = wall.to_y_m - wall.from_y_m;
  const double share = ((x_m - wall.from_x_m) * along_x + (y_m - wall.from_y_m) * along_y) /
                       (along_x * along_x + along_y * along_y);
  const double nearest = std::clamp(share, 0.0, 1.0);
  return std::hypot(
    wall.from_x_m + nearest * along_x - x_m, wall.from_y_m + nearest * along_y - y_m);
}

}  // namespace

FloorPlan::FloorPlan(const FloorShape & shape) : drawn_(shape.drawn), polygons_(shape.walls)
{
  for (const stetro_site::Polygon & polygon : polygons_) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto & from = polygon[i];
      const auto & to = polygon[(i + 1) % polygon.size()];
      Wall wall;
      wall.from_x_m = from.x();
      wall.from_y_m = from.y();
      wall.to_x_m = to.x();
      wall.to_y_m = to.y();
      const bool first = walls_.empty();
      min_x_m_ = first ? from.x() : std::min(min_x_m_, from.x());
      max_x_m_ = first ? from.x() : std::max(max_x_m_, from.x());
      min_y_m_ = first ? from.y() : std::min(min_y_m_, from.y());
      max_y_m_ = first ? from.y() : std::max(max_y_m_, from.y());
      walls_.push_back(wall);
    }
  }
}

bool FloorPlan::inside(double x_m, double y_m) const
{
  const Eigen::Vector2d point{x_m, y_m};
  for (std::size_t i = 0; i < polygons_.size(); ++i) {
    const bool outline = i == 0;
    if (stetro_site::encloses(polygons_[i], point) != outline) {
      return false;
    }
  }
  return true;
}

double FloorPlan::wall_distance_m(double x_m, double y_m) const
{
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Wall & wall : walls_) {
    nearest_m = std::min(nearest_m, distance_m(wall, x_m, y_m));
  }
  return nearest_m;
}

}  // namespace stetro_driver::sim
