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

#ifndef LINUX__MOTION__WHEEL_SPEED_HPP_
#define LINUX__MOTION__WHEEL_SPEED_HPP_

#include <algorithm>

namespace stetro_driver::linux_io
{

/// The PWM of a wheel whose servo knows no speed, only a share of full power.
/**
 *   pwm = wanted / full + i,   di/dt = k (wanted - measured) / full,   |i| <= 0.3         (1)
 *
 * What battery and load take away from the first term, the second one adds within half a second.
 * A wheel that is to stand gets no power at once.
 */
class WheelSpeed
{
public:
  /// \return share of full power, -1 to 1
  double pwm(double wanted_rad_s, double measured_rad_s, double full_rad_s, double dt_s)
  {
    if (wanted_rad_s == 0.0) {
      trim_ = 0.0;
      return 0.0;
    }
    constexpr double kGain = 2.0;  // k [1/s]
    constexpr double kMost = 0.3;
    trim_ += kGain * (wanted_rad_s - measured_rad_s) / full_rad_s * dt_s;
    trim_ = std::clamp(trim_, -kMost, kMost);
    return std::clamp(wanted_rad_s / full_rad_s + trim_, -1.0, 1.0);
  }

private:
  double trim_ = 0.0;  // i in (1)
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__MOTION__WHEEL_SPEED_HPP_
