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

#ifndef PILOT_HPP_
#define PILOT_HPP_

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "stetro_driver/sim_robot.hpp"

namespace stetro_driver::test
{

constexpr double kHalfPi = 1.57079632679489661923;

/// The papers' stairs: riser 0.14, tread 0.32, width 2.05 m.
inline StairShape paper_stairs(int steps = 16)
{
  StairShape stairs;
  stairs.riser_m.assign(static_cast<std::size_t>(steps), 0.14);
  stairs.tread_m.assign(static_cast<std::size_t>(steps), 0.32);
  stairs.width_foot_m = 2.05;
  stairs.width_top_m = 2.05;
  return stairs;
}

/// A perfect robot on perfect stairs, in the middle of the floor, squarely before the first riser.
inline SimOptions perfect()
{
  SimOptions options;
  options.as_built = false;
  options.errors = no_errors();
  options.start = SimStart{-0.5, 1.025, 0.0};
  return options;
}

/// Drives a simulated robot open loop: one motion at a time, until something is so.
class Pilot
{
public:
  explicit Pilot(SimRobot & robot) : robot_(&robot)
  {
    robot_->configure();
    robot_->activate();
  }

  [[nodiscard]] SensorFrame frame() const { return robot_->read(robot_->time()).value(); }

  /// Repeats a command until `done(frame)`, at most for `limit_s`. \return whether it came true
  template <class Done>
  bool until(const JointCommand & command, double limit_s, Done && done)
  {
    for (int tick = 0; tick < static_cast<int>(limit_s * 100.0); ++tick) {
      if (done(frame())) {
        return true;
      }
      if (robot_->write(command)) {
        return false;
      }
      robot_->step();
    }
    return done(frame());
  }

  void during(const JointCommand & command, double seconds)
  {
    until(command, seconds, [](const SensorFrame &) { return false; });
  }

  void roll(double vx_m_s, double seconds) { during(twist(vx_m_s, 0.0, 0.0), seconds); }

  void steer(double angle_rad)
  {
    JointCommand command;
    command.kind = MotionKind::kSteer;
    command.steering_rad = angle_rad;
    EXPECT_TRUE(until(command, 3.0, [&](const SensorFrame & f) {
      return std::abs(f.steering.angle_rad - angle_rad) < 1e-9;
    }));
  }

  bool lift(int block)
  {
    return until(vertical(MotionKind::kLift, block), 5.0, [&](const SensorFrame & f) {
      return f.block(block).at_upper_lock;
    });
  }

  bool lower(int block)
  {
    return until(vertical(MotionKind::kLower, block), 5.0, [&](const SensorFrame & f) {
      return f.block(block).at_lower_lock;
    });
  }

  static JointCommand twist(double vx_m_s, double vy_m_s, double wz_rad_s)
  {
    JointCommand command;
    command.kind = MotionKind::kTwist;
    command.vx_m_s = vx_m_s;
    command.vy_m_s = vy_m_s;
    command.wz_rad_s = wz_rad_s;
    return command;
  }

  static JointCommand vertical(MotionKind kind, int block)
  {
    JointCommand command;
    command.kind = kind;
    command.block = block;
    return command;
  }

private:
  SimRobot * robot_;
};

}  // namespace stetro_driver::test

#endif  // PILOT_HPP_
