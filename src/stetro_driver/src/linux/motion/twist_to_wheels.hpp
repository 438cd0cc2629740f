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

#ifndef LINUX__MOTION__TWIST_TO_WHEELS_HPP_
#define LINUX__MOTION__TWIST_TO_WHEELS_HPP_

#include <array>

#include "linux/motion/chassis_config.hpp"

namespace stetro_driver::linux_io
{

/// A velocity of base_link in base_link, or a small displacement of it.
struct BodyTwist
{
  double vx_m_s = 0.0;
  double vy_m_s = 0.0;
  double wz_rad_s = 0.0;
};

using WheelValues = std::array<double, kWheels>;  ///< of front left, front right, rear left, right

/// Between the body's motion and its wheels. The only place that knows which way they turn.
/**
 * All wheels point where the steering points, u = (cos a, sin a). The contact of the wheel at
 * (x, y) moves with (vx - wz y, vy + wz x), and the wheel of radius r rolls at
 *
 *   w = s ((vx - wz y) cos a + (vy + wz x) sin a) / r = s (v + wz b) / r                  (1)
 *   with v = vx cos a + vy sin a,  b = x sin a - y cos a                                  (2)
 *
 * and s = -1 for a servo that is mounted reversed. Backwards, v and wz are the least squares of
 * (1) over all wheels; what is square to u does not roll and is zero. When all b are the same, wz
 * cannot be told from v, and is zero.
 */
class TwistToWheels
{
public:
  explicit TwistToWheels(const WheelsConfig & config) : config_(config) {}

  /// Equation (1): how fast each servo has to turn [rad/s]; zero where there is no wheel.
  [[nodiscard]] WheelValues to_wheels(const BodyTwist & twist, double steering_rad) const;

  /// The inverse; also of small turns [rad] to a small displacement.
  [[nodiscard]] BodyTwist to_twist(const WheelValues & servos, double steering_rad) const;

  [[nodiscard]] bool exists(std::size_t wheel) const { return config_.wheels[wheel].id >= 0; }

private:
  WheelsConfig config_;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__MOTION__TWIST_TO_WHEELS_HPP_
