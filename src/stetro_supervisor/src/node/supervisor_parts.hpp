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
#ifndef NODE__SUPERVISOR_PARTS_HPP_
#define NODE__SUPERVISOR_PARTS_HPP_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "convert.hpp"
#include "floor_topics.hpp"
#include "mission_store.hpp"
#include "request_guard.hpp"
#include "stamp_guard.hpp"
#include "stetro_supervisor/supervisor_node.hpp"

namespace stetro_supervisor
{

/// What the node is made of. Handlers convert and keep; the tick alone runs the journey.
class SupervisorNode::Parts
{
public:
  Parts(
    stetro_dds::Context & context, const stetro_dds::NodeOptions & options,
    const SupervisorSetup & setup);

  stetro_dds::Node & node() { return node_; }
  MissionStatus status() const { return mission_.status(); }
  void hold();

private:
  /// Subscribes a stream of the driver's: its stamps are judged, its writer is watched.
  template <class Message>
  void listen(const std::string & topic, const stetro_dds::QosProfile & profile);

  void open_inputs();
  void tick(Time now);
  void command(const MotionCommand & command, Time now);
  void publish_status(Time now);
  void tell_answer(const MissionAnswer & answer, Time now);
  void tell_localizer(const stetro_msgs::msg::MissionRequest & message);
  void publish_fleet(Time now);
  void keep_pose(const stetro_msgs::msg::StairPose & message);
  std::string level() const;
  void report(stetro_dds::DiagnosticReport & report) const;
  void notice_writer(const stetro_dds::Guid & writer);
  std::optional<Refusal> take_pose(
    const stetro_msgs::msg::StairPose & message, const stetro_dds::Reception & reception);
  std::optional<Refusal> take_status(
    const stetro_msgs::msg::CommandStatus & message, const stetro_dds::Reception & reception);
  std::optional<Refusal> take_request(
    const stetro_msgs::msg::MissionRequest & message, const stetro_dds::Reception & reception);

  const SupervisorParams params_;
  const std::string robot_name_;
  stetro_dds::Node node_;
  Journey journey_;
  Mission mission_;
  MissionStore store_;
  Observation seen_;
  std::optional<stetro_site::Pose> pose_in_map_;  ///< of base_link
  std::unique_ptr<FloorTopics> floors_;           ///< null where no floor is drawn
  StampGuard pose_stamps_;
  StampGuard status_stamps_;
  RequestGuard request_stamps_;
  std::vector<std::unique_ptr<StampGuard>> guards_;

  Issuer issuer_;
  std::uint64_t sequence_ = 0;
  std::uint64_t fleet_sequence_ = 0;
  std::optional<MissionAnswer> answer_;
  std::string relocalised_ = "none";               ///< what became of the last pose told
  std::optional<stetro_dds::Guid> driver_writer_;  ///< of the streams: changes with its process
  std::uint64_t driver_told_ = 0;   ///< instance in its last command status; 0 not yet
  std::uint64_t driver_epoch_ = 1;  ///< counts its restarts
  Time status_due_{0};

  stetro_dds::Publisher<stetro_msgs::msg::Command> & command_;
  stetro_dds::Publisher<stetro_msgs::msg::MissionStatus> & status_;
  stetro_dds::Publisher<geometry_msgs::msg::PoseWithCovarianceStamped> & initialpose_;
  stetro_dds::Publisher<rmf_fleet_msgs::msg::FleetState> & fleet_;
};

}  // namespace stetro_supervisor

#endif  // NODE__SUPERVISOR_PARTS_HPP_
