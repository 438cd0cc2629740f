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
#ifndef STETRO_SUPERVISOR__SUPERVISOR_NODE_HPP_
#define STETRO_SUPERVISOR__SUPERVISOR_NODE_HPP_

#include <memory>

#include "stetro_dds/context.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_supervisor/mission.hpp"
#include "stetro_supervisor/supervisor_setup.hpp"

namespace stetro_supervisor
{

/// The autonomy in the graph: reads the robot and the pose, commands the driver, answers missions.
/**
 * Subscribes ranges, contacts, blocks, odom, command_status, stair_pose and mission; publishes
 * command, mission_status, initialpose (a pose that a request told), /fleet_states and
 * /diagnostics. Where a floor of the site is drawn it also subscribes scan, and publishes
 * profile_check and pose_correction. Each period of the node's time the observation as it stands
 * goes into the journey, and the command that comes out to the driver, who acts on it only while
 * it is valid. A mission found in the state file is taken up held.
 *
 * A sample of the driver is as old as its stamp says; beyond `max_sample_age_s` it is refused, as
 * are stamps of zero, ahead of the clock, or before the one before. A request is refused, and
 * answered so, with a stamp of zero or before the last one of its issuer; with one farther from the
 * clock than `request_tolerance_s` only on the computer's clock: on simulated time an operator may
 * stamp with the clock on the wall.
 *
 * Belongs to its executor's thread. Destroying it sends a hold.
 */
class SupervisorNode
{
public:
  SupervisorNode(
    stetro_dds::Context & context, const stetro_dds::NodeOptions & options,
    const SupervisorSetup & setup);

  /// Reads the setup itself. \throws stetro_config::ConfigError with every fault of `read_setup()`
  SupervisorNode(
    stetro_dds::Context & context, const stetro_dds::NodeOptions & options,
    const SupervisorParams & params);
  ~SupervisorNode();
  SupervisorNode(const SupervisorNode &) = delete;
  SupervisorNode & operator=(const SupervisorNode &) = delete;

  stetro_dds::Node & node();

  [[nodiscard]] MissionStatus status() const;

  /// Commands the robot to stand still; called when the process is to end.
  void hold();

private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__SUPERVISOR_NODE_HPP_
