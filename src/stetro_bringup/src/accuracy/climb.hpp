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

#ifndef ACCURACY__CLIMB_HPP_
#define ACCURACY__CLIMB_HPP_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/climb_score.hpp"
#include "accuracy/fault_onset.hpp"
#include "accuracy/robot_setup.hpp"

namespace stetro_bringup
{

/// One climb to be made.
struct ClimbOrder
{
  std::uint64_t seed = 1;
  std::size_t scenario = 0;                      ///< number of the scenario it belongs to
  std::string world = "as-built";                ///< or "site"
  std::string calibration = "factory";           ///< or "none"
  std::string faults;                            ///< as the simulator takes them
  std::optional<FaultOnset> onset;               ///< of the one fault whose detection is timed
  std::vector<std::string> estimators{"paper"};  ///< the first drives
};

/// Climbs from the floor to the end, whatever that is, and scores every estimator.
/** \throws std::invalid_argument for an estimator or a fault that does not exist */
[[nodiscard]] ClimbRecord climb(const RobotSetup & setup, const ClimbOrder & order);

}  // namespace stetro_bringup

#endif  // ACCURACY__CLIMB_HPP_
