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

#include "stetro_supervisor/profile/wall_view.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_supervisor
{
namespace
{

/// A beam that grazes its wall more than this says nothing of it (87 degrees).
constexpr double kGrazing = 0.05;
/// Chords that differ more in direction lie on two walls (sine of 6 degrees).
constexpr double kSameWall = 0.1;
/// The farthest neighbours, in beams, that a wall's direction is taken from.
constexpr double kFarthest = 20.0;

double cross(const Eigen::Vector2d & a, const Eigen::Vector2d & b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Direction of the wall with the chords `before` and `after` an end, not of unit length.
Eigen::Vector2d along(const Eigen::Vector2d & before, const Eigen::Vector2d & after)
{
  const double first = before.squaredNorm();
  const double second = after.squaredNorm();
  if (!std::isfinite(first) || !std::isfinite(second)) {
    return std::isfinite(first) ? before : after;
  }
  const double turn = cross(before, after);
  if (turn * turn < kSameWall * kSameWall * first * second && before.dot(after) > 0.0) {
    return before + after;
  }
  return first < second ? before : after;  // the chord across a jump is the longer one
}

}  // namespace

WallView::WallView(double reach_m, double baseline_m) : reach_m_(reach_m), baseline_m_(baseline_m)
{
}

void WallView::look(
  const stetro_site::ProfileCaster & map, const Beams & beams, const ScannerPose & pose)
{
  map.cast(pose.position_m, beams.fan_at(pose.yaw_rad), reach_m_, ranges_m_);
}

std::size_t WallView::spread(std::size_t i, double step_rad) const
{
  const double beams = 0.5 * baseline_m_ / (ranges_m_[i] * step_rad);
  return static_cast<std::size_t>(std::clamp(std::ceil(beams), 1.0, kFarthest));
}

void WallView::find_walls(const Beams & beams)
{
  const std::size_t n = ranges_m_.size();
  ends_.resize(n);
  normals_.assign(n, Eigen::Vector2d::Zero());
  incidences_.assign(n, 0.0);
  const auto & directions = beams.directions();
  for (std::size_t i = 0; i < n; ++i) {
    ends_[i] = ranges_m_[i] * directions[i];
  }
  const bool closed = beams.closed();
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::isfinite(ranges_m_[i])) {
      continue;
    }
    const std::size_t k = baseline_m_ > 0.0 ? spread(i, beams.step_rad()) : 1;
    if (!closed && (i < k || i + k >= n)) {
      continue;
    }
    const std::size_t next = i + k < n ? i + k : i + k - n;
    const std::size_t previous = i >= k ? i - k : i + n - k;
    const Eigen::Vector2d wall = along(ends_[i] - ends_[previous], ends_[next] - ends_[i]);
    const double length = wall.norm();
    const double facing = cross(wall, directions[i]) / length;
    if (std::abs(facing) > kGrazing) {  // false for a wall that is not a number, too
      const double scale = (facing > 0.0 ? 1.0 : -1.0) / length;
      normals_[i] = {wall.y() * scale, -wall.x() * scale};
      incidences_[i] = std::abs(facing);
    }
  }
}

}  // namespace stetro_supervisor
