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

#include "linux/motion/wheel_odometry.hpp"

#include <algorithm>
#include <cmath>

#include "linux/servo/herkulex_registers.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kTurn = 6.28318530717958647692;
constexpr Time kWindow = std::chrono::milliseconds{100};
constexpr double kLowest = kRadPerCount * (kLowestCount - kCentreCount);
constexpr double kHighest = kRadPerCount * (kHighestCount - kCentreCount);

// The angle nearest to `near_rad` that lies in the gap of some turn.
double into_gap(double near_rad)
{
  const double turn = kTurn * std::floor((near_rad - kLowest) / kTurn);
  const double within = near_rad - turn;  // from the lowest reading, one turn on
  const double end = kLowest + kTurn;     // there the next turn's lowest reading is
  if (within >= kHighest) {
    return turn + std::min(within, end);
  }
  // Measurable, and yet it is in a gap: the one before or the one behind, whichever is nearer.
  return within - kLowest < kHighest - within ? turn + kLowest : turn + kHighest;
}

}  // namespace

void TurningAngle::measure(Time stamp, double position_rad, bool in_gap, double told_rad_s)
{
  if (count_ == 0) {
    angle_rad_ = position_rad;
  } else {
    const double dt_s = time_to_seconds(stamp - stamp_);
    const double before_rad = angle_rad_;
    if (in_gap) {
      angle_rad_ = into_gap(angle_rad_ + told_rad_s * dt_s);
    } else {
      const double expected = angle_rad_ + speed_rad_s() * dt_s;
      angle_rad_ = position_rad + kTurn * std::round((expected - position_rad) / kTurn);
    }
    if (dt_s > 0.0) {
      last_speed_rad_s_ = (angle_rad_ - before_rad) / dt_s;
    }
  }
  remember(stamp);
}

void TurningAngle::remember(Time stamp)
{
  stamp_ = stamp;
  samples_[count_ % kRemembered] = {stamp, angle_rad_};
  ++count_;
}

double TurningAngle::speed_rad_s() const
{
  if (count_ < 2) {
    return 0.0;
  }
  const Sample & newest = samples_[(count_ - 1) % kRemembered];
  Sample oldest = newest;
  for (std::size_t back = 2; back <= std::min(count_, kRemembered); ++back) {
    const Sample & sample = samples_[(count_ - back) % kRemembered];
    oldest = sample;
    if (newest.stamp - sample.stamp >= kWindow) {
      break;
    }
  }
  const double dt_s = time_to_seconds(newest.stamp - oldest.stamp);
  return dt_s > 0.0 ? (newest.angle_rad - oldest.angle_rad) / dt_s : 0.0;
}

void WheelOdometry::update(const std::array<WheelReading, kWheels> & wheels, double steering_rad)
{
  WheelValues turned{};
  WheelValues speeds{};
  Time stamp = reading_.stamp;
  for (std::size_t i = 0; i < kWheels; ++i) {
    if (!geometry_.exists(i)) {
      continue;
    }
    const WheelReading & wheel = wheels[i];
    const double before_rad = wheels_[i].angle_rad();
    wheels_[i].measure(wheel.stamp, wheel.position_rad, wheel.in_gap, wheel.told_rad_s);
    turned[i] = wheels_[i].angle_rad() - before_rad;
    speeds[i] = wheels_[i].last_speed_rad_s();
    stamp = std::max(stamp, wheel.stamp);
  }
  OdometryReading & o = reading_;
  o.stamp = stamp;
  if (!started_) {
    started_ = true;  // where the wheels stood at the start is no motion
    return;
  }
  const BodyTwist speed = geometry_.to_twist(speeds, steering_rad);
  o.vx_m_s = speed.vx_m_s;
  o.vy_m_s = speed.vy_m_s;
  o.wz_rad_s = speed.wz_rad_s;
  const BodyTwist moved = geometry_.to_twist(turned, steering_rad);
  const double middle_rad = o.yaw_rad + moved.wz_rad_s / 2.0;
  o.x_m += moved.vx_m_s * std::cos(middle_rad) - moved.vy_m_s * std::sin(middle_rad);
  o.y_m += moved.vx_m_s * std::sin(middle_rad) + moved.vy_m_s * std::cos(middle_rad);
  o.yaw_rad = std::remainder(o.yaw_rad + moved.wz_rad_s, kTurn);
  o.rolled_m += std::hypot(moved.vx_m_s, moved.vy_m_s);
  o.turned_rad += std::abs(moved.wz_rad_s);
}

}  // namespace stetro_driver::linux_io
