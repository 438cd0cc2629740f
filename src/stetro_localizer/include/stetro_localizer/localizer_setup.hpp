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

#ifndef STETRO_LOCALIZER__LOCALIZER_SETUP_HPP_
#define STETRO_LOCALIZER__LOCALIZER_SETUP_HPP_

#include <optional>

#include "stetro_config/fault.hpp"
#include "stetro_localizer/params.hpp"
#include "stetro_site/flight.hpp"
#include "stetro_site/robot_geometry.hpp"
#include "stetro_site/site.hpp"

namespace stetro_localizer
{

/// Everything that a localizer is made of, read and found to fit together.
struct LocalizerSetup
{
  LocalizerParams params;
  stetro_site::Site site;
  stetro_site::Flight flight;  ///< the one that the robot is on, or comes to first
  stetro_site::RobotGeometry robot;
};

/// Reads the site and robot files that the parameters name. Nothing if a fault was found.
/**
 * A fault that is among `faults` already is not added again: two nodes of one process may name the
 * same files. The initial step must be one of the flight, and
 * the initial segment one of the site.
 */
[[nodiscard]] std::optional<LocalizerSetup> read_setup(
  const LocalizerParams & params, stetro_config::Faults & faults);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__LOCALIZER_SETUP_HPP_
