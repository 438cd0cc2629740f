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

#include "sim/sim_tof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace stetro_driver::sim
{
namespace
{

constexpr double kTwoPi = 6.28318530717958647692;
constexpr double kReach = 3.0;  // what lies farther returns nothing that counts [m]
constexpr int kRings = 5;
constexpr int kRaysPerRing = 12;

Vector3 cross(const Vector3 & a, const Vector3 & b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Rays of a cone, each for the same solid angle: rings at the middles of equal parts of cos.
std::vector<Vector3> cone(const Vector3 & axis, double half_angle_rad)
{
  const Vector3 helper = std::abs(axis.z) < 0.5 ? Vector3{0.0, 0.0, 1.0} : Vector3{1.0, 0.0, 0.0};
  const Vector3 u = cross(helper, axis);  // unit: the mountings look along an axis of the body
  const Vector3 v = cross(axis, u);
  std::vector<Vector3> rays;
  for (int ring = 0; ring < kRings; ++ring) {
    const double c = 1.0 - (ring + 0.5) / kRings * (1.0 - std::cos(half_angle_rad));
    const double s = std::sqrt(1.0 - c * c);
    for (int i = 0; i < kRaysPerRing; ++i) {
      const double turn = kTwoPi * (i + 0.5) / kRaysPerRing;
      const double a = s * std::cos(turn);
      const double b = s * std::sin(turn);
      rays.push_back(
        {c * axis.x + a * u.x + b * v.x, c * axis.y + a * u.y + b * v.y,
         c * axis.z + a * u.z + b * v.z});
    }
  }
  return rays;
}

/// Distance to a box of the body along a ray, both in base_link; nothing when it misses.
std::optional<RayHit> cast_block(
  const SimBody & body, int block, const Vector3 & o, const Vector3 & d)
{
  const BodyShape & shape = body.shape();
  const double x_m = shape.block_x_m(block);
  const double half_x_m = shape.block_length_m / 2.0;
  const double half_y_m = shape.body_width_m / 2.0;
  const double z_m = body.underside_m(block);
  const std::array<double, 3> from{o.x, o.y, o.z};
  const std::array<double, 3> along{d.x, d.y, d.z};
  const std::array<double, 3> low{x_m - half_x_m, -half_y_m, z_m};
  const std::array<double, 3> high{x_m + half_x_m, half_y_m, z_m + shape.block_height_m};
  double enter_m = 0.0;
  double leave_m = kReach;
  double cosine = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double near_m = ((along[axis] > 0.0 ? low : high)[axis] - from[axis]) / along[axis];
    const double far_m = ((along[axis] > 0.0 ? high : low)[axis] - from[axis]) / along[axis];
    if (near_m > enter_m) {
      enter_m = near_m;
      cosine = std::abs(along[axis]);
    }
    leave_m = std::min(leave_m, far_m);
  }
  if (enter_m <= 0.0 || enter_m >= leave_m) {
    return std::nullopt;
  }
  return RayHit{enter_m, cosine};
}

}  // namespace

SimTof::SimTof(
  const TofMounting & mounting, const SimErrors & errors, std::uint64_t seed, std::string_view name)
: mounting_(mounting),
  errors_(errors),
  rays_(cone(mounting.direction, errors.tof_half_cone_rad)),
  random_(seed, name),
  offset_m_(random_.normal(tof_offset_std_m(errors))),
  gain_(random_.normal_within(errors.tof_gain_std, errors.tof_gain_max)),
  slow_(errors.tof_slow_std_m, errors.tof_slow_time_constant_s, random_),
  flicker_random_(seed, std::string(name) + "_flicker"),
  flicker_(errors.tof_flicker_std_m, errors.tof_flicker_time_constant_s, flicker_random_)
{
}

Echo SimTof::echo(const SimBody & body) const
{
  const Vector3 & at = mounting_.position_m;
  const double z_m = body.underside_m(mounting_.block) + at.z;
  const Vector3 local{at.x, at.y, z_m};
  const Vector3 origin = body.to_flight(at.x, at.y, z_m);
  const double c = std::cos(body.pose().yaw_rad);
  const double s = std::sin(body.pose().yaw_rad);
  double energy = 0.0;
  double moment = 0.0;
  for (const Vector3 & ray : rays_) {
    const Vector3 turned{c * ray.x - s * ray.y, s * ray.x + c * ray.y, ray.z};
    std::optional<RayHit> hit = body.cast(origin, turned, kReach);
    for (int block = 1; block <= 3; ++block) {
      const auto own =
        block == mounting_.block ? std::nullopt : cast_block(body, block, local, ray);
      if (own && (!hit || own->distance_m < hit->distance_m)) {
        hit = own;
      }
    }
    if (hit) {
      const double returned = hit->cos_incidence / (hit->distance_m * hit->distance_m);
      energy += returned;
      moment += returned * hit->distance_m;
    }
  }
  if (energy <= 0.0) {
    return {};
  }
  return {moment / energy, std::sqrt(static_cast<double>(rays_.size()) / energy), true};
}

RangeReading SimTof::measure(const SimBody & body, Time now, double cycle_s)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  RangeReading reading;
  reading.stamp = now;
  const Echo seen = echo(body);
  const double wander_m = slow_.step(cycle_s, random_) + flicker_.step(cycle_s, flicker_random_);
  double range_m = kInfinity;
  if (seen.any && finds(seen.equivalent_m)) {
    const double white_m =
      std::hypot(errors_.tof_white_std_m, errors_.tof_white_std_per_m * seen.distance_m);
    range_m = seen.distance_m < errors_.tof_minimum_m
                ? random_.uniform(0.02, 0.04)
                : seen.distance_m * (1.0 + gain_) + offset_m_ + wander_m + random_.normal(white_m);
  } else if (random_.uniform() < errors_.tof_spurious_share) {
    range_m = spurious_m();
  }
  if (range_m == kInfinity) {
    reading.range_m = kInfinity;
    reading.status = RangeStatus::kNoTarget;
    return reading;
  }
  range_m = std::round(range_m * 1000.0) / 1000.0;
  if (range_m < errors_.tof_minimum_m) {
    reading.range_m = -kInfinity;
    reading.status = RangeStatus::kTooNear;
    return reading;
  }
  reading.range_m = range_m;
  reading.std_dev_m = std::hypot(0.0021, 0.015 * range_m);  // the data sheet's, not this sensor's
  reading.status = range_m > errors_.tof_limit_m ? RangeStatus::kWeak : RangeStatus::kValid;
  return reading;
}

bool SimTof::finds(double equivalent_m)
{
  const double ratio = equivalent_m / errors_.tof_limit_m;
  double chance = 1.0;
  if (ratio > 1.0) {
    chance = std::max(0.0, 0.94 * (1.3 - ratio) / 0.3);
  } else if (ratio > 0.9) {
    chance = 1.0 - 0.06 * (ratio - 0.9) / 0.1;
  }
  return random_.uniform() < chance;
}

double SimTof::spurious_m()
{
  return random_.uniform() < 0.5 ? random_.uniform(0.002, 0.03) : random_.uniform(0.2, 2.0);
}

}  // namespace stetro_driver::sim
