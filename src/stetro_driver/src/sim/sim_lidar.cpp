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

#include "sim/sim_lidar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stetro_driver::sim
{
namespace
{

constexpr double kTurn = 6.28318530717958647692;
constexpr double kTicksPerSecond = 100.0;
constexpr double kNowhere = std::numeric_limits<double>::infinity();

}  // namespace

SimLidar::SimLidar(const LidarShape & shape, const SimErrors & errors, std::uint64_t seed)
: shape_(shape),
  noise_m_(errors.lidar_std_m),
  lost_share_(errors.lidar_dropout_share),
  period_ticks_(std::max<std::uint64_t>(
    1, static_cast<std::uint64_t>(std::llround(kTicksPerSecond / shape.rate_hz)))),
  random_(seed, "lidar"),
  true_m_(shape.beams, kNowhere)
{
  scan_.angle_min_rad = -kTurn / 2.0;
  scan_.angle_increment_rad = kTurn / static_cast<double>(shape.beams);
  scan_.min_range_m = shape.min_range_m;
  scan_.max_range_m = shape.max_range_m;
  scan_.period_s = static_cast<double>(period_ticks_) / kTicksPerSecond;
  scan_.ranges_m.assign(shape.beams, std::numeric_limits<float>::infinity());
}

bool SimLidar::observe(
  const SimBody & body, const Building & building, std::size_t flight, std::size_t floor,
  Clutter & clutter, std::uint64_t tick, Time now)
{
  if (tick % period_ticks_ != 0) {
    return false;
  }
  if (floor == kNoFloor) {
    see_flight(body);
  } else {
    const Storey & storey = building.floor(floor);
    const Stairs & stairs = building.flight(flight);
    const Eigen::Vector3d robot = storey.in_map.to_frame(
      stairs.in_map.to_map(Eigen::Vector3d{body.pose().x_m, body.pose().y_m, 0.0}));
    clutter.look(floor, time_to_seconds(now), robot.x(), robot.y());
    see_floor(body, stairs, storey, clutter);
  }
  see_own_blocks(body);
  read(now);
  return true;
}

void SimLidar::see_floor(
  const SimBody & body, const Stairs & stairs, const Storey & storey, const Clutter & clutter)
{
  const Vector3 mounted = body.to_flight(shape_.x_m, shape_.y_m, 0.0);
  const stetro_site::Pose in_map = stairs.in_map.to_map(
    stetro_site::Pose{mounted.x, mounted.y, 0.0, body.pose().yaw_rad + shape_.yaw_rad});
  const stetro_site::Pose from = storey.in_map.to_frame(in_map);
  for (std::size_t i = 0; i < true_m_.size(); ++i) {
    const double bearing_rad =
      from.yaw_rad + scan_.angle_min_rad + static_cast<double>(i) * scan_.angle_increment_rad;
    const double dx = std::cos(bearing_rad);
    const double dy = std::sin(bearing_rad);
    double nearest_m = kNowhere;
    for (const Wall & wall : storey.plan.walls()) {
      nearest_m = std::min(nearest_m, distance_along(wall, from.x_m, from.y_m, dx, dy));
    }
    for (const Wall & wall : clutter.walls()) {
      nearest_m = std::min(nearest_m, distance_along(wall, from.x_m, from.y_m, dx, dy));
    }
    for (const Disc & person : clutter.people()) {
      nearest_m = std::min(nearest_m, distance_along(person, from.x_m, from.y_m, dx, dy));
    }
    true_m_[i] = nearest_m;
  }
}

void SimLidar::see_flight(const SimBody & body)
{
  const Vector3 from =
    body.to_flight(shape_.x_m, shape_.y_m, body.underside_m(2) + shape_.height_m);
  const double yaw_rad = body.pose().yaw_rad + shape_.yaw_rad;
  for (std::size_t i = 0; i < true_m_.size(); ++i) {
    const double bearing_rad =
      yaw_rad + scan_.angle_min_rad + static_cast<double>(i) * scan_.angle_increment_rad;
    const auto hit =
      body.cast(from, {std::cos(bearing_rad), std::sin(bearing_rad), 0.0}, shape_.max_range_m);
    true_m_[i] = hit ? hit->distance_m : kNowhere;
  }
}

void SimLidar::see_own_blocks(const SimBody & body)
{
  const BodyShape & robot = body.shape();
  const double plane_m = body.underside_m(2) + shape_.height_m;
  for (const int block : {1, 3}) {
    const double top_m = body.underside_m(block) + robot.block_height_m;
    if (plane_m < body.underside_m(block) || plane_m >= top_m) {
      continue;
    }
    const double half_x_m = robot.block_length_m / 2.0;
    const double half_y_m = robot.body_width_m / 2.0;
    const double x_m = robot.block_x_m(block) - (block == 1 ? half_x_m : -half_x_m);
    const double far_m = robot.block_x_m(block) + (block == 1 ? half_x_m : -half_x_m);
    const Wall face{x_m, -half_y_m, x_m, half_y_m};
    const Wall left{x_m, half_y_m, far_m, half_y_m};
    const Wall right{x_m, -half_y_m, far_m, -half_y_m};
    for (std::size_t i = 0; i < true_m_.size(); ++i) {
      const double bearing_rad =
        shape_.yaw_rad + scan_.angle_min_rad + static_cast<double>(i) * scan_.angle_increment_rad;
      const double dx = std::cos(bearing_rad);
      const double dy = std::sin(bearing_rad);
      for (const Wall * wall : {&face, &left, &right}) {
        true_m_[i] = std::min(true_m_[i], distance_along(*wall, shape_.x_m, shape_.y_m, dx, dy));
      }
    }
  }
}

// REP 117: +inf nothing came back, -inf nearer than it can resolve.
void SimLidar::read(Time now)
{
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  scan_.stamp = now;
  for (std::size_t i = 0; i < true_m_.size(); ++i) {
    const double error_m = random_.normal(noise_m_);
    const bool lost = random_.uniform() < lost_share_;
    const double range_m = true_m_[i] + error_m;
    if (lost || true_m_[i] > shape_.max_range_m || range_m > shape_.max_range_m) {
      scan_.ranges_m[i] = kInfinity;
    } else if (range_m < shape_.min_range_m) {
      scan_.ranges_m[i] = -kInfinity;
    } else {
      scan_.ranges_m[i] = static_cast<float>(range_m);
    }
  }
}

}  // namespace stetro_driver::sim
