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
#ifndef STETRO_SUPERVISOR__SUPERVISOR_PARAMS_HPP_
#define STETRO_SUPERVISOR__SUPERVISOR_PARAMS_HPP_

#include <string>

#include "stetro_supervisor/climb_params.hpp"
#include "stetro_supervisor/floor/floor_params.hpp"

namespace stetro_supervisor
{

/// Everything the supervisor lets a person set. The speeds stand in the robot file.
struct SupervisorParams
{
  std::string site_file;
  std::string robot_file;
  std::string flight;         ///< id; empty: the only one of the site, or the first
  std::string state_file;     ///< keeps the mission across a restart; empty: nowhere
  double rate_hz = 20.0;      ///< ticks and commands
  double valid_for_s = 0.15;  ///< life of a command
  double future_tolerance_s = 0.02;
  double max_sample_age_s = 0.3;
  double request_tolerance_s = 5.0;
  std::string fleet = "stetro";
  ClimbParams climb;
  FloorParams floor;
};

template <class Visitor>
void visit(SupervisorParams & p, Visitor && each)
{
  using stetro_config::Any;
  using stetro_config::NonEmpty;
  using stetro_config::Within;
  each("site_file", p.site_file, NonEmpty{}, "flights and floors of the building");
  each("robot_file", p.robot_file, NonEmpty{}, "body, sensors and speeds");
  each(
    "flight", p.flight, Any{},
    "id of the flight that is present at first; empty: the first of the site");
  each("state_file", p.state_file, Any{}, "keeps the mission; empty: nothing is kept");
  each("rate_hz", p.rate_hz, Within{5.0, 100.0}, "ticks and commands [Hz]");
  each("valid_for_s", p.valid_for_s, Within{0.02, 0.2}, "life of a command [s]");
  each(
    "future_tolerance_s", p.future_tolerance_s, Within{0.0, 1.0},
    "how far ahead of the clock a stamp may be [s]");
  each(
    "max_sample_age_s", p.max_sample_age_s, Within{0.01, 10.0},
    "older samples of the driver are refused [s]");
  each(
    "request_tolerance_s", p.request_tolerance_s, Within{0.1, 3600.0},
    "how far a request's stamp may be from the clock, unless time is simulated [s]");
  each("fleet", p.fleet, NonEmpty{}, "name of the fleet in /fleet_states");
  visit(p.climb, each);
  visit(p.floor, each);
}

/// Refuses parameters that contradict each other.
inline void check(const SupervisorParams & p, stetro_config::Faults & faults)
{
  if (!(p.valid_for_s * p.rate_hz > 1.0)) {
    faults.refuse(
      "valid_for_s", std::to_string(p.valid_for_s),
      "more than one period, " + std::to_string(1.0 / p.rate_hz) + " s");
  }
  check(p.climb, faults);
  check(p.floor, faults);
}

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__SUPERVISOR_PARAMS_HPP_
