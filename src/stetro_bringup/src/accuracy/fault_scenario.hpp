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

#ifndef ACCURACY__FAULT_SCENARIO_HPP_
#define ACCURACY__FAULT_SCENARIO_HPP_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/fault_onset.hpp"

namespace stetro_bringup
{

/// The faults of one climb.
struct DrawnFaults
{
  std::string text;                 ///< as the simulator takes them
  std::optional<FaultOnset> onset;  ///< nothing for `steps`: it strikes again and again
};

/// What goes wrong in one scenario, drawn for one seed: which sensor, when, which way.
/**
 *   dead, stuck     any device: a range sensor, the gyroscope, a bumper or a riser switch
 *   spike           one reading in five of a side or front sensor is far off
 *   offset_jump     a side or front sensor reads 5 cm too long, or too short
 *   gain_change     one reads 10 % too long, or too short
 *   drifting        one creeps away by 2 mm a second
 *   late            one is late by half a second
 *   gyro_bias_jump  the gyroscope's bias changes by 0.02 rad/s
 *   no_side_ranges  both side sensors are dead
 *   steps           on every second tread or so a slip of 1 to 4 cm, a touch-down missed or doubled,
 *                   or block 2 back on the old tread
 *
 * One that begins once does so after the first tread and before the last quarter of the climb. A
 * scenario with an `@` in its name is the simulator's own text, and its first fault is the onset.
 */
[[nodiscard]] DrawnFaults draw_faults(const std::string & scenario, std::uint64_t seed, int steps);

/// Every scenario by name, in the order of the list above.
[[nodiscard]] const std::vector<std::string> & fault_scenarios();

/// The scenarios that a command line asks for: "all" stands for every one.
/** \throws std::invalid_argument naming one that does not exist, and those that do */
[[nodiscard]] std::vector<std::string> chosen_scenarios(const std::vector<std::string> & asked);

}  // namespace stetro_bringup

#endif  // ACCURACY__FAULT_SCENARIO_HPP_
