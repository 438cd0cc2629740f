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
#include <limits>

#include "convert.hpp"

namespace stetro_supervisor
{
namespace
{

std::uint8_t wire_of(MissionState state)
{
  namespace wire = stetro_msgs::msg::MissionStatus_Constants;
  switch (state) {
    case MissionState::kIdle:
      return wire::MISSION_IDLE;
    case MissionState::kRunning:
      return wire::MISSION_RUNNING;
    case MissionState::kPaused:
      return wire::MISSION_PAUSED;
    case MissionState::kHeld:
      return wire::MISSION_HELD;
    case MissionState::kFinished:
      return wire::MISSION_FINISHED;
    case MissionState::kAborted:
      return wire::MISSION_ABORTED;
    case MissionState::kFault:
      return wire::MISSION_FAULT;
  }
  return wire::MISSION_UNKNOWN;
}

std::uint32_t fleet_mode(const MissionStatus & status)
{
  namespace wire = rmf_fleet_msgs::msg::RobotMode_Constants;
  switch (status.mission) {
    case MissionState::kRunning:
      return wire::MODE_CLEANING;
    case MissionState::kPaused:
      return wire::MODE_PAUSED;
    case MissionState::kHeld:
      return wire::MODE_WAITING;
    case MissionState::kFault:
      return status.fault == Fault::kEmergencyStop ? wire::MODE_EMERGENCY
                                                   : wire::MODE_ADAPTER_ERROR;
    default:
      return wire::MODE_IDLE;
  }
}

}  // namespace

stetro_msgs::msg::MissionStatus to_message(
  const MissionStatus & status, const std::optional<MissionAnswer> & answer, Time now)
{
  namespace wire = stetro_msgs::msg::MissionStatus_Constants;
  stetro_msgs::msg::MissionStatus message;
  message.header().stamp(stamp_of(now));
  message.header().frame_id(status.segment_id);
  message.answer(wire::ANSWER_NONE);
  if (answer) {
    message.request_id(answer->request_id);
    message.issuer(answer->issuer);
    message.answer(answer->accepted ? wire::ANSWER_ACCEPTED : wire::ANSWER_REFUSED);
    message.answer_reason(answer->reason);
  }
  message.mission(wire_of(status.mission));
  message.state(status.state_name);
  message.segment_id(status.segment_id);
  message.step(status.step);
  message.step_count(status.step_count);
  message.swept_share(status.swept_share);
  message.time_in_state(status.time_in_state_s);
  message.time_limit(status.time_limit_s);
  message.fault(status.fault == Fault::kNone ? "" : to_string(status.fault));
  message.fault_detail(status.detail);
  return message;
}

rmf_fleet_msgs::msg::FleetState to_message(
  const FleetEntry & entry, const MissionStatus & status, Time now)
{
  rmf_fleet_msgs::msg::RobotState robot;
  robot.name(entry.robot);
  robot.model(entry.model);
  robot.task_id(entry.task_id);
  robot.seq(entry.sequence);
  robot.mode().mode(fleet_mode(status));
  robot.battery_percent(std::numeric_limits<float>::quiet_NaN());
  robot.location().t(stamp_of(now));
  robot.location().x(static_cast<float>(entry.pose_in_map.x_m));
  robot.location().y(static_cast<float>(entry.pose_in_map.y_m));
  robot.location().yaw(static_cast<float>(entry.pose_in_map.yaw_rad));
  robot.location().level_name(entry.level);
  rmf_fleet_msgs::msg::FleetState message;
  message.name(entry.fleet);
  message.robots({robot});
  return message;
}

}  // namespace stetro_supervisor
