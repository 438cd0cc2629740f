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

#ifndef STETRO_DRIVER__PARAMS_HPP_
#define STETRO_DRIVER__PARAMS_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "stetro_config/fault.hpp"
#include "stetro_config/field.hpp"
#include "stetro_config/rule.hpp"
#include "stetro_driver/command_gate.hpp"
#include "stetro_driver/pacer.hpp"
#include "stetro_driver/realtime.hpp"
#include "stetro_driver/sim_errors.hpp"
#include "stetro_driver/sim_robot.hpp"

namespace stetro_driver
{

/// Which commands the driver takes; see GateLimits.
struct CommandParams
{
  double max_vx_m_s = 0.30;
  double max_vy_m_s = 0.30;
  double max_wz_rad_s = 0.50;
  double max_valid_for_s = 0.20;
  double max_skew_s = 0.02;
};

/// The simulated robot and its world.
struct SimParams
{
  std::int64_t seed = 1;
  std::string world = "as-built";
  std::string faults;
  std::string snapshot_file;
  std::vector<double> start;  ///< x, y [m] and yaw [rad] in the frame of `flight`; empty: drawn
  double speed = 1.0;
  bool throttle = true;
  bool ground_truth = true;
  std::string lidar = "auto";
  std::int64_t people = 0;
  std::int64_t unmapped_boxes = 0;
  SimErrors errors;
};

/// The control loop of a robot whose time passes by itself.
struct LoopParams
{
  double rate_hz = 100.0;
  linux_io::RealtimeConfig realtime;
};

/// Everything the driver lets a person set. Defaults climb the papers' staircase.
struct DriverParams
{
  std::string hardware = "sim";
  std::string site_file;
  std::string robot_file;
  std::string flight;
  bool start_active = true;
  bool range_topics = false;
  std::string blocks_file;
  LoopParams loop;
  CommandParams command;
  SimParams sim;
};

template <class Visitor>
void visit(CommandParams & p, Visitor && each)
{
  using stetro_config::Within;
  each("max_vx_m_s", p.max_vx_m_s, Within{0.01, 1.0}, "fastest along x, either way [m/s]");
  each("max_vy_m_s", p.max_vy_m_s, Within{0.01, 1.0}, "fastest along y, either way [m/s]");
  each("max_wz_rad_s", p.max_wz_rad_s, Within{0.01, 2.0}, "fastest turn, either way [rad/s]");
  each("max_valid_for_s", p.max_valid_for_s, Within{0.02, 0.2}, "longest life of a command [s]");
  each("max_skew_s", p.max_skew_s, Within{0.0, 0.1}, "a stamp may lie so far ahead [s]");
}

template <class Visitor>
void visit(SimParams & p, Visitor && each)
{
  using stetro_config::Any;
  using stetro_config::Group;
  using stetro_config::OneOf;
  using stetro_config::Within;
  each("seed", p.seed, Within{0, 1e15}, "of the world, the devices and the start");
  each(
    "world", p.world, OneOf{"as-built", "site"},
    "the stairs differ from the site file as built, or not");
  each("faults", p.faults, Any{}, "faults on demand, such as dead:front_left@120; see --help");
  each("snapshot_file", p.snapshot_file, Any{}, "the world goes on from it; empty: no snapshot");
  each(
    "start", p.start, stetro_config::Each{Within{-10.0, 100.0}, 0, 3},
    "x, y [m], yaw [rad] in the flight's frame; empty: drawn, 0.5 m before the stairs");
  each(
    "speed", p.speed, Within{0.1, 1000.0}, "simulated seconds in a second, emulated devices too");
  each("throttle", p.throttle, Any{}, "wait for localizer and supervisor when they fall behind");
  each("ground_truth", p.ground_truth, Any{}, "publish what is really so");
  each(
    "lidar", p.lidar, OneOf{"auto", "on", "off"},
    "simulate and publish its scans; auto: if the site has a floor with a drawing");
  each("people", p.people, Within{0, 100}, "walking on each drawn floor, seen by the lidar only");
  each(
    "unmapped_boxes", p.unmapped_boxes, Within{0, 100},
    "on each drawn floor, seen by the lidar only");
  visit(p.errors, Group{"errors", each});
}

template <class Visitor>
void visit(LoopParams & p, Visitor && each)
{
  each(
    "rate_hz", p.rate_hz, stetro_config::Within{20.0, 500.0},
    "cycles a second of the loop around real or emulated devices");
  visit(p.realtime, each);
}

/// The one list: it loads, bounds, prints and documents the parameters.
template <class Visitor>
void visit(DriverParams & p, Visitor && each)
{
  using stetro_config::Any;
  using stetro_config::Group;
  each(
    "hardware", p.hardware, stetro_config::OneOf{"sim", "linux", "emulated"},
    "simulated; the real one's devices; or these, emulated in the simulated world");
  each("site_file", p.site_file, Any{}, "the building, must be given");
  each("robot_file", p.robot_file, Any{}, "the robot, must be given");
  each(
    "flight", p.flight, Any{},
    "id of the flight to start at; empty: the only one, or the first if floors are drawn");
  each(
    "start_active", p.start_active, Any{}, "power the motors at the start, standing and holding");
  each("range_topics", p.range_topics, Any{}, "publish range/<sensor> too, for RViz");
  each(
    "blocks_file", p.blocks_file, Any{},
    "keeps which blocks stand, for a restart in mid-climb; empty: no file");
  visit(p.loop, Group{"loop", each});
  visit(p.command, Group{"command", each});
  visit(p.sim, Group{"sim", each});
}

/// What contradicts each other although each value is in its bounds.
void check(const DriverParams & params, stetro_config::Faults & faults);

/// As the gate, the pacer and the simulation take them.
[[nodiscard]] GateLimits gate_limits(const DriverParams & params);
[[nodiscard]] PacerLimits pacer_limits(const DriverParams & params);
/// Without the site, `sim.lidar: auto` is off.
[[nodiscard]] SimOptions sim_options(const DriverParams & params);

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__PARAMS_HPP_
