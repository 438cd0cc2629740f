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

#include "profiles/room_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stetro_bringup
{
namespace
{

constexpr double kTurn = 6.283185307179586;

/// Range along `d` from `p` to a wall: p + t d = from + s (to - from), 0 <= s <= 1, t > 0.
double range_to(
  const stetro_site::Segment & wall, const Eigen::Vector2d & p, const Eigen::Vector2d & d)
{
  const Eigen::Vector2d w = wall.to_m - wall.from_m;
  const Eigen::Vector2d g = wall.from_m - p;
  const double denominator = w.x() * d.y() - w.y() * d.x();
  const double t = (w.x() * g.y() - w.y() * g.x()) / denominator;
  const double s = (d.x() * g.y() - d.y() * g.x()) / denominator;
  const bool met = s >= 0.0 && s <= 1.0 && t > 0.0;  // false where parallel: not a number
  return met ? t : std::numeric_limits<double>::infinity();
}

}  // namespace

stetro_supervisor::RangeProfile scanned(
  const std::vector<stetro_site::Segment> & walls, const stetro_supervisor::ScannerPose & pose,
  std::size_t beams)
{
  stetro_supervisor::RangeProfile scan;
  scan.fan = {0.0, kTurn / static_cast<double>(beams), beams};
  for (std::size_t i = 0; i < beams; ++i) {
    const double angle = pose.yaw_rad + static_cast<double>(i) * scan.fan.step_rad;
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto & wall : walls) {
      nearest = std::min(nearest, range_to(wall, pose.position_m, direction));
    }
    scan.ranges_m.push_back(nearest);
  }
  return scan;
}

void add_noise(stetro_supervisor::RangeProfile & scan, double sigma, std::mt19937_64 & random)
{
  std::normal_distribution<double> noise(0.0, sigma);
  for (double & range : scan.ranges_m) {
    range += noise(random);
    range = range > 0.0 ? range : -std::numeric_limits<double>::infinity();
  }
}

void drop_out(stetro_supervisor::RangeProfile & scan, double share, std::mt19937_64 & random)
{
  std::bernoulli_distribution lost(share);
  for (double & range : scan.ranges_m) {
    range = lost(random) ? std::numeric_limits<double>::infinity() : range;
  }
}

}  // namespace stetro_bringup
