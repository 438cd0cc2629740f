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

#include "stetro_driver/driver_setup.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

#include "linux/devices_file.hpp"
#include "stetro_driver/sim_faults.hpp"
#include "stetro_driver/sim_robot.hpp"
#include "stetro_driver/site_shape.hpp"
#include "stetro_site/fit.hpp"

namespace stetro_driver
{
namespace
{

/// The flight that the parameters mean; null, and a fault, when there is none.
const stetro_site::Flight * find_flight(
  const stetro_site::Site & site, const std::string & id, stetro_config::Faults & faults)
{
  if (!id.empty()) {
    if (const auto * flight = site.find_flight(id)) {
      return flight;
    }
  } else if (site.flights().size() == 1 || site.has_drawn_floor()) {
    return &site.flights().front();
  }
  std::string accepted = "one of";
  for (const stetro_site::Flight & flight : site.flights()) {
    accepted += " " + flight.id();
  }
  faults.refuse("flight", id.empty() ? stetro_config::kMissing : id, accepted);
  return nullptr;
}

void check_start(const DriverSetup & setup, stetro_config::Faults & faults)
{
  try {
    SimRobot{building_of(setup), shape_of(setup.robot), sim_options(setup)};
  } catch (const std::invalid_argument & error) {
    std::string start;
    for (const double value : setup.params.sim.start) {
      start += (start.empty() ? "[" : ", ") + std::to_string(value);
    }
    faults.refuse(
      "sim.start", start.empty() ? "drawn" : start + "]",
      std::string("where there is room; ") + error.what());
  }
}

void check_floors_of_faults(const DriverSetup & setup, stetro_config::Faults & faults)
{
  std::string accepted = "one of";
  std::vector<std::string> drawn;
  for (const stetro_site::Floor & floor : setup.site.floors()) {
    if (!std::holds_alternative<std::monostate>(floor.drawing)) {
      drawn.push_back(floor.id);
      accepted += " " + floor.id;
    }
  }
  for (const SimFault & fault : sim_options(setup.params).faults) {
    const bool known = std::find(drawn.begin(), drawn.end(), fault.device) != drawn.end();
    if (fault.is_on_floor() && !known) {
      faults.refuse(
        "sim.faults", "kidnap:" + fault.device,
        drawn.empty() ? "no floor, as the site draws none" : accepted);
    }
  }
}

void check_kept_file(
  const std::string & name, const std::string & file, stetro_config::Faults & faults)
{
  if (file.empty()) {
    return;
  }
  std::error_code ignored;
  const auto directory = std::filesystem::absolute(file).parent_path();
  if (
    !std::filesystem::is_directory(directory, ignored) ||
    ::access(directory.c_str(), W_OK | X_OK) != 0 || std::filesystem::is_directory(file, ignored)) {
    faults.refuse(name, file, "a file in a directory that exists and is writable");
  }
}

}  // namespace

BuildingShape building_of(const DriverSetup & setup)
{
  return shape_of(setup.site, setup.flight_id);
}

SimOptions sim_options(const DriverSetup & setup)
{
  SimOptions options = sim_options(setup.params);
  options.lidar =
    options.lidar || (setup.params.sim.lidar == "auto" && setup.site.has_drawn_floor());
  return options;
}

void check(const DriverSetup & setup, stetro_config::Faults & faults)
{
  check_kept_file("blocks_file", setup.params.blocks_file, faults);
  if (setup.params.hardware != "sim") {
    static_cast<void>(linux_io::read_devices(setup.robot, faults));
  }
  if (setup.params.hardware == "linux") {
    return;  // nothing is simulated
  }
  check_start(setup, faults);
  check_floors_of_faults(setup, faults);
  check_kept_file("sim.snapshot_file", setup.params.sim.snapshot_file, faults);
}

std::optional<DriverSetup> read_setup(const DriverParams & params, stetro_config::Faults & faults)
{
  if (params.site_file.empty() || params.robot_file.empty()) {
    return std::nullopt;  // check(DriverParams) has said so
  }
  try {
    auto deployment = stetro_site::load_deployment(params.site_file, params.robot_file);
    const auto * flight = find_flight(deployment.site, params.flight, faults);
    if (flight == nullptr) {
      return std::nullopt;
    }
    DriverSetup setup{params, deployment.site, flight->id(), deployment.robot};
    if (faults.empty()) {  // else the parameters may contradict each other
      check(setup, faults);
    }
    return setup;
  } catch (const stetro_config::ConfigError & error) {
    for (const stetro_config::Fault & fault : error.faults()) {
      faults.add(fault);
    }
    return std::nullopt;
  }
}

}  // namespace stetro_driver
