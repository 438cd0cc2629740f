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

#include "stetro_site/fit.hpp"

#include <cstddef>
#include <utility>

#include "metres.hpp"

namespace stetro_site
{
namespace
{

using stetro_config::Faults;

constexpr double kRounding = 1e-9;  // [m]

/// Holds one flight against the robot.
class FlightFit
{
public:
  FlightFit(const Site & site, std::size_t i, Faults & faults)
  : site_(site), path_("flights[" + std::to_string(i) + "]."), faults_(faults)
  {
  }

  void check_width(const Flight & flight, const RobotGeometry & robot)
  {
    if (flight.narrowest_m() <= robot.contact_width_m) {
      refuse(
        "width_m", flight.narrowest_m(),
        "more than " + metres(robot.contact_width_m) + ", the robot's contact width");
    }
    const double reach_m = 2.0 * robot.range_sensor.reliable_range_m + robot.side_separation_m();
    if (flight.widest_m() > reach_m + kRounding) {
      refuse(
        "width_m", flight.widest_m(),
        "at most " + metres(reach_m) + " = 2 x " + metres(robot.range_sensor.reliable_range_m) +
          " reliable range + " + metres(robot.side_separation_m()) + " between the side sensors");
    }
  }

  void check_steps(const Flight & flight, const RobotGeometry & robot)
  {
    const double highest_m = robot.stroke_m - robot.stroke_margin_m;
    if (flight.highest_riser_m() > highest_m + kRounding) {
      refuse(
        "riser_m", flight.highest_riser_m(),
        "at most " + metres(highest_m) + " = " + metres(robot.stroke_m) + " stroke - " +
          metres(robot.stroke_margin_m) + " margin, on every step");
    }
    const double two_blocks_m = 2.0 * robot.block_length_m;
    if (flight.shortest_tread_m() < two_blocks_m - kRounding) {
      refuse(
        "tread_m", flight.shortest_tread_m(),
        "at least " + metres(two_blocks_m) + " = 2 blocks of " + metres(robot.block_length_m) +
          ", on every step");
    }
  }

private:
  void refuse(const char * key, double value_m, std::string accepted)
  {
    const auto at = site_.origin(path_ + key);
    faults_.add({at.file, at.line, path_ + key, metres(value_m), std::move(accepted)});
  }

  const Site & site_;
  std::string path_;
  Faults & faults_;
};

}  // namespace

Faults check_fit(const Site & site, const RobotGeometry & robot)
{
  Faults faults;
  check(robot, faults);
  for (std::size_t i = 0; i < site.flights().size(); ++i) {
    FlightFit fit{site, i, faults};
    fit.check_width(site.flights()[i], robot);
    fit.check_steps(site.flights()[i], robot);
  }
  return faults;
}

Deployment load_deployment(const std::string & site_path, const std::string & robot_path)
{
  Faults faults;
  auto site = read_site(site_path, faults);
  auto robot = read_robot(robot_path, faults);
  if (site && robot) {
    for (const auto & fault : check_fit(*site, robot->geometry)) {
      faults.add(fault);
    }
  }
  faults.throw_if_any();
  return {std::move(site).value(), std::move(robot).value()};
}

}  // namespace stetro_site
