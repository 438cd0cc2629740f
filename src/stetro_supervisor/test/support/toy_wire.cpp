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
#include "support/toy_wire.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "stetro_dds/stamp.hpp"

namespace stetro_supervisor
{
namespace
{

namespace qos = stetro_dds::qos;

constexpr std::uint32_t kFirstDomain = 10;
constexpr std::uint32_t kDomains = 90;

/// The first domain whose lock file nobody holds; the lock ends with the process.
std::uint32_t free_domain()
{
  const auto folder = std::filesystem::temp_directory_path();
  const auto start = static_cast<std::uint32_t>(::getpid());
  for (std::uint32_t i = 0; i < kDomains; ++i) {
    const std::uint32_t id = kFirstDomain + (start + i) % kDomains;
    const auto path = folder / ("stetro_test_domain_" + std::to_string(id) + ".lock");
    const int file = ::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0) {
      return id;
    }
    ::close(file);
  }
  throw std::runtime_error("no free domain id between 10 and 99");
}

geometry_msgs::msg::Quaternion turned(double yaw_rad)
{
  geometry_msgs::msg::Quaternion q;
  q.z(std::sin(yaw_rad / 2.0));
  q.w(std::cos(yaw_rad / 2.0));
  return q;
}

stetro_msgs::msg::ContactState contact(const Contact & from)
{
  stetro_msgs::msg::ContactState message;
  message.state(static_cast<std::uint8_t>(from.state));  // both count unknown, open, closed
  return message;
}

stetro_msgs::msg::BlockState block(const Block & from)
{
  stetro_msgs::msg::BlockState message;
  message.height(from.height_m);
  message.moving(from.moving);
  message.at_upper_lock(from.at_upper_lock);
  message.load(from.load);
  return message;
}

MotionCommand command_of(const stetro_msgs::msg::Command & message)
{
  using Kind = MotionCommand::Kind;  // kTwist to kStop are numbered as on the wire
  MotionCommand command;
  command.kind = static_cast<Kind>(message.kind());
  command.vx_mps = message.vx();
  command.vy_mps = message.vy();
  command.wz_rps = message.wz();
  command.block = message.block();
  command.steering_rad = message.steering_angle();
  return command;
}

}  // namespace

stetro_dds::ContextOptions test_options()
{
  static const std::uint32_t kDomain = std::getenv("ROS_DOMAIN_ID") != nullptr
                                         ? stetro_dds::ContextOptions::from_environment().domain_id
                                         : free_domain();
  stetro_dds::ContextOptions options;
  options.domain_id = kDomain;
  return options;
}

ToyWire::ToyWire(stetro_dds::Context & context, ToyRobot & robot)
: robot_(robot),
  node_(context, {"toy", "/stetro", stetro_dds::TimeSource::kByHand}),
  ranges_(node_.advertise<stetro_msgs::msg::RangeArray>("ranges", qos::kSensor)),
  contacts_(node_.advertise<stetro_msgs::msg::Contacts>("contacts", qos::kContacts)),
  blocks_(node_.advertise<stetro_msgs::msg::BlockStates>("blocks", qos::kSensor)),
  odometry_(node_.advertise<nav_msgs::msg::Odometry>("odom", qos::kSensor)),
  pose_(node_.advertise<stetro_msgs::msg::StairPose>("stair_pose", qos::kLatched)),
  answers_(node_.advertise<stetro_msgs::msg::CommandStatus>("command_status", qos::kCommandStatus)),
  mission_(node_.advertise<stetro_msgs::msg::MissionRequest>("mission", qos::kMission))
{
  node_.subscribe<stetro_msgs::msg::Command>(
    "command", qos::kCommand, [this](const stetro_msgs::msg::Command & m) { answer(m); });
  node_.subscribe<stetro_msgs::msg::MissionStatus>(
    "mission_status", qos::kLatched,
    [this](const stetro_msgs::msg::MissionStatus & m) { status = m; });
  node_.subscribe<geometry_msgs::msg::PoseWithCovarianceStamped>(
    "initialpose", qos::kCorrection,
    [this](const geometry_msgs::msg::PoseWithCovarianceStamped & m) {
      told = m;
      robot_.resets += localizer_takes ? 1 : 0;
    });
  node_.subscribe<rmf_fleet_msgs::msg::FleetState>(
    "/fleet_states", qos::kFleetState,
    [this](const rmf_fleet_msgs::msg::FleetState & m) { fleet = m; });
}

void ToyWire::answer(const stetro_msgs::msg::Command & command)
{
  command_ = command;
  stetro_msgs::msg::CommandStatus message;
  message.header().stamp(stetro_dds::stamp_of(robot_.now));
  message.sequence_number(command.sequence_number());
  message.issuer(command.issuer());
  message.issuer_instance(command.issuer_instance());
  message.driver_instance(driver_instance);
  message.outcome(stetro_msgs::msg::CommandStatus_Constants::OUTCOME_ACCEPTED);
  answers_.publish(message);
}

void ToyWire::publish()
{
  const Observation seen = robot_.look();
  publish_pose(seen);
  if (silent) {
    return;
  }
  publish_ranges(seen);
  publish_contacts(seen);
  publish_blocks(seen);
  nav_msgs::msg::Odometry odometry;
  odometry.header().stamp(stetro_dds::stamp_of(robot_.now));
  odometry.pose().pose().position().x(seen.odometry->x_m);
  odometry.pose().pose().position().y(seen.odometry->y_m);
  odometry.pose().pose().orientation(turned(seen.odometry->yaw_rad));
  odometry_.publish(odometry);
}

void ToyWire::publish_ranges(const Observation & seen)
{
  stetro_msgs::msg::RangeArray message;
  message.header().stamp(stetro_dds::stamp_of(robot_.now));
  for (const Place place : stetro_site::kPlaces) {
    stetro_msgs::msg::RangeReading reading;
    reading.sensor(stetro_site::name_of(place));
    reading.stamp(stetro_dds::stamp_of(robot_.now));
    reading.range(seen.range(place)->range_m);
    reading.status(static_cast<std::uint8_t>(seen.range(place)->status));  // numbered alike
    message.readings().push_back(reading);
  }
  ranges_.publish(message);
}

void ToyWire::publish_contacts(const Observation & seen)
{
  const Contacts & c = *seen.contacts;
  stetro_msgs::msg::Contacts message;
  message.header().stamp(stetro_dds::stamp_of(robot_.now));
  message.left_front(contact(c.left[0]));
  message.left_middle(contact(c.left[1]));
  message.left_rear(contact(c.left[2]));
  message.right_front(contact(c.right[0]));
  message.right_middle(contact(c.right[1]));
  message.right_rear(contact(c.right[2]));
  message.riser_left(contact(c.riser_left));
  message.riser_right(contact(c.riser_right));
  message.emergency_stop(contact(c.emergency_stop));
  contacts_.publish(message);
}

void ToyWire::publish_blocks(const Observation & seen)
{
  stetro_msgs::msg::BlockStates message;
  message.header().stamp(stetro_dds::stamp_of(robot_.now));
  message.block1(block(seen.blocks->block[0]));
  message.block2(block(seen.blocks->block[1]));
  message.block3(block(seen.blocks->block[2]));
  message.steering_angle(seen.blocks->steering_rad);
  message.steering_moving(seen.blocks->steering_moving);
  blocks_.publish(message);
}

void ToyWire::publish_pose(const Observation & seen)
{
  namespace wire = stetro_msgs::msg::StairPose_Constants;
  stetro_msgs::msg::StairPose message;
  message.header().stamp(stetro_dds::stamp_of(robot_.now));
  message.header().frame_id("flight");
  message.segment_id("flight");
  message.segment_kind(wire::SEGMENT_FLIGHT);
  message.step_index(seen.pose->step);
  message.step_count(2);
  message.pose().pose().position().x(robot_.x_m);
  message.pose().pose().position().y(robot_.y_m);
  message.pose().pose().position().z(robot_.z_m[1]);
  message.pose().pose().orientation(turned(robot_.heading_rad));
  message.integrity(wire::INTEGRITY_OK);
  message.reset_counter(seen.pose->resets);
  pose_.publish(message);
}

void ToyWire::act(bool moves)
{
  const MotionCommand command = moves && command_ ? command_of(*command_) : hold();
  command_.reset();
  for (int i = 0; i < 5; ++i) {
    robot_.act(command, 0.01);
  }
}

void ToyWire::relocalise(const std::string & id, int step)
{
  stetro_msgs::msg::MissionRequest message;
  message.header().stamp(stetro_dds::stamp_of(request_stamp.value_or(robot_.now)));
  message.header().frame_id("flight");
  message.request_id(id);
  message.issuer("operator");
  message.kind(stetro_msgs::msg::MissionRequest_Constants::KIND_RELOCALISE);
  message.segment_id("flight");
  message.pose().pose().position().x(robot_.x_m);
  message.pose().pose().position().y(robot_.y_m);
  message.pose().pose().position().z(robot_.z_m[1]);
  message.pose().pose().orientation(turned(robot_.heading_rad));
  message.pose().covariance()[7] = 0.0025;
  message.step(step);
  mission_.publish(message);
}

void ToyWire::request(const std::string & id, std::uint8_t kind, const std::string & segment)
{
  stetro_msgs::msg::MissionRequest message;
  message.header().stamp(stetro_dds::stamp_of(request_stamp.value_or(robot_.now)));
  message.request_id(id);
  message.issuer("operator");
  message.kind(kind);
  message.segment_id(segment);
  mission_.publish(message);
}

}  // namespace stetro_supervisor
