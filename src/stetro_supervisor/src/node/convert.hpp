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
#ifndef NODE__CONVERT_HPP_
#define NODE__CONVERT_HPP_

#include <cstdint>
#include <optional>
#include <string>

#include "stetro_dds/refusal.hpp"
#include "stetro_dds/stamp.hpp"
#include "stetro_msgs/BlockStates.hpp"
#include "stetro_msgs/Command.hpp"
#include "stetro_msgs/CommandStatus.hpp"
#include "stetro_msgs/Contacts.hpp"
#include "stetro_msgs/FleetState.hpp"
#include "stetro_msgs/MissionRequest.hpp"
#include "stetro_msgs/MissionStatus.hpp"
#include "stetro_msgs/Odometry.hpp"
#include "stetro_msgs/PoseWithCovarianceStamped.hpp"
#include "stetro_msgs/RangeArray.hpp"
#include "stetro_msgs/StairPose.hpp"
#include "stetro_site/flight.hpp"
#include "stetro_site/pose.hpp"
#include "stetro_supervisor/mission.hpp"
#include "stetro_supervisor/motion_command.hpp"
#include "stetro_supervisor/observation.hpp"

/// The only place that knows both the messages and the types of the core.
/**
 * What is not finite or names nothing known stops here: a function returns why it did not take a
 * message, and then has changed nothing. `received` becomes the sample's time in the core.
 */
namespace stetro_supervisor
{

using stetro_dds::Refusal;
using stetro_dds::stamp_of;
using stetro_dds::time_of;

std::optional<Refusal> take(
  const stetro_msgs::msg::RangeArray & message, Time received, Observation & seen);
std::optional<Refusal> take(
  const stetro_msgs::msg::Contacts & message, Time received, Observation & seen);
std::optional<Refusal> take(
  const stetro_msgs::msg::BlockStates & message, Time received, Observation & seen);
std::optional<Refusal> take(
  const nav_msgs::msg::Odometry & message, Time received, Observation & seen);
std::optional<Refusal> take(
  const stetro_msgs::msg::StairPose & message, Time received, Observation & seen);

/// The driver's answer to a command of ours.
std::optional<Refusal> take(
  const stetro_msgs::msg::CommandStatus & message, Time received, Observation & seen);

/// Why a request cannot be answered for: its id or issuer is empty, or may be the stump of another.
std::optional<Refusal> doubt_of(const stetro_msgs::msg::MissionRequest & message);

MissionRequest from_message(const stetro_msgs::msg::MissionRequest & message);

/// The pose of a request to relocalise, for `initialpose`, in the frame it was told in.
geometry_msgs::msg::PoseWithCovarianceStamped told_to_localizer(
  const stetro_msgs::msg::MissionRequest & message, Time stamp);

/// Who commands, and how long a command may act.
struct Issuer
{
  std::string name;
  std::uint64_t instance = 0;
  Time valid_for{0};
};

stetro_msgs::msg::Command to_message(
  const MotionCommand & command, const Issuer & issuer, std::uint64_t sequence, Time now);

stetro_msgs::msg::MissionStatus to_message(
  const MissionStatus & status, const std::optional<MissionAnswer> & answer, Time now);

/// What Open-RMF is told about this robot.
struct FleetEntry
{
  std::string fleet;
  std::string robot;
  std::string model;
  std::string task_id;
  std::string level;
  std::uint64_t sequence = 0;
  stetro_site::Pose pose_in_map;
};

/// The battery is not measured: its percentage is NaN.
rmf_fleet_msgs::msg::FleetState to_message(
  const FleetEntry & entry, const MissionStatus & status, Time now);

}  // namespace stetro_supervisor

#endif  // NODE__CONVERT_HPP_
