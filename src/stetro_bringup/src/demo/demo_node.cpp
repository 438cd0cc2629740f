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
#include "demo_node.hpp"

#include <algorithm>
#include <utility>

#include "convert.hpp"

namespace stetro_bringup
{
namespace
{

namespace request = stetro_msgs::msg::MissionRequest_Constants;
namespace status = stetro_msgs::msg::MissionStatus_Constants;
namespace qos = stetro_dds::qos;

constexpr const char * kIssuer = "demo";

// An observer of a fast run wants every estimate, not only the newest.
constexpr stetro_dds::QosProfile recording()
{
  auto profile = qos::kLatched;
  profile.requested.depth = 200;
  return profile;
}

// Until somebody resumes it: a mission that waits for its pose is held, too, and goes on by itself.
bool stands_held(const MissionView & mission)
{
  return mission.mission == status::MISSION_HELD && mission.state == "held";
}

}  // namespace

DemoNode::DemoNode(
  stetro_dds::Context & context, stetro_dds::NodeOptions options, const Task & task,
  Recorder & recorder)
: node_(context, std::move(options)),
  task_(task),
  recorder_(recorder),
  mission_requests_(node_.advertise<stetro_msgs::msg::MissionRequest>("mission", qos::kMission))
{
  node_.subscribe<stetro_msgs::msg::StairPose>(
    "ground_truth", qos::kSensor,
    [this](const auto & message) { return on_ground_truth(message); });
  node_.subscribe<stetro_msgs::msg::RangeArray>(
    "ranges", qos::kSensor, [this](const auto & message) { on_ranges(message); });
  node_.subscribe<stetro_msgs::msg::Innovations>(
    "innovations", qos::kSensor, [this](const auto & message) { on_innovations(message); });
  node_.subscribe<stetro_msgs::msg::StairPose>(
    "stair_pose", recording(), [this](const auto & message) { return on_stair_pose(message); });
  node_.subscribe<diagnostic_msgs::msg::DiagnosticArray>(
    "/diagnostics", qos::kDiagnostics, [this](const auto & message) { on_diagnostics(message); });
  node_.subscribe<stetro_msgs::msg::ProfileCheck>(
    "profile_check", recording(), [this](const auto & message) {
      if (heard_ && accepted_ && !ended()) {
        heard_(check_of(message));
      }
    });
  node_.subscribe<stetro_msgs::msg::MissionStatus>(
    "mission_status", qos::kLatched, [this](const auto & message) { on_mission_status(message); });
}

void DemoNode::ask()
{
  const bool trusted = last_estimate_ && last_estimate_->integrity == "OK";
  if (!trusted || (accepted_ && !(task_.resumes && stands_held(mission_)))) {
    return;
  }
  if (!awaiting_answer_) {
    ++asked_;
    awaiting_answer_ = true;
  }
  if (accepted_) {
    send(request::KIND_RESUME);
  } else {
    send(task_.is_journey ? request::KIND_GO_TO_SEGMENT : request::KIND_CLEAN_FLIGHT);
  }
}

void DemoNode::send(std::uint8_t kind)
{
  stetro_msgs::msg::MissionRequest message;
  message.header().stamp() = stamp_of(node_.clock().now());
  message.request_id() = request_id();
  message.issuer() = kIssuer;
  message.kind() = kind;
  message.segment_id() = task_.goal.segment.c_str();
  message.step() = request::STEP_UNKNOWN;
  mission_requests_.publish(message);
}

std::string DemoNode::request_id() const { return "demo-" + std::to_string(asked_); }

bool DemoNode::ended() const
{
  return accepted_ &&
         (mission_.mission == status::MISSION_FINISHED ||
          mission_.mission == status::MISSION_ABORTED || mission_.mission == status::MISSION_FAULT);
}

bool DemoNode::finished() const
{
  return accepted_ && mission_.mission == status::MISSION_FINISHED;
}

std::optional<stetro_dds::Refusal> DemoNode::on_stair_pose(
  const stetro_msgs::msg::StairPose & message)
{
  stetro_dds::Refusal why;
  const auto sample = sample_of(message, why);
  if (!sample) {
    return why;
  }
  last_estimate_ = estimate_of(message, *sample);
  if (accepted_ && !ended()) {
    recorder_.add_estimate(*last_estimate_);
  }
  return std::nullopt;
}

std::optional<stetro_dds::Refusal> DemoNode::on_ground_truth(
  const stetro_msgs::msg::StairPose & message)
{
  stetro_dds::Refusal why;
  const auto sample = sample_of(message, why);
  if (!sample) {
    return why;
  }
  recorder_.add_truth(*sample);
  return std::nullopt;
}

void DemoNode::on_ranges(const stetro_msgs::msg::RangeArray & message)
{
  const auto stamp = time_of(message.header().stamp());
  for (const auto & reading : message.readings()) {
    recorder_.add_range(stamp, reading.sensor().c_str(), reading.range());
  }
}

void DemoNode::on_innovations(const stetro_msgs::msg::Innovations & message)
{
  const auto stamp = time_of(message.header().stamp());
  for (const auto & innovation : message.innovations()) {
    recorder_.add_outcome(stamp, innovation.source().c_str(), outcome_name(innovation.outcome()));
  }
}

void DemoNode::on_diagnostics(const diagnostic_msgs::msg::DiagnosticArray & message)
{
  for (const auto & status : message.status()) {
    if (status.name() == "localizer: staircase as built") {
      staircase_ = staircase_of(status);
      staircase_at_ = time_of(message.header().stamp());
    }
  }
}

void DemoNode::on_mission_status(const stetro_msgs::msg::MissionStatus & message)
{
  const bool over = ended();
  const auto now = time_of(message.header().stamp());
  if (message.issuer() == kIssuer && message.request_id().c_str() == request_id()) {
    if (message.answer() == status::ANSWER_ACCEPTED) {
      started_at_ = accepted_ ? started_at_ : now;
      accepted_ = true;
      awaiting_answer_ = false;
    } else if (message.answer() == status::ANSWER_REFUSED) {
      refusal_ = message.answer_reason().c_str();
      awaiting_answer_ = false;
    }
  }
  const bool stood = stands_held(mission_);
  mission_ = {message.mission(), message.state().c_str(), message.segment_id().c_str(),
              message.step(),    message.step_count(),    message.fault().c_str()};
  times_held_ += stands_held(mission_) && !stood ? 1 : 0;
  ended_at_ = over ? ended_at_ : now;
  std::string fault = message.fault().c_str();
  if (!fault.empty()) {
    fault += std::string(": ") + message.fault_detail().c_str();
    if (std::find(faults_.begin(), faults_.end(), fault) == faults_.end()) {
      faults_.push_back(fault);
    }
  }
}

}  // namespace stetro_bringup
