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

#include "stetro_localizer/localizer_setup.hpp"

#include <algorithm>
#include <string>

#include "stetro_site/fit.hpp"

namespace stetro_localizer
{
namespace
{

void add_once(const stetro_config::Fault & fault, stetro_config::Faults & faults)
{
  const std::string text = stetro_config::to_string(fault);
  const bool known = std::any_of(faults.begin(), faults.end(), [&text](const auto & other) {
    return stetro_config::to_string(other) == text;
  });
  if (!known) {
    faults.add(fault);
  }
}

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
  add_once({"", 0, "flight", id.empty() ? stetro_config::kMissing : id, accepted}, faults);
  return nullptr;
}

/// Whether the robot can begin on that segment; false adds a fault.
bool has_segment(
  const stetro_site::Site & site, const std::string & id, stetro_config::Faults & faults)
{
  const stetro_site::Floor * floor = site.find_floor(id);
  const bool on_floor = floor != nullptr && floor->is_drawn();
  if (id.empty() || site.find_flight(id) != nullptr || on_floor) {
    return true;
  }
  std::string accepted = "empty, or one of";
  for (const stetro_site::Flight & flight : site.flights()) {
    accepted += " " + flight.id();
  }
  for (const stetro_site::Floor & one : site.floors()) {
    accepted += one.is_drawn() ? " " + one.id : "";
  }
  add_once({"", 0, "initial_segment", id, accepted}, faults);
  return false;
}

}  // namespace

std::optional<LocalizerSetup> read_setup(
  const LocalizerParams & params, stetro_config::Faults & faults)
{
  if (params.site_file.empty() || params.robot_file.empty()) {
    return std::nullopt;  // the parameters' own bounds have said so
  }
  try {
    auto deployment = stetro_site::load_deployment(params.site_file, params.robot_file);
    const bool begins = deployment.site.has_drawn_floor() &&
                        deployment.site.find_flight(params.initial_segment) != nullptr;
    const auto * flight =
      find_flight(deployment.site, begins ? params.initial_segment : params.flight, faults);
    if (flight == nullptr || !has_segment(deployment.site, params.initial_segment, faults)) {
      return std::nullopt;
    }
    if (params.initial_step > flight->steps()) {
      faults.refuse(
        "initial_step", std::to_string(params.initial_step),
        "-1 to " + std::to_string(flight->steps()) + ", the steps of flight " + flight->id());
      return std::nullopt;
    }
    return LocalizerSetup{params, deployment.site, *flight, deployment.robot.geometry};
  } catch (const stetro_config::ConfigError & error) {
    for (const stetro_config::Fault & fault : error.faults()) {
      add_once(fault, faults);
    }
    return std::nullopt;
  }
}

}  // namespace stetro_localizer
