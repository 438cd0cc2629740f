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
#ifndef SUPPORT__TOY_WIRE_HPP_
#define SUPPORT__TOY_WIRE_HPP_

#include <optional>
#include <string>

#include "stetro_dds/context.hpp"
#include "stetro_dds/node.hpp"
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
#include "support/toy_robot.hpp"

namespace stetro_supervisor
{

/// A domain of this test process alone (ROS_DOMAIN_ID decides, if set), loopback only.
stetro_dds::ContextOptions test_options();

/// Speaks for the toy robot: as its driver, its localizer and its operator.
class ToyWire
{
public:
  ToyWire(stetro_dds::Context & context, ToyRobot & robot);

  stetro_dds::Node & node() { return node_; }

  void publish();
  /// Executes the last command for 50 ms, if it came since the last call and `moves`.
  void act(bool moves);
  void request(const std::string & id, std::uint8_t kind, const std::string & segment = "");
  /// Tells that the robot stands where it does, but for the step.
  void relocalise(const std::string & id, int step);
  std::string state() const { return status ? status->state().c_str() : "(no status)"; }

  std::optional<stetro_msgs::msg::MissionStatus> status;
  std::optional<rmf_fleet_msgs::msg::FleetState> fleet;
  std::optional<geometry_msgs::msg::PoseWithCovarianceStamped> told;  ///< on initialpose
  bool localizer_takes = true;                                        ///< what it is told
  std::uint64_t driver_instance = 7;
  bool silent = false;                ///< the driver says nothing more
  std::optional<Time> request_stamp;  ///< of the operator's clock, if it is not the robot's

private:
  void publish_ranges(const Observation & seen);
  void publish_contacts(const Observation & seen);
  void publish_blocks(const Observation & seen);
  void publish_pose(const Observation & seen);
  void answer(const stetro_msgs::msg::Command & command);

  ToyRobot & robot_;
  stetro_dds::Node node_;
  std::optional<stetro_msgs::msg::Command> command_;
  stetro_dds::Publisher<stetro_msgs::msg::RangeArray> & ranges_;
  stetro_dds::Publisher<stetro_msgs::msg::Contacts> & contacts_;
  stetro_dds::Publisher<stetro_msgs::msg::BlockStates> & blocks_;
  stetro_dds::Publisher<nav_msgs::msg::Odometry> & odometry_;
  stetro_dds::Publisher<stetro_msgs::msg::StairPose> & pose_;
  stetro_dds::Publisher<stetro_msgs::msg::CommandStatus> & answers_;
  stetro_dds::Publisher<stetro_msgs::msg::MissionRequest> & mission_;
};

}  // namespace stetro_supervisor

#endif  // SUPPORT__TOY_WIRE_HPP_
