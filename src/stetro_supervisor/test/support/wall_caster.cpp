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

#include "support/wall_caster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stetro_supervisor
{
namespace
{

constexpr double kTurn = 6.283185307179586;

double cross(const Eigen::Vector2d & a, const Eigen::Vector2d & b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Shortens the beams from the first that passes counter-clockwise of `a` up to `b`.
void lay(
  const Eigen::Vector2d & a, const Eigen::Vector2d & b, const stetro_site::BeamFan & fan,
  const std::vector<Eigen::Vector2d> & directions, std::vector<double> & ranges_m)
{
  const double gap = cross(a, b);
  const double width = std::atan2(gap, a.dot(b));
  double to_first = std::fmod(std::atan2(a.y(), a.x()) - fan.first_rad, kTurn);
  to_first += to_first < 0.0 ? kTurn : 0.0;
  const Eigen::Vector2d wall = b - a;
  for (double turn : {to_first, to_first - kTurn}) {
    const double last = std::floor((turn + width) / fan.step_rad);
    for (double k = std::max(0.0, std::ceil(turn / fan.step_rad)); k <= last; k += 1.0) {
      const auto i = static_cast<std::size_t>(k);
      if (i >= fan.count) {
        break;
      }
      const double range = gap / cross(directions[i], wall);
      if (range > 0.0 && range < ranges_m[i]) {
        ranges_m[i] = range;
      }
    }
  }
}

}  // namespace

void WallCaster::cast(
  const Eigen::Vector2d & from_m, const stetro_site::BeamFan & fan, double reach_m,
  std::vector<double> & ranges_m) const
{
  ranges_m.assign(fan.count, std::numeric_limits<double>::infinity());
  static thread_local std::vector<Eigen::Vector2d> directions;
  static thread_local stetro_site::BeamFan known;
  if (
    known.first_rad != fan.first_rad || known.step_rad != fan.step_rad ||
    known.count != fan.count) {
    directions.resize(fan.count);
    for (std::size_t i = 0; i < fan.count; ++i) {
      const double angle = fan.first_rad + static_cast<double>(i) * fan.step_rad;
      directions[i] = {std::cos(angle), std::sin(angle)};
    }
    known = fan;
  }
  for (const auto & wall : walls_) {
    const Eigen::Vector2d a = wall.from_m - from_m;
    const Eigen::Vector2d b = wall.to_m - from_m;
    if (cross(a, b) >= 0.0) {
      lay(a, b, fan, directions, ranges_m);
    } else {
      lay(b, a, fan, directions, ranges_m);
    }
  }
  for (double & range : ranges_m) {
    range = range <= reach_m ? range : std::numeric_limits<double>::infinity();
  }
}

std::vector<stetro_site::Segment> rectangle(
  const Eigen::Vector2d & low_m, const Eigen::Vector2d & high_m)
{
  const Eigen::Vector2d right(high_m.x(), low_m.y());
  const Eigen::Vector2d left(low_m.x(), high_m.y());
  return {{low_m, right}, {right, high_m}, {high_m, left}, {left, low_m}};
}

}  // namespace stetro_supervisor
