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

#ifndef STETRO_DRIVER__DRIVER_SETUP_HPP_
#define STETRO_DRIVER__DRIVER_SETUP_HPP_

#include <optional>
#include <string>

#include "stetro_config/fault.hpp"
#include "stetro_driver/building_shape.hpp"
#include "stetro_driver/params.hpp"
#include "stetro_site/flight.hpp"
#include "stetro_site/robot.hpp"
#include "stetro_site/site.hpp"

namespace stetro_driver
{

/// Everything that a driver is made of, read and found to fit together.
struct DriverSetup
{
  DriverParams params;
  stetro_site::Site site;
  std::string flight_id;  ///< of the one at which the simulated robot starts
  stetro_site::Robot robot;

  [[nodiscard]] const stetro_site::Flight & flight() const { return site.flight(flight_id); }
};

/// The simulated robot's building, and how it is simulated: `sim.lidar: auto` is decided here.
[[nodiscard]] BuildingShape building_of(const DriverSetup & setup);
[[nodiscard]] SimOptions sim_options(const DriverSetup & setup);

/// Reads the site and robot files that the parameters name. Nothing if a fault was added.
[[nodiscard]] std::optional<DriverSetup> read_setup(
  const DriverParams & params, stetro_config::Faults & faults);

/// What cannot be: a start inside a wall, a snapshot in a directory that is not there.
void check(const DriverSetup & setup, stetro_config::Faults & faults);

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__DRIVER_SETUP_HPP_
