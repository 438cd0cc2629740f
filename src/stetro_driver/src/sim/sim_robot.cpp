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

#include "stetro_driver/sim_robot.hpp"

#include <cassert>
#include <string>

#include "command_rules.hpp"
#include "sim/sim_world.hpp"

namespace stetro_driver
{

SimRobot::SimRobot(
  const BuildingShape & building, const BodyShape & body, const SimOptions & options)
: world_(std::make_unique<World>(building, body, options))
{
}

SimRobot::SimRobot(const StairShape & stairs, const BodyShape & body, const SimOptions & options)
: SimRobot(building_of(stairs), body, options)
{
}

SimRobot::~SimRobot() = default;

void SimRobot::configure()
{
  if (world_->configured) {
    return;
  }
  world_->open_snapshot();
  world_->configured = true;
}

void SimRobot::activate()
{
  if (!world_->configured) {
    throw HardwareError("the simulated robot is not configured");
  }
  if (world_->body.fall() != sim::Fall::kNone) {
    throw HardwareError(
      "the simulated robot has fallen: " + std::string(to_string(world_->body.fall())));
  }
  if (world_->contacts.emergency_stop_latched()) {
    throw HardwareError("the emergency stop is latched, accepted: after its reset");
  }
  world_->hold();
  world_->safe = false;
  world_->active = true;
}

void SimRobot::deactivate()
{
  world_->hold();
  world_->active = false;
}

void SimRobot::reset_emergency_stop()
{
  if (!world_->contacts.reset_emergency_stop()) {
    throw HardwareError("the emergency stop is pressed, accepted: after its release");
  }
  world_->hold();
  world_->frame.emergency_stop_latched = false;
}

Result<SensorFrame> SimRobot::read(Time now)
{
  if (!world_->configured) {
    return IoFault{IoFaultKind::kNotConfigured, "the simulated robot is not configured"};
  }
  if (now != world_->time) {
    return IoFault{
      IoFaultKind::kTime, "asked for " + std::to_string(time_to_seconds(now)) +
                            " s, simulated time is " +
                            std::to_string(time_to_seconds(world_->time)) + " s"};
  }
  return world_->frame;
}

std::optional<IoFault> SimRobot::write(const JointCommand & command)
{
  world_->hold();
  if (!world_->active || world_->safe.load()) {
    return IoFault{IoFaultKind::kNotActive, "the motors have no power"};
  }
  if (world_->contacts.emergency_stop_latched()) {
    return IoFault{IoFaultKind::kEmergencyStop, "the emergency stop is latched"};
  }
  if (world_->body.fall() != sim::Fall::kNone) {
    return IoFault{IoFaultKind::kFallen, std::string(to_string(world_->body.fall()))};
  }
  if (auto fault = nonsense_in(command)) {
    return fault;
  }
  if (auto fault = wheels_refuse(command, world_->steering.angle_rad)) {
    return fault;
  }
  world_->command = command;
  return std::nullopt;
}

void SimRobot::make_safe() noexcept
{
  world_->safe = true;  // the next tick holds, and so do all others until activate()
}

void SimRobot::step()
{
  assert(world_->configured);
  world_->tick();
}

void SimRobot::step(const SimActuation & moved)
{
  assert(world_->configured);
  world_->tick(moved);
}

Time SimRobot::time() const { return world_->time; }

GroundTruth SimRobot::truth() const { return world_->truth(); }

ResumeOutcome SimRobot::resume_outcome() const { return world_->resume_outcome; }

const std::string & SimRobot::resume_detail() const { return world_->resume_detail; }

std::vector<std::uint8_t> SimRobot::state() const { return world_->state(); }

}  // namespace stetro_driver
