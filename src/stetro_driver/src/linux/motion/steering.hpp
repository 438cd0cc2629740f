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

#ifndef LINUX__MOTION__STEERING_HPP_
#define LINUX__MOTION__STEERING_HPP_

#include <array>

#include "linux/motion/chassis_config.hpp"
#include "stetro_driver/sensor_frame.hpp"

namespace stetro_driver::linux_io
{

/// Where a joint is, from where its servo is, and back.
[[nodiscard]] inline double joint_rad(const JointConfig & joint, double servo_rad)
{
  return (joint.reversed ? -1.0 : 1.0) * (servo_rad - joint.zero_rad);
}
[[nodiscard]] inline double servo_rad(const JointConfig & joint, double joint_rad)
{
  return joint.zero_rad + (joint.reversed ? -1.0 : 1.0) * joint_rad;
}

/// The wheels' steering: front and rear turn together along a path that never runs far ahead.
/**
 * The goal goes to the target at the steering's speed, in legs of one period each. A leg is all
 * that a servo finishes by itself if nobody tells it anything more.
 */
class Steering
{
public:
  explicit Steering(const SteeringConfig & config) : config_(config) {}

  /// What the servos say. The first time, and again after restart(), the goal is where they are.
  void measure(const std::array<double, kPair> & servos_rad);
  void restart() { known_ = false; }

  void turn_to(double target_rad) { target_rad_ = target_rad; }
  void hold() { target_rad_ = goal_rad_; }
  void advance(double dt_s);

  /// Where each servo is to be.
  [[nodiscard]] std::array<double, kPair> servo_goals_rad() const;
  [[nodiscard]] SteeringReading reading() const;

  /// Front and rear stand differently, by more than a path can explain.
  [[nodiscard]] bool torn() const;

private:
  SteeringConfig config_;
  bool known_ = false;
  std::array<double, kPair> angles_rad_{};
  double goal_rad_ = 0.0;
  double target_rad_ = 0.0;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__MOTION__STEERING_HPP_
