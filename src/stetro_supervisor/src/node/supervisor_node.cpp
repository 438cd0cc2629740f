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
#include "stetro_supervisor/supervisor_node.hpp"

#include <algorithm>
#include <cmath>

#include "stetro_config/fault.hpp"
#include "stetro_dds/instance_id.hpp"
#include "supervisor_parts.hpp"

namespace stetro_supervisor
{
namespace
{

namespace qos = stetro_dds::qos;
using stetro_dds::Guid;
using stetro_dds::LifecycleTransition;
using stetro_dds::Reception;

constexpr std::chrono::milliseconds kStatusPeriod{500};
constexpr std::chrono::seconds kFleetPeriod{1};
constexpr std::chrono::seconds kRecentPose{1};

Time nanoseconds(double seconds) { return Time{std::llround(seconds * 1e9)}; }

SupervisorSetup setup_of(const SupervisorParams & params)
{
  stetro_config::Faults faults;
  const auto setup = read_setup(params, faults);
  faults.throw_if_any();
  return setup.value();
}

bool same_participant(const Guid & a, const Guid & b)
{
  return std::equal(a.begin(), a.begin() + 12, b.begin());
}

}  // namespace

SupervisorNode::Parts::Parts(
  stetro_dds::Context & context, const stetro_dds::NodeOptions & options,
  const SupervisorSetup & setup)
: params_(setup.params),
  robot_name_(setup.robot.name),
  node_(context, options),
  journey_(setup.site, setup.robot.geometry, params_.climb, params_.floor, setup.flight.id()),
  mission_(journey_),
  store_(params_.state_file),
  pose_stamps_(nanoseconds(params_.future_tolerance_s)),
  status_stamps_(nanoseconds(params_.future_tolerance_s), nanoseconds(params_.max_sample_age_s)),
  request_stamps_(nanoseconds(params_.request_tolerance_s)),
  issuer_{node_.name().full(), stetro_dds::draw_instance_id(), nanoseconds(params_.valid_for_s)},
  command_(node_.advertise<stetro_msgs::msg::Command>("command", qos::kCommand)),
  status_(node_.advertise<stetro_msgs::msg::MissionStatus>("mission_status", qos::kLatched)),
  initialpose_(node_.advertise<geometry_msgs::msg::PoseWithCovarianceStamped>(
    "initialpose", qos::kCorrection)),
  fleet_(node_.advertise<rmf_fleet_msgs::msg::FleetState>("/fleet_states", qos::kFleetState))
{
  open_inputs();
  if (journey_.knows_floors()) {
    floors_ = std::make_unique<FloorTopics>(
      node_, journey_.site(), nanoseconds(params_.future_tolerance_s), seen_.scan);
  }
  if (const auto record = store_.load(journey_)) {
    journey_.restore(*record);
    node_.log().warn("a mission was under way at step {}: held until resumed", record->step);
  }
  if (!store_.trouble().empty()) {
    node_.log().error("{}", store_.trouble());
  }
  node_.create_timer(nanoseconds(1.0 / params_.rate_hz), [this](Time now) { tick(now); });
  node_.create_timer(kFleetPeriod, [this](Time now) { publish_fleet(now); });
  node_.diagnostics().add("mission", [this](stetro_dds::DiagnosticReport & r) { report(r); });
  node_.lifecycle().request(LifecycleTransition::kConfigure);
  node_.lifecycle().request(LifecycleTransition::kActivate);
}

template <class Message>
void SupervisorNode::Parts::listen(
  const std::string & topic, const stetro_dds::QosProfile & profile)
{
  guards_.push_back(std::make_unique<StampGuard>(
    nanoseconds(params_.future_tolerance_s), nanoseconds(params_.max_sample_age_s)));
  StampGuard & guard = *guards_.back();
  node_.subscribe<Message>(
    topic, profile,
    [this, &guard](const Message & message, const Reception & reception) -> std::optional<Refusal> {
      const Time now = node_.clock().now();
      const Time stamp = time_of(message.header().stamp());
      if (auto refusal = guard.judge(stamp, now, reception.writer)) {
        return refusal;
      }
      notice_writer(reception.writer);
      return take(message, std::min(now, stamp), seen_);  // what waited in a queue is not fresh
    });
}

void SupervisorNode::Parts::open_inputs()
{
  listen<stetro_msgs::msg::RangeArray>("ranges", qos::kSensor);
  listen<stetro_msgs::msg::Contacts>("contacts", qos::kContacts);
  listen<stetro_msgs::msg::BlockStates>("blocks", qos::kSensor);
  listen<nav_msgs::msg::Odometry>("odom", qos::kSensor);
  node_.subscribe<stetro_msgs::msg::StairPose>(
    "stair_pose", qos::kLatched,
    [this](const stetro_msgs::msg::StairPose & message, const Reception & reception) {
      return take_pose(message, reception);
    });
  node_.subscribe<stetro_msgs::msg::CommandStatus>(
    "command_status", qos::kCommandStatus,
    [this](const stetro_msgs::msg::CommandStatus & message, const Reception & reception) {
      return take_status(message, reception);
    });
  node_.subscribe<stetro_msgs::msg::MissionRequest>(
    "mission", qos::kMission,
    [this](const stetro_msgs::msg::MissionRequest & message, const Reception & reception) {
      return take_request(message, reception);
    });
}

/// Another process writes the driver's streams: whatever it was asked to do is forgotten.
void SupervisorNode::Parts::notice_writer(const Guid & writer)
{
  if (driver_writer_ && !same_participant(*driver_writer_, writer)) {
    ++driver_epoch_;
    driver_told_ = 0;
  }
  driver_writer_ = writer;
  seen_.driver_instance = driver_epoch_;
}

std::optional<Refusal> SupervisorNode::Parts::take_pose(
  const stetro_msgs::msg::StairPose & message, const Reception & reception)
{
  const Time now = node_.clock().now();
  if (auto refusal = pose_stamps_.judge(time_of(message.header().stamp()), now, reception.writer)) {
    return refusal;
  }
  const auto * flight = journey_.site().find_flight(message.segment_id().c_str());
  if (flight != nullptr && message.step_count() != flight->steps()) {
    return Refusal{
      "wrong_step_count", std::to_string(message.step_count()) + ", accepted: " +
                            std::to_string(flight->steps()) + " as in the site file"};
  }
  // A latched pose of a localizer that has gone is as old as its stamp says, not as its arrival.
  const Time measured = std::min(now, time_of(message.header().stamp()));
  if (auto refusal = take(message, measured, seen_)) {
    return refusal;
  }
  keep_pose(message);
  return std::nullopt;
}

void SupervisorNode::Parts::keep_pose(const stetro_msgs::msg::StairPose & message)
{
  const auto & position = message.pose().pose().position();
  if (!std::isfinite(position.x()) || !std::isfinite(position.z())) {
    return;
  }
  const stetro_site::Pose pose{position.x(), position.y(), position.z(), seen_.pose->heading_rad};
  const std::string & segment = seen_.pose->segment_id;
  if (const auto * flight = journey_.site().find_flight(segment)) {
    pose_in_map_ = flight->T_map_flight().to_map(pose);
  } else if (const auto * floor = journey_.site().find_floor(segment)) {
    pose_in_map_ = stetro_site::FrameTransform{floor->pose_in_map}.to_map(pose);
  }
}

std::optional<Refusal> SupervisorNode::Parts::take_status(
  const stetro_msgs::msg::CommandStatus & message, const Reception & reception)
{
  const Time now = node_.clock().now();
  const Time stamp = time_of(message.header().stamp());
  if (message.driver_instance() != driver_told_) {
    status_stamps_.restart();
  }
  if (auto refusal = status_stamps_.judge(stamp, now, reception.writer)) {
    return refusal;
  }
  if (driver_told_ != 0 && message.driver_instance() != driver_told_) {
    ++driver_epoch_;
    seen_.driver_instance = driver_epoch_;
  }
  driver_told_ = message.driver_instance();
  const bool ours =
    message.issuer() == issuer_.name.c_str() && message.issuer_instance() == issuer_.instance;
  return ours ? take(message, std::min(now, stamp), seen_) : std::nullopt;
}

std::optional<Refusal> SupervisorNode::Parts::take_request(
  const stetro_msgs::msg::MissionRequest & message, const Reception & reception)
{
  const MissionRequest request = from_message(message);
  auto doubt = doubt_of(message);
  const bool repeated = mission_.knows(request);
  if (!doubt && !repeated) {  // one that is repeated changes nothing, however old
    doubt = request_stamps_.judge(
      time_of(message.header().stamp()), {node_.clock().now(), node_.clock().source()},
      request.issuer, reception.writer);
  }
  const MissionAnswer answer =
    doubt ? MissionAnswer{request.request_id, request.issuer, false, doubt->detail}
          : mission_.request(request);
  if (!answer.waits) {
    tell_answer(answer, node_.clock().now());
  } else if (!repeated) {
    tell_localizer(message);
  }
  return doubt;
}

void SupervisorNode::Parts::tell_answer(const MissionAnswer & answer, Time now)
{
  answer_ = answer;
  node_.log().info(
    "request '{}' of '{}': {}", answer.request_id, answer.issuer,
    answer.accepted ? "accepted" : "refused: " + answer.reason);
  publish_status(now);
}

// Stamped as the localizer's last pose: its clock has certainly come that far, ours may be ahead.
void SupervisorNode::Parts::tell_localizer(const stetro_msgs::msg::MissionRequest & message)
{
  const Time now = node_.clock().now();
  const bool recent = seen_.pose && now - seen_.pose->time < kRecentPose;
  initialpose_.publish(told_to_localizer(message, recent ? seen_.pose->time : now));
  relocalised_ = "waits for the localizer";
  node_.log().info(
    "request '{}' of '{}': the localizer is told its pose", message.request_id().c_str(),
    message.issuer().to_string());
}

void SupervisorNode::Parts::tick(Time now)
{
  command(journey_.tick(now, seen_), now);
  store_.keep(journey_);
  if (floors_ && journey_.check_report()) {
    floors_->tell(*journey_.check_report());
  }
  if (const auto settled = mission_.settle()) {
    relocalised_ = settled->accepted ? "taken by the localizer" : settled->reason;
    tell_answer(*settled, now);
  }
  const bool changed = !journey_.transition().empty();
  if (changed) {
    const auto severity = journey_.has_fault() ? spdlog::level::err : spdlog::level::info;
    node_.log().log(severity, "{}", journey_.transition());
  }
  if (changed || now >= status_due_ || status_due_ > now + kStatusPeriod) {
    publish_status(now);
  }
}

void SupervisorNode::Parts::command(const MotionCommand & command, Time now)
{
  if (command.kind != MotionCommand::Kind::kNone) {
    command_.publish(to_message(command, issuer_, ++sequence_, now));
  }
}

void SupervisorNode::Parts::publish_status(Time now)
{
  if (now > Time{0}) {
    status_.publish(to_message(mission_.status(), answer_, now));
    status_due_ = now + kStatusPeriod;
  }
}

/// The floor that the robot is on, or the one below it on a flight.
std::string SupervisorNode::Parts::level() const
{
  if (seen_.pose && !seen_.pose->on_flight && !seen_.pose->segment_id.empty()) {
    return seen_.pose->segment_id;
  }
  const auto & flight = journey_.flight();
  const bool above = mission_.status().step == flight.steps();
  return above ? flight.spec().upper_floor : flight.spec().lower_floor;
}

void SupervisorNode::Parts::publish_fleet(Time now)
{
  if (!pose_in_map_) {
    return;
  }
  const MissionStatus status = mission_.status();
  FleetEntry entry;
  entry.fleet = params_.fleet;
  entry.robot = robot_name_;
  entry.model = "stetro";
  entry.task_id = journey_.record().request_id;
  entry.level = level();
  entry.sequence = ++fleet_sequence_;
  entry.pose_in_map = *pose_in_map_;
  fleet_.publish(to_message(entry, status, now));
}

void SupervisorNode::Parts::report(stetro_dds::DiagnosticReport & report) const
{
  using stetro_dds::Health;
  const MissionStatus status = mission_.status();
  report.value("state", status.state_name);
  report.value("step", static_cast<std::int64_t>(status.step));
  report.value("driver restarts", driver_epoch_ - 1);
  report.value("last relocalisation", relocalised_);
  if (floors_) {
    floors_->report(report);
  }
  if (status.mission == MissionState::kFault) {
    report.summarise(Health::kError, std::string(to_string(status.fault)) + ": " + status.detail);
  } else if (status.mission == MissionState::kHeld) {
    report.summarise(Health::kWarn, "held: " + status.detail);
  }
  if (!store_.trouble().empty()) {
    report.summarise(Health::kError, store_.trouble());
  }
}

void SupervisorNode::Parts::hold()
{
  const Time now = node_.clock().now();
  if (sequence_ > 0 && now > Time{0}) {
    command(stetro_supervisor::hold(), now);
  }
}

SupervisorNode::SupervisorNode(
  stetro_dds::Context & context, const stetro_dds::NodeOptions & options,
  const SupervisorSetup & setup)
: parts_(std::make_unique<Parts>(context, options, setup))
{
}

SupervisorNode::SupervisorNode(
  stetro_dds::Context & context, const stetro_dds::NodeOptions & options,
  const SupervisorParams & params)
: SupervisorNode(context, options, setup_of(params))
{
}

SupervisorNode::~SupervisorNode() { parts_->hold(); }

stetro_dds::Node & SupervisorNode::node() { return parts_->node(); }

MissionStatus SupervisorNode::status() const { return parts_->status(); }

void SupervisorNode::hold() { parts_->hold(); }

}  // namespace stetro_supervisor
