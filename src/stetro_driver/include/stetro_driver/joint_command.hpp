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

#ifndef STETRO_DRIVER__JOINT_COMMAND_HPP_
#define STETRO_DRIVER__JOINT_COMMAND_HPP_

#include <cstdint>

namespace stetro_driver
{

/// What the motors can be asked to do. One thing at a time.
enum class MotionKind : std::uint8_t {
  kHold,     ///< wheels stand still, every block stays where it is
  kStop,     ///< as kHold, and whatever was under way is given up
  kTwist,    ///< roll: vx, vy, wz
  kLift,     ///< lift `block` to its upper lock
  kLower,    ///< lower `block` until it stands
  kSteer,    ///< turn the wheels to `steering_rad`
  kUnknown,  ///< a kind we were asked for and do not know: always refused
};

/// One command to the motors. Fields that the kind does not name are zero.
/**
 * Velocities are those of base_link in base_link (x forward, y left, counter-clockwise positive).
 * vx needs the wheels at 0, vy and wz need them at pi/2.
 */
struct JointCommand
{
  MotionKind kind = MotionKind::kHold;
  double vx_m_s = 0.0;
  double vy_m_s = 0.0;
  double wz_rad_s = 0.0;
  int block = 0;              ///< 1 front, 2 middle, 3 rear, 0 none
  double steering_rad = 0.0;  ///< 0 rolls along x, pi/2 along y
};

[[nodiscard]] inline bool operator==(const JointCommand & a, const JointCommand & b)
{
  return a.kind == b.kind && a.vx_m_s == b.vx_m_s && a.vy_m_s == b.vy_m_s &&
         a.wz_rad_s == b.wz_rad_s && a.block == b.block && a.steering_rad == b.steering_rad;
}

[[nodiscard]] inline bool operator!=(const JointCommand & a, const JointCommand & b)
{
  return !(a == b);
}

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__JOINT_COMMAND_HPP_
