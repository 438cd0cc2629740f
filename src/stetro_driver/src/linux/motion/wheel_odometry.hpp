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

#ifndef LINUX__MOTION__WHEEL_ODOMETRY_HPP_
#define LINUX__MOTION__WHEEL_ODOMETRY_HPP_

#include <array>
#include <cstddef>

#include "linux/motion/twist_to_wheels.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// How far a servo that turns round and round has turned, although it measures 320 degrees only.
/**
 * A reading fixes the angle modulo one turn, and the speed says which turn. In the gap that it
 * cannot measure it is led on at the speed it was told, and not beyond the gap; the first reading
 * behind the gap puts it right.
 */
class TurningAngle
{
public:
  /// \param told_rad_s speed it was told since the last reading
  void measure(Time stamp, double position_rad, bool in_gap, double told_rad_s);

  [[nodiscard]] double angle_rad() const { return angle_rad_; }
  /// Over the last tenth of a second: calm, and half of that late.
  [[nodiscard]] double speed_rad_s() const;
  /// Between the last two readings: what it adds up to is the angle.
  [[nodiscard]] double last_speed_rad_s() const { return last_speed_rad_s_; }

private:
  struct Sample
  {
    Time stamp{0};
    double angle_rad = 0.0;
  };
  static constexpr std::size_t kRemembered = 16;

  void remember(Time stamp);

  std::array<Sample, kRemembered> samples_{};
  std::size_t count_ = 0;  // all that were remembered
  Time stamp_{0};
  double angle_rad_ = 0.0;
  double last_speed_rad_s_ = 0.0;
};

/// What one wheel's servo said.
struct WheelReading
{
  Time stamp{0};
  double position_rad = 0.0;
  bool in_gap = false;
  double told_rad_s = 0.0;
};

/// Dead reckoning from what the wheels turned. Starts at zero where the robot stands.
/**
 * The twist is that of the last interval, so whoever adds it up arrives at the pose. A mean over
 * longer would be calmer and late: at 0.15 m/s each 10 ms are 1.5 mm at every start and stop.
 */
class WheelOdometry
{
public:
  explicit WheelOdometry(const WheelsConfig & config) : geometry_(config) {}

  void update(const std::array<WheelReading, kWheels> & wheels, double steering_rad);

  [[nodiscard]] const OdometryReading & reading() const { return reading_; }
  [[nodiscard]] double wheel_speed_rad_s(std::size_t wheel) const
  {
    return wheels_[wheel].speed_rad_s();
  }

private:
  TwistToWheels geometry_;
  std::array<TurningAngle, kWheels> wheels_{};
  bool started_ = false;
  OdometryReading reading_{};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__MOTION__WHEEL_ODOMETRY_HPP_
