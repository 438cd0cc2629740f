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

#include "stetro_supervisor/supervisor_setup.hpp"

#include <algorithm>
#include <string>

#include "stetro_site/fit.hpp"
#include "stetro_supervisor/climb_geometry.hpp"

namespace stetro_supervisor
{
namespace
{

/// The speeds stand in the robot file, for every component.
void take_speeds(ClimbParams & params, const stetro_site::Speeds & speeds)
{
  params.sweep_speed_mps = speeds.sweep_m_s;
  params.roll_speed_mps = speeds.roll_m_s;
  params.creep_speed_mps = speeds.creep_m_s;
  params.yaw_rate_rps = speeds.yaw_correction_rad_s;
}

/// The flight that the parameters mean; null, and a fault, when there is none.
const stetro_site::Flight * chosen_flight(
  const std::string & id, const stetro_site::Site & site, stetro_config::Faults & faults)
{
  if (id.empty() && !site.flights().empty()) {
    return &site.flights().front();
  }
  if (const auto * flight = site.find_flight(id)) {
    return flight;
  }
  std::string known;
  for (const auto & flight : site.flights()) {
    known += (known.empty() ? "" : ", ") + flight.id();
  }
  faults.refuse("flight", id, "the id of a flight of the site: " + known);
  return nullptr;
}

void add_unless_known(const stetro_config::Fault & fault, stetro_config::Faults & faults)
{
  const std::string text = to_string(fault);
  const bool known = std::any_of(
    faults.begin(), faults.end(),
    [&](const stetro_config::Fault & other) { return to_string(other) == text; });
  if (!known) {
    faults.add(fault);
  }
}

std::optional<SupervisorSetup> choose(
  const SupervisorParams & params, const stetro_site::Deployment & deployment,
  stetro_config::Faults & faults)
{
  const auto * flight = chosen_flight(params.flight, deployment.site, faults);
  if (flight == nullptr) {
    return std::nullopt;
  }
  SupervisorSetup setup{params, *flight, deployment.robot, deployment.site};
  take_speeds(setup.params.climb, deployment.robot.speeds);
  for (const stetro_site::Flight & each : deployment.site.flights()) {
    stetro_config::Faults own;
    check_climbable(make_geometry(each, deployment.robot.geometry), setup.params.climb, own);
    for (const stetro_config::Fault & fault : own) {
      add_unless_known(fault, faults);
    }
  }
  return setup;
}

}  // namespace

std::optional<SupervisorSetup> read_setup(
  const SupervisorParams & params, stetro_config::Faults & faults)
{
  stetro_config::Faults own;
  std::optional<SupervisorSetup> setup;
  if (params.site_file.empty() || params.robot_file.empty()) {
    return std::nullopt;  // the bounds of the parameters have said so
  }
  try {
    const auto deployment = stetro_site::load_deployment(params.site_file, params.robot_file);
    setup = choose(params, deployment, own);
  } catch (const stetro_config::ConfigError & error) {
    for (const stetro_config::Fault & fault : error.faults()) {
      own.add(fault);
    }
  }
  for (const stetro_config::Fault & fault : own) {
    add_unless_known(fault, faults);
  }
  return own.empty() ? setup : std::nullopt;
}

}  // namespace stetro_supervisor
