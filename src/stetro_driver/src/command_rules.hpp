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

#ifndef COMMAND_RULES_HPP_
#define COMMAND_RULES_HPP_

#include <optional>

#include "stetro_driver/joint_command.hpp"
#include "stetro_driver/result.hpp"

namespace stetro_driver
{

/// What no hardware can carry out: an unknown motion, a number that is none, a block there is not.
[[nodiscard]] std::optional<IoFault> nonsense_in(const JointCommand & command);

/// A roll across the wheels. \param steering_rad where they point: 0 along x, pi/2 along y
[[nodiscard]] std::optional<IoFault> wheels_refuse(
  const JointCommand & command, double steering_rad);

}  // namespace stetro_driver

#endif  // COMMAND_RULES_HPP_
