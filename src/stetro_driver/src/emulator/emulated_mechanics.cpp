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

#include "emulator/emulated_mechanics.hpp"

#include <algorithm>
#include <cmath>

#include "linux/motion/steering.hpp"

namespace stetro_driver::emulator
{
namespace
{

using linux_io::kPair;
using linux_io::kWheels;
using linux_io::Torque;

constexpr double kFullSpeed = 7.1;   // of a servo that follows its goal [rad/s]
constexpr double kDeadBand = 4e-4;   // a servo does nothing about less [m]
constexpr double kFallSpeed = 0.30;  // of a block that nothing holds [m/s]

}  // namespace

EmulatedMechanics::EmulatedMechanics(const linux_io::ChassisConfig & config)
: config_(config), wheels_(config.wheels)
{
  for (std::size_t i = 0; i < kPair; ++i) {
    shafts_.steering[i].position_rad = linux_io::servo_rad(config_.steering.joints[i], 0.0);
    shafts_.lifts[i].position_rad = linux_io::servo_rad(config_.lifts.joints[i], 0.0);
  }
}

double EmulatedMechanics::extension_m(std::size_t lift) const
{
  return config_.lifts.m_per_rad *
         linux_io::joint_rad(config_.lifts.joints[lift], shafts_.lifts[lift].position_rad);
}

SimActuation EmulatedMechanics::follow(
  const ChassisDrives & drives, const std::array<BlockReading, kBlocks> & blocks, double dt_s)
{
  SimActuation moved;
  steer(drives, dt_s);
  moved.steering_rad = steering_rad_;
  roll(drives, moved);
  const bool block2_stands = blocks[1].at_lower_lock;
  const Extensions way_m = wanted_m(drives, block2_stands, dt_s);
  // Only motors raise a block: outer ones that nothing holds fall as far as the ground lets them.
  const bool powered =
    drives.lifts[0].torque == Torque::kOn && drives.lifts[1].torque == Torque::kOn;
  if (!block2_stands || (powered && way_m[0] < 0.0 && way_m[1] < 0.0)) {
    moved.lifted_m[1] = -(way_m[0] + way_m[1]) / 2.0;
  } else if (!(way_m[0] > 0.0 && way_m[1] > 0.0)) {  // else it has touched down, and both stall
    moved.lifted_m[0] = way_m[0];
    moved.lifted_m[2] = way_m[1];
  }
  return moved;
}

/// How far each lift would go in this tick if nothing stopped it.
EmulatedMechanics::Extensions EmulatedMechanics::wanted_m(
  const ChassisDrives & drives, bool block2_stands, double dt_s) const
{
  const double most_m = kFullSpeed * config_.lifts.m_per_rad * dt_s;
  Extensions way_m{};
  for (std::size_t i = 0; i < kPair; ++i) {
    const ServoDrive & drive = drives.lifts[i];
    if (drive.torque == Torque::kFree) {
      way_m[i] = (block2_stands ? -1.0 : 1.0) * kFallSpeed * dt_s;
    } else if (drive.torque == Torque::kOn) {
      const double goal_m =
        config_.lifts.m_per_rad * linux_io::joint_rad(config_.lifts.joints[i], drive.goal_rad);
      const double left_m = goal_m - extension_m(i);
      way_m[i] = std::abs(left_m) < kDeadBand ? 0.0 : std::clamp(left_m, -most_m, most_m);
    }
  }
  return way_m;
}

void EmulatedMechanics::steer(const ChassisDrives & drives, double dt_s)
{
  const double most_rad = kFullSpeed * dt_s;
  double sum_rad = 0.0;
  for (std::size_t i = 0; i < kPair; ++i) {
    Shaft & shaft = shafts_.steering[i];
    const double before_rad = shaft.position_rad;
    if (drives.steering[i].torque == Torque::kOn) {
      const double left_rad = drives.steering[i].goal_rad - shaft.position_rad;
      shaft.position_rad += std::clamp(left_rad, -most_rad, most_rad);
    }
    shaft.speed_rad_s = (shaft.position_rad - before_rad) / dt_s;
    sum_rad += linux_io::joint_rad(config_.steering.joints[i], shaft.position_rad);
  }
  steering_rad_ = sum_rad / kPair;
}

void EmulatedMechanics::roll(const ChassisDrives & drives, SimActuation & moved) const
{
  linux_io::WheelValues speeds{};
  for (std::size_t i = 0; i < kWheels; ++i) {
    const ServoDrive & drive = drives.wheels[i];
    const bool powered =
      drive.torque == Torque::kOn && drive.mode == linux_io::ServoMode::kVelocity;
    speeds[i] = powered ? drive.pwm * config_.wheels.full_speed_rad_s : 0.0;
  }
  const linux_io::BodyTwist twist = wheels_.to_twist(speeds, steering_rad_);
  moved.vx_m_s = twist.vx_m_s;
  moved.vy_m_s = twist.vy_m_s;
  moved.wz_rad_s = twist.wz_rad_s;
}

const ChassisShafts & EmulatedMechanics::shafts_after(const SensorFrame & frame, double dt_s)
{
  const OdometryReading & o = frame.odometry;
  const linux_io::WheelValues turned =
    wheels_.to_wheels({o.vx_m_s, o.vy_m_s, o.wz_rad_s}, steering_rad_);
  for (std::size_t i = 0; i < kWheels; ++i) {
    shafts_.wheels[i].speed_rad_s = turned[i];
    shafts_.wheels[i].position_rad += turned[i] * dt_s;
  }
  for (std::size_t i = 0; i < kPair; ++i) {
    Shaft & shaft = shafts_.lifts[i];
    const double before_rad = shaft.position_rad;
    const double extension_m = frame.blocks[2 * i].height_m - frame.blocks[1].height_m;
    shaft.position_rad =
      linux_io::servo_rad(config_.lifts.joints[i], extension_m / config_.lifts.m_per_rad);
    shaft.speed_rad_s = (shaft.position_rad - before_rad) / dt_s;
  }
  return shafts_;
}

}  // namespace stetro_driver::emulator
