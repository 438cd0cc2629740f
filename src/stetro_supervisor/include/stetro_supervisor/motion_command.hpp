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

#ifndef STETRO_SUPERVISOR__MOTION_COMMAND_HPP_
#define STETRO_SUPERVISOR__MOTION_COMMAND_HPP_

#include <cstdint>

namespace stetro_supervisor
{

/// What the robot shall do until the next tick. In body axes: which wheels turn is the driver's
/// knowledge alone (D3-11).
struct MotionCommand
{
  enum class Kind : std::uint8_t {
    kNone,   ///< nothing is commanded: the lease on the driver is left free
    kTwist,  ///< vx, vy, wz
    kLift,   ///< block, to its upper lock
    kLower,  ///< block, until it stands
    kSteer,  ///< wheels to steering_rad
    kHold,   ///< stand still, keep the blocks where they are
    kStop    ///< stop every motion at once
  };

  Kind kind = Kind::kHold;
  double vx_mps = 0.0;        ///< up the stairs [m/s]; needs the wheels at 0
  double vy_mps = 0.0;        ///< to the left [m/s]; needs the wheels at pi/2
  double wz_rps = 0.0;        ///< counter-clockwise [rad/s]; needs the wheels at pi/2
  int block = 0;              ///< 1 front, 2 middle, 3 rear; 0 none
  double steering_rad = 0.0;  ///< 0 rolls along x, pi/2 along y

  /// Whether the robot would move its wheels or a block.
  bool moves() const
  {
    return kind == Kind::kTwist || kind == Kind::kLift || kind == Kind::kLower ||
           kind == Kind::kSteer;
  }
};

inline MotionCommand roll(double vx_mps)
{
  MotionCommand command;
  command.kind = MotionCommand::Kind::kTwist;
  command.vx_mps = vx_mps;
  return command;
}

inline MotionCommand traverse(double vy_mps, double wz_rps)
{
  MotionCommand command;
  command.kind = MotionCommand::Kind::kTwist;
  command.vy_mps = vy_mps;
  command.wz_rps = wz_rps;
  return command;
}

inline MotionCommand lift(int block)
{
  MotionCommand command;
  command.kind = MotionCommand::Kind::kLift;
  command.block = block;
  return command;
}

inline MotionCommand lower(int block)
{
  MotionCommand command;
  command.kind = MotionCommand::Kind::kLower;
  command.block = block;
  return command;
}

inline MotionCommand steer(double steering_rad)
{
  MotionCommand command;
  command.kind = MotionCommand::Kind::kSteer;
  command.steering_rad = steering_rad;
  return command;
}

inline MotionCommand hold() { return MotionCommand{}; }

inline MotionCommand stop()
{
  MotionCommand command;
  command.kind = MotionCommand::Kind::kStop;
  return command;
}

inline MotionCommand nothing()
{
  MotionCommand command;
  command.kind = MotionCommand::Kind::kNone;
  return command;
}

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__MOTION_COMMAND_HPP_
