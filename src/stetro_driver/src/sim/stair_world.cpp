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

#include "sim/stair_world.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "sim/random_stream.hpp"

namespace stetro_driver::sim
{
namespace
{

void require_positive(double value_m, const std::string & name)
{
  if (!(std::isfinite(value_m) && value_m > 0.0)) {
    throw std::invalid_argument(
      name + " is " + std::to_string(value_m) + " m, accepted: finite and above 0");
  }
}

}  // namespace

struct StairWorld::Nearest
{
  double distance_m;
  double cos_incidence = 0.0;
  bool found = false;

  void offer(double candidate_m, double cos_candidate)
  {
    if (candidate_m > 0.0 && candidate_m < distance_m) {
      distance_m = candidate_m;
      cos_incidence = cos_candidate;
      found = true;
    }
  }
};

StairWorld::StairWorld(const StairShape & shape) { build(shape); }

StairWorld::StairWorld(
  const StairShape & shape, const SimErrors & errors, std::uint64_t seed, std::string_view name)
{
  RandomStream random{seed, name};
  StairShape built = shape;
  const auto within = [&](double limit) { return random.normal_within(limit / 2.0, limit); };
  for (double & riser_m : built.riser_m) {
    riser_m += within(errors.riser_max_m);
  }
  for (double & tread_m : built.tread_m) {
    tread_m += within(errors.tread_max_m);
  }
  build(built);
  for (double & slope : riser_slope_) {
    slope = std::tan(within(errors.riser_direction_max_rad));
  }
  width_foot_m_ += within(errors.width_max_m);
  const double width_top_m = shape.width_top_m + within(errors.width_max_m);
  left_slope_ = (width_top_m - width_foot_m_) / length_m_;
}

void StairWorld::build(const StairShape & shape)
{
  if (shape.riser_m.empty() || shape.riser_m.size() != shape.tread_m.size()) {
    throw std::invalid_argument(
      "a flight has " + std::to_string(shape.riser_m.size()) + " risers and " +
      std::to_string(shape.tread_m.size()) + " treads, accepted: as many of each, at least one");
  }
  require_positive(shape.width_foot_m, "width_foot_m");
  require_positive(shape.width_top_m, "width_top_m");
  height_m_.push_back(0.0);
  for (std::size_t i = 0; i < shape.riser_m.size(); ++i) {
    require_positive(shape.riser_m[i], "riser_m[" + std::to_string(i) + "]");
    require_positive(shape.tread_m[i], "tread_m[" + std::to_string(i) + "]");
    riser_x_m_.push_back(length_m_);
    height_m_.push_back(height_m_.back() + shape.riser_m[i]);
    length_m_ += shape.tread_m[i];
  }
  riser_slope_.assign(riser_x_m_.size(), 0.0);
  mid_m_ = (shape.width_foot_m + shape.width_top_m) / 4.0;
  width_foot_m_ = shape.width_foot_m;
  left_slope_ = (shape.width_top_m - shape.width_foot_m) / length_m_;
  right_walled_ = shape.right_walled;
  left_walled_ = shape.left_walled;
  wall_overrun_m_ = shape.wall_overrun_m;
}

double StairWorld::riser_x_m(int k, double y_m) const
{
  const auto i = static_cast<std::size_t>(k - 1);
  return riser_x_m_[i] + riser_slope_[i] * (y_m - mid_m_);
}

double StairWorld::riser_slope(int k) const
{
  return riser_slope_[static_cast<std::size_t>(k - 1)];
}

double StairWorld::height_m(int k) const { return height_m_[static_cast<std::size_t>(k)]; }

double StairWorld::width_m(double x_m) const { return width_foot_m_ + left_slope_ * x_m; }

bool StairWorld::in_walls(double x_m) const
{
  return x_m >= -wall_overrun_m_ && x_m <= length_m_ + wall_overrun_m_;
}

int StairWorld::step_at(double x_m, double y_m) const
{
  if ((!right_walled_ && y_m < 0.0) || (!left_walled_ && y_m > width_m(x_m))) {
    return 0;
  }
  int step = 0;
  while (step < steps() && x_m >= riser_x_m(step + 1, y_m)) {
    ++step;
  }
  return step;
}

double StairWorld::terrain_m(double x_m, double y_m) const { return height_m(step_at(x_m, y_m)); }

std::optional<RayHit> StairWorld::cast(
  const Vector3 & origin, const Vector3 & direction, double reach_m) const
{
  Nearest nearest{reach_m};
  cast_walls(origin, direction, nearest);
  cast_risers(origin, direction, nearest);
  cast_treads(origin, direction, nearest);
  if (!nearest.found) {
    return std::nullopt;
  }
  return RayHit{nearest.distance_m, nearest.cos_incidence};
}

void StairWorld::cast_walls(const Vector3 & o, const Vector3 & d, Nearest & nearest) const
{
  if (d.y < 0.0) {
    const double distance_m = -o.y / d.y;
    if (right_walled(o.x + distance_m * d.x)) {
      nearest.offer(distance_m, -d.y);
    }
  }
  const double closing = d.y - left_slope_ * d.x;
  if (closing > 0.0) {
    const double distance_m = (width_m(o.x) - o.y) / closing;
    if (left_walled(o.x + distance_m * d.x)) {
      nearest.offer(distance_m, closing / std::hypot(1.0, left_slope_));
    }
  }
}

void StairWorld::cast_risers(const Vector3 & o, const Vector3 & d, Nearest & nearest) const
{
  for (int k = 1; k <= steps(); ++k) {
    const double ahead_m = riser_x_m(k, o.y) - o.x;
    const double slope = riser_slope(k);
    const double closing = d.x - slope * d.y;
    if (ahead_m <= 0.0 || closing <= 0.0) {
      continue;
    }
    const double distance_m = ahead_m / closing;
    if (distance_m >= nearest.distance_m) {
      return;  // and the risers behind it are farther still
    }
    const double z_m = o.z + distance_m * d.z;
    const bool spans = riser_spans(o.x + distance_m * d.x, o.y + distance_m * d.y);
    if (spans && z_m >= height_m(k - 1) && z_m <= height_m(k)) {
      nearest.offer(distance_m, closing / std::hypot(1.0, slope));
    }
  }
}

void StairWorld::cast_treads(const Vector3 & o, const Vector3 & d, Nearest & nearest) const
{
  if (d.z >= 0.0) {
    return;
  }
  for (int k = steps(); k >= 0; --k) {
    const double distance_m = (height_m(k) - o.z) / d.z;
    if (distance_m >= nearest.distance_m) {
      return;  // and the steps below it are farther still
    }
    if (distance_m > 0.0 && step_at(o.x + distance_m * d.x, o.y + distance_m * d.y) == k) {
      nearest.offer(distance_m, -d.z);
    }
  }
}

}  // namespace stetro_driver::sim
