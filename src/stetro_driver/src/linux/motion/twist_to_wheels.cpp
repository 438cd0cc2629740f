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

#include "linux/motion/twist_to_wheels.hpp"

#include <cmath>

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kSamePlace = 1e-6;  // a spread of lever arms below this is none [m^2]

// Equation (2).
double lever_m(const WheelConfig & wheel, double steering_rad)
{
  return wheel.x_m * std::sin(steering_rad) - wheel.y_m * std::cos(steering_rad);
}

double sense(const WheelConfig & wheel) { return wheel.reversed ? -1.0 : 1.0; }

}  // namespace

WheelValues TwistToWheels::to_wheels(const BodyTwist & twist, double steering_rad) const
{
  const double radius_m = config_.diameter_m / 2.0;
  const double v = twist.vx_m_s * std::cos(steering_rad) + twist.vy_m_s * std::sin(steering_rad);
  WheelValues speeds{};
  for (std::size_t i = 0; i < kWheels; ++i) {
    const WheelConfig & wheel = config_.wheels[i];
    if (exists(i)) {
      speeds[i] = sense(wheel) * (v + twist.wz_rad_s * lever_m(wheel, steering_rad)) / radius_m;
    }
  }
  return speeds;
}

BodyTwist TwistToWheels::to_twist(const WheelValues & servos, double steering_rad) const
{
  const double radius_m = config_.diameter_m / 2.0;
  double count = 0.0;
  double sum_rolled = 0.0;
  double sum_lever = 0.0;
  for (std::size_t i = 0; i < kWheels; ++i) {
    if (exists(i)) {
      count += 1.0;
      sum_rolled += sense(config_.wheels[i]) * servos[i] * radius_m;
      sum_lever += lever_m(config_.wheels[i], steering_rad);
    }
  }
  const double mean_rolled = sum_rolled / count;
  const double mean_lever = sum_lever / count;
  double spread = 0.0;
  double product = 0.0;
  for (std::size_t i = 0; i < kWheels; ++i) {
    if (exists(i)) {
      const double lever = lever_m(config_.wheels[i], steering_rad) - mean_lever;
      spread += lever * lever;
      product += lever * sense(config_.wheels[i]) * servos[i] * radius_m;
    }
  }
  const double wz = spread > kSamePlace ? product / spread : 0.0;
  const double v = mean_rolled - wz * mean_lever;
  return {v * std::cos(steering_rad), v * std::sin(steering_rad), wz};
}

}  // namespace stetro_driver::linux_io
