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
#ifndef DEMO__DEMO_NODE_HPP_
#define DEMO__DEMO_NODE_HPP_

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "demo_options.hpp"
#include "journey_files.hpp"
#include "stetro_bringup/recorder.hpp"
#include "stetro_bringup/staircase_found.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_msgs/DiagnosticArray.hpp"
#include "stetro_msgs/Innovations.hpp"
#include "stetro_msgs/MissionRequest.hpp"
#include "stetro_msgs/MissionStatus.hpp"
#include "stetro_msgs/ProfileCheck.hpp"
#include "stetro_msgs/RangeArray.hpp"
#include "stetro_msgs/StairPose.hpp"

namespace stetro_bringup
{

/// What the demo learns of the mission, for its progress line and its end.
struct MissionView
{
  std::uint8_t mission = 0;  ///< MISSION_* of MissionStatus
  std::string state;
  std::string segment;
  int step = -1;
  int step_count = 0;
  std::string fault;
};

/// The operator of the demo, who asks for the flight to be cleaned, and its observer.
/**
 * It only listens and asks: the robot does the same with it and with any other operator. Belongs to
 * one executor.
 */
class DemoNode
{
public:
  /// \param task what to ask for
  /// \param recorder takes what is heard; stays the caller's and must outlive the node
  DemoNode(
    stetro_dds::Context & context, stetro_dds::NodeOptions options, const Task & task,
    Recorder & recorder);

  [[nodiscard]] stetro_dds::Node & node() { return node_; }

  /// Is told each answer of the profile check while the mission goes on.
  void hear_checks(std::function<void(const CheckSample &)> heard) { heard_ = std::move(heard); }

  /// Asks for the task, once the pose is trusted, until a supervisor accepts; call it often.
  /** Later, if the task says so, asks to go on with a mission that is held. */
  void ask();

  [[nodiscard]] bool accepted() const { return accepted_; }
  [[nodiscard]] const std::string & last_refusal() const { return refusal_; }
  [[nodiscard]] int times_held() const { return times_held_; }
  [[nodiscard]] bool ended() const;     ///< finished, aborted or in fault
  [[nodiscard]] bool finished() const;  ///< reached the goal
  [[nodiscard]] const MissionView & mission() const { return mission_; }
  [[nodiscard]] const std::vector<std::string> & faults() const { return faults_; }
  [[nodiscard]] const std::optional<Estimate> & last_estimate() const { return last_estimate_; }
  [[nodiscard]] const StaircaseFound & staircase() const { return staircase_; }
  /// The localizer has said since the end what staircase it found.
  [[nodiscard]] bool knows_staircase() const { return ended() && staircase_at_ >= ended_at_; }
  [[nodiscard]] std::chrono::nanoseconds started_at() const { return started_at_; }
  [[nodiscard]] std::chrono::nanoseconds ended_at() const { return ended_at_; }

private:
  std::optional<stetro_dds::Refusal> on_stair_pose(const stetro_msgs::msg::StairPose & message);
  std::optional<stetro_dds::Refusal> on_ground_truth(const stetro_msgs::msg::StairPose & message);
  void on_ranges(const stetro_msgs::msg::RangeArray & message);
  void on_innovations(const stetro_msgs::msg::Innovations & message);
  void on_diagnostics(const diagnostic_msgs::msg::DiagnosticArray & message);
  void on_mission_status(const stetro_msgs::msg::MissionStatus & message);
  [[nodiscard]] std::string request_id() const;
  void send(std::uint8_t kind);

  stetro_dds::Node node_;
  const Task task_;
  Recorder & recorder_;
  std::function<void(const CheckSample &)> heard_;
  stetro_dds::Publisher<stetro_msgs::msg::MissionRequest> & mission_requests_;
  MissionView mission_;
  bool accepted_ = false;
  // A request is sent again under its id until it is answered; after a refusal comes another id.
  int asked_ = 0;
  bool awaiting_answer_ = false;
  int times_held_ = 0;
  std::string refusal_;
  std::vector<std::string> faults_;
  std::optional<Estimate> last_estimate_;
  StaircaseFound staircase_;
  std::chrono::nanoseconds staircase_at_{0};
  std::chrono::nanoseconds started_at_{0};
  std::chrono::nanoseconds ended_at_{0};
};

}  // namespace stetro_bringup

#endif  // DEMO__DEMO_NODE_HPP_
