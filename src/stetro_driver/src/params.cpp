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

#include "stetro_driver/params.hpp"

#include <stdexcept>

#include "stetro_driver/sim_faults.hpp"

namespace stetro_driver
{

void check(const DriverParams & params, stetro_config::Faults & faults)
{
  if (params.site_file.empty()) {
    faults.refuse("site_file", stetro_config::kMissing, "the path of a site file");
  }
  if (params.robot_file.empty()) {
    faults.refuse("robot_file", stetro_config::kMissing, "the path of a robot file");
  }
  if (!params.sim.start.empty() && params.sim.start.size() != 3) {
    faults.refuse(
      "sim.start", std::to_string(params.sim.start.size()) + " numbers", "none, or x, y and yaw");
  }
  if (params.sim.errors.slip_min_m > params.sim.errors.slip_max_m) {
    faults.refuse(
      "sim.errors.slip_min_m", std::to_string(params.sim.errors.slip_min_m),
      "at most sim.errors.slip_max_m");
  }
  if (params.hardware == "emulated") {
    if (params.sim.speed < 1.0) {
      faults.refuse(
        "sim.speed", std::to_string(params.sim.speed), "1 or more: devices are emulated");
    }
    if (!params.sim.snapshot_file.empty()) {
      faults.refuse(
        "sim.snapshot_file", params.sim.snapshot_file, "empty: emulated devices cannot be resumed");
    }
  }
  if (params.hardware == "sim" && !params.blocks_file.empty()) {
    faults.refuse(
      "blocks_file", params.blocks_file, "empty: a simulated robot has sim.snapshot_file");
  }
  try {
    static_cast<void>(parse_sim_faults(params.sim.faults));
  } catch (const std::invalid_argument & error) {
    faults.refuse("sim.faults", params.sim.faults, error.what());
  }
}

GateLimits gate_limits(const DriverParams & params)
{
  GateLimits limits;
  limits.max_vx_m_s = params.command.max_vx_m_s;
  limits.max_vy_m_s = params.command.max_vy_m_s;
  limits.max_wz_rad_s = params.command.max_wz_rad_s;
  limits.max_valid_for = seconds_to_time(params.command.max_valid_for_s);
  limits.max_skew = seconds_to_time(params.command.max_skew_s);
  return limits;
}

PacerLimits pacer_limits(const DriverParams & params)
{
  PacerLimits limits;
  limits.speed = params.sim.speed;
  limits.throttle = params.sim.throttle;
  return limits;
}

SimOptions sim_options(const DriverParams & params)
{
  SimOptions options;
  options.seed = static_cast<std::uint64_t>(params.sim.seed);
  options.as_built = params.sim.world == "as-built";
  options.errors = params.sim.errors;
  options.faults = parse_sim_faults(params.sim.faults);
  options.lidar = params.sim.lidar == "on";
  options.people = static_cast<int>(params.sim.people);
  options.unmapped_boxes = static_cast<int>(params.sim.unmapped_boxes);
  options.snapshot_path = params.sim.snapshot_file;
  if (params.sim.start.size() == 3) {
    options.start = SimStart{params.sim.start[0], params.sim.start[1], params.sim.start[2]};
  }
  return options;
}

}  // namespace stetro_driver
