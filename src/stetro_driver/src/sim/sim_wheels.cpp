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

#include "sim/sim_wheels.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_driver::sim
{
namespace
{

constexpr double kSlipSpeed = 0.1;  // how fast a slip goes by [m/s]

}  // namespace

SimWheels::SimWheels(const SimErrors & errors, std::uint64_t seed)
: errors_(errors),
  random_(seed, "wheels"),
  scale_(random_.normal(errors.odometry_scale_std)),
  variation_(errors.speed_variation_std, errors.speed_variation_time_constant_s, random_),
  disturbance_(
    errors.heading_disturbance_rms_rad_s, errors.heading_disturbance_time_constant_s, random_)
{
}

Displacement SimWheels::roll(const WheelSpeeds & told, double dt_s)
{
  const double factor = 1.0 + variation_.step(dt_s, random_);
  const double disturbance_rad_s = disturbance_.step(dt_s, random_);
  if (!told.moving()) {
    count({}, dt_s);
    return {};
  }
  const WheelSpeeds turned{factor * told.vx_m_s, factor * told.vy_m_s, factor * told.wz_rad_s};
  count(turned, dt_s);
  Displacement moved{
    turned.vx_m_s * dt_s, turned.vy_m_s * dt_s, (turned.wz_rad_s + disturbance_rad_s) * dt_s};
  const double speed_m_s = std::hypot(told.vx_m_s, told.vy_m_s);
  if (speed_m_s > 0.0) {
    if (random_.uniform() < errors_.slip_rate_hz * dt_s) {
      const double length_m = random_.uniform(errors_.slip_min_m, errors_.slip_max_m);
      slip_left_m_ += random_.uniform() < 0.5 ? length_m : -length_m;
    }
    const double most_m = kSlipSpeed * dt_s;
    const double slipped_m = std::clamp(slip_left_m_, -most_m, most_m);
    slip_left_m_ -= slipped_m;
    moved.x_m += slipped_m * told.vx_m_s / speed_m_s;
    moved.y_m += slipped_m * told.vy_m_s / speed_m_s;
  }
  return moved;
}

void SimWheels::count(const WheelSpeeds & turned, double dt_s)
{
  OdometryReading & o = odometry_;
  o.vx_m_s = (1.0 + scale_) * turned.vx_m_s;
  o.vy_m_s = (1.0 + scale_) * turned.vy_m_s;
  o.wz_rad_s = (1.0 + scale_) * turned.wz_rad_s;
  const double middle_rad = o.yaw_rad + o.wz_rad_s * dt_s / 2.0;
  o.x_m += (o.vx_m_s * std::cos(middle_rad) - o.vy_m_s * std::sin(middle_rad)) * dt_s;
  o.y_m += (o.vx_m_s * std::sin(middle_rad) + o.vy_m_s * std::cos(middle_rad)) * dt_s;
  o.rolled_m += std::hypot(o.vx_m_s, o.vy_m_s) * dt_s;
  o.turned_rad += std::abs(o.wz_rad_s) * dt_s;
  o.yaw_rad = std::remainder(o.yaw_rad + o.wz_rad_s * dt_s, 6.28318530717958647692);
}

OdometryReading SimWheels::odometry(Time now) const
{
  OdometryReading reading = odometry_;
  reading.stamp = now;
  return reading;
}

}  // namespace stetro_driver::sim
