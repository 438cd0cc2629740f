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

#ifndef STETRO_DRIVER__SIM_FAULTS_HPP_
#define STETRO_DRIVER__SIM_FAULTS_HPP_

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stetro_driver
{

/// What can be made to go wrong.
enum class SimFaultKind {
  kDead,             ///< the device does not answer
  kStuck,            ///< the device repeats what it said last
  kSpike,            ///< some of its readings are far off
  kLate,             ///< its readings arrive late
  kOffsetJump,       ///< its readings are too long by a constant from now on
  kGainChange,       ///< its readings are too long by a share from now on
  kDrift,            ///< its readings creep away, as behind dirt that gathers
  kBiasJump,         ///< the gyroscope's rate is too high by a constant from now on
  kSlip,             ///< the body slips, the wheels do not feel it
  kMissedTouchdown,  ///< the next touch-down shows no lower lock and no load
  kDoubleTouchdown,  ///< the next touch-down of block 2 shows twice
  kOldTread,         ///< block 2's next roll slips throughout, and block3_front says it arrived
  kKidnap,           ///< the robot is carried along its tread, or elsewhere on its floor
  kEmergencyStop,    ///< someone presses the button
};

/// One fault on demand.
struct SimFault
{
  SimFaultKind kind = SimFaultKind::kDead;
  std::string device;   ///< range sensor, switch, "gyro" or floor; empty when the kind has none
  double from_s = 0.0;  ///< since the simulation's start; driven on the floor, if there is one [s]
  double until_s = std::numeric_limits<double>::infinity();  ///< the same [s]
  double value = 0.0;                                        ///< what sim_faults_help() says

  /// Of a kidnap: the only floor on which it happens, and whose driving is its clock.
  [[nodiscard]] bool is_on_floor() const
  {
    return kind == SimFaultKind::kKidnap && !device.empty();
  }
};

/// Reads a list such as `dead:front_left@120, slip@60=0.02`.
/** \throws std::invalid_argument naming the fault that is not understood, and all that are */
[[nodiscard]] std::vector<SimFault> parse_sim_faults(std::string_view text);

/// The grammar and every fault, for people.
[[nodiscard]] std::string sim_faults_help();

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__SIM_FAULTS_HPP_
