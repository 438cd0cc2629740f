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

#include "sim/wall.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_driver::sim
{
namespace
{

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// Keeps what is the shortest way out so far.
void offer(std::optional<WayOut> & shortest, const WayOut & candidate)
{
  if (!shortest || candidate.depth_m < shortest->depth_m) {
    shortest = candidate;
  }
}

}  // namespace

double distance_along(const Wall & wall, double x, double y, double dx, double dy)
{
  const double along_x = wall.to_x_m - wall.from_x_m;
  const double along_y = wall.to_y_m - wall.from_y_m;
  const double cross = dx * along_y - dy * along_x;
  if (cross == 0.0) {
    return kNowhere;  // along the wall: seen edge on
  }
  const double to_x = wall.from_x_m - x;
  const double to_y = wall.from_y_m - y;
  const double share = (to_x * dy - to_y * dx) / cross;
  const double distance = (to_x * along_y - to_y * along_x) / cross;
  return share >= 0.0 && share <= 1.0 && distance > 0.0 ? distance : kNowhere;
}

std::optional<RayHit> cast(const Wall & wall, const Vector3 & origin, const Vector3 & direction)
{
  const double distance_m = distance_along(wall, origin.x, origin.y, direction.x, direction.y);
  const double z_m = origin.z + distance_m * direction.z;
  if (distance_m == kNowhere || z_m < wall.bottom_m || z_m >= wall.top_m) {
    return std::nullopt;
  }
  const double along_x = wall.to_x_m - wall.from_x_m;
  const double along_y = wall.to_y_m - wall.from_y_m;
  const double cross = direction.x * along_y - direction.y * along_x;
  return RayHit{distance_m, std::abs(cross) / std::hypot(along_x, along_y)};
}

std::optional<WayOut> way_out(const Rectangle & rectangle, const Wall & wall)
{
  const double middle_m = (rectangle.min_x_m + rectangle.max_x_m) / 2.0;
  const double half_x_m = (rectangle.max_x_m - rectangle.min_x_m) / 2.0;
  const double half_y_m = rectangle.half_width_m;
  const double px = wall.from_x_m - middle_m;
  const double qx = wall.to_x_m - middle_m;
  const auto [near_x, far_x] = std::minmax(px, qx);
  const auto [near_y, far_y] = std::minmax(wall.from_y_m, wall.to_y_m);
  const double ahead_m = half_x_m - near_x;
  const double behind_m = half_x_m + far_x;
  const double left_m = half_y_m - near_y;
  const double right_m = half_y_m + far_y;
  if (std::min({ahead_m, behind_m, left_m, right_m}) <= 0.0) {
    return std::nullopt;
  }
  const double length_m = std::hypot(qx - px, wall.to_y_m - wall.from_y_m);
  double normal_x = (wall.to_y_m - wall.from_y_m) / length_m;
  double normal_y = (px - qx) / length_m;
  double gap_m = normal_x * px + normal_y * wall.from_y_m;
  if (gap_m < 0.0) {
    normal_x = -normal_x;
    normal_y = -normal_y;
    gap_m = -gap_m;
  }
  const double through_m = half_x_m * std::abs(normal_x) + half_y_m * std::abs(normal_y) - gap_m;
  if (!(through_m > 0.0)) {
    return std::nullopt;
  }
  std::optional<WayOut> shortest;
  offer(
    shortest, {through_m, -normal_x, -normal_y, middle_m + std::copysign(half_x_m, normal_x),
               std::copysign(half_y_m, normal_y)});
  const auto within = [&](double y_m) { return std::clamp(y_m, -half_y_m, half_y_m); };
  const auto beside = [&](double x_m) { return middle_m + std::clamp(x_m, -half_x_m, half_x_m); };
  const bool from_nearer = px < qx;
  const bool from_lower = wall.from_y_m < wall.to_y_m;
  offer(
    shortest,
    {ahead_m, -1.0, 0.0, rectangle.max_x_m, within(from_nearer ? wall.from_y_m : wall.to_y_m)});
  offer(
    shortest,
    {behind_m, 1.0, 0.0, rectangle.min_x_m, within(from_nearer ? wall.to_y_m : wall.from_y_m)});
  offer(shortest, {left_m, 0.0, -1.0, beside(from_lower ? px : qx), half_y_m});
  offer(shortest, {right_m, 0.0, 1.0, beside(from_lower ? qx : px), -half_y_m});
  return shortest;
}

double beside_m(const Wall & wall, double min_x_m, double max_x_m, bool left)
{
  const double side = left ? 1.0 : -1.0;
  const auto [near_x, far_x] = std::minmax(wall.from_x_m, wall.to_x_m);
  const double from_m = std::max(near_x, min_x_m);
  const double to_m = std::min(far_x, max_x_m);
  if (from_m > to_m) {
    return kNowhere;
  }
  double least_m = side * wall.from_y_m;
  double most_m = side * wall.to_y_m;
  if (far_x > near_x) {
    const double slope = (wall.to_y_m - wall.from_y_m) / (wall.to_x_m - wall.from_x_m);
    least_m = side * (wall.from_y_m + slope * (from_m - wall.from_x_m));
    most_m = side * (wall.from_y_m + slope * (to_m - wall.from_x_m));
  }
  return std::max(least_m, most_m) <= 0.0 ? kNowhere : std::min(least_m, most_m);
}

}  // namespace stetro_driver::sim
