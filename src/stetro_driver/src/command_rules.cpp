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

#include "command_rules.hpp"

#include <cmath>
#include <string>

namespace stetro_driver
{
namespace
{

constexpr double kHalfPi = 1.57079632679489661923;
constexpr double kAligned = 0.03;  // wheels nearer than this stand in a direction [rad]

}  // namespace

std::optional<IoFault> nonsense_in(const JointCommand & command)
{
  if (command.kind >= MotionKind::kUnknown) {
    return IoFault{IoFaultKind::kBadCommand, "unknown kind of motion"};
  }
  const double sum = command.vx_m_s + command.vy_m_s + command.wz_rad_s + command.steering_rad;
  if (!std::isfinite(sum)) {
    return IoFault{IoFaultKind::kBadCommand, "a speed or an angle is NaN or infinite"};
  }
  const bool lifts = command.kind == MotionKind::kLift || command.kind == MotionKind::kLower;
  if (lifts && (command.block < 1 || command.block > 3)) {
    return IoFault{IoFaultKind::kBadCommand, "block " + std::to_string(command.block)};
  }
  return std::nullopt;
}

std::optional<IoFault> wheels_refuse(const JointCommand & command, double steering_rad)
{
  if (command.kind != MotionKind::kTwist) {
    return std::nullopt;
  }
  const bool along_x = command.vx_m_s != 0.0;
  const bool along_y = command.vy_m_s != 0.0 || command.wz_rad_s != 0.0;
  if (along_x && std::abs(steering_rad) > kAligned) {
    return IoFault{IoFaultKind::kWrongSteering, "vx needs the wheels at 0"};
  }
  if (along_y && std::abs(steering_rad - kHalfPi) > kAligned) {
    return IoFault{IoFaultKind::kWrongSteering, "vy and wz need the wheels at pi/2"};
  }
  return std::nullopt;
}

}  // namespace stetro_driver
