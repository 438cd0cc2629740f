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

#include "linux/motion/steering.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kLeash = 0.25;     // the goal goes no further ahead of the wheels [rad]
constexpr double kArrived = 0.012;  // two counts of a servo [rad]
constexpr double kTorn = 0.15;      // between front and rear [rad]

}  // namespace

void Steering::measure(const std::array<double, kPair> & servos_rad)
{
  for (std::size_t i = 0; i < kPair; ++i) {
    angles_rad_[i] = joint_rad(config_.joints[i], servos_rad[i]);
  }
  if (!known_) {
    goal_rad_ = (angles_rad_[0] + angles_rad_[1]) / 2.0;
    target_rad_ = goal_rad_;
    known_ = true;
  }
}

void Steering::advance(double dt_s)
{
  const double most_rad = config_.speed_rad_s * dt_s;
  const double wanted = goal_rad_ + std::clamp(target_rad_ - goal_rad_, -most_rad, most_rad);
  const auto [least, greatest] = std::minmax(angles_rad_[0], angles_rad_[1]);
  // A leash may keep it from going on, and never pulls it back.
  if (wanted > goal_rad_) {
    goal_rad_ = std::max(goal_rad_, std::min(wanted, least + kLeash));
  } else {
    goal_rad_ = std::min(goal_rad_, std::max(wanted, greatest - kLeash));
  }
}

std::array<double, kPair> Steering::servo_goals_rad() const
{
  return {servo_rad(config_.joints[0], goal_rad_), servo_rad(config_.joints[1], goal_rad_)};
}

SteeringReading Steering::reading() const
{
  SteeringReading reading;
  reading.angle_rad = (angles_rad_[0] + angles_rad_[1]) / 2.0;
  reading.target_rad = target_rad_;
  reading.moving = goal_rad_ != target_rad_ || std::abs(angles_rad_[0] - goal_rad_) > kArrived ||
                   std::abs(angles_rad_[1] - goal_rad_) > kArrived;
  return reading;
}

bool Steering::torn() const { return known_ && std::abs(angles_rad_[0] - angles_rad_[1]) > kTorn; }

}  // namespace stetro_driver::linux_io
