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

#ifndef STETRO_SUPERVISOR__SUPERVISOR_SETUP_HPP_
#define STETRO_SUPERVISOR__SUPERVISOR_SETUP_HPP_

#include <optional>

#include "stetro_config/fault.hpp"
#include "stetro_site/flight.hpp"
#include "stetro_site/robot.hpp"
#include "stetro_site/site.hpp"
#include "stetro_supervisor/supervisor_params.hpp"

namespace stetro_supervisor
{

/// What the supervisor's parameters, the site file and the robot file say together.
struct SupervisorSetup
{
  SupervisorParams params;     ///< with the speeds of the robot file
  stetro_site::Flight flight;  ///< that is present at first
  stetro_site::Robot robot;
  stetro_site::Site site;
};

/// Reads both files and chooses the flight, before anything of the middleware is made.
/**
 * A flight that is not named is the first of the site: a request names its own.
 *
 * \return nothing, and every fault of the files, of their fit, of the choice and of what cannot be
 *   climbed in `faults`; one that is there already, for another node read the same files, is not
 *   added again
 */
[[nodiscard]] std::optional<SupervisorSetup> read_setup(
  const SupervisorParams & params, stetro_config::Faults & faults);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__SUPERVISOR_SETUP_HPP_
