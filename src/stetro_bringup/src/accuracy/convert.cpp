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

#include "accuracy/convert.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "stetro_site/frame_transform.hpp"
#include "stetro_site/sensor_place.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_driver::ContactPlace;
using stetro_driver::SensorFrame;
using stetro_driver::Time;

/// The driver's and the site's enumerations name the same places in another order.
const std::array<stetro_site::Place, stetro_driver::kRangePlaces> & places()
{
  static const auto all = [] {
    std::array<stetro_site::Place, stetro_driver::kRangePlaces> found{};
    for (std::size_t i = 0; i < found.size(); ++i) {
      found[i] = stetro_site::place_named(std::string(stetro_driver::kRangeNames[i])).value();
    }
    return found;
  }();
  return all;
}

/// \tparam To the localizer's or the supervisor's own, which name the same states
template <class To>
To status_as(stetro_driver::RangeStatus status)
{
  using From = stetro_driver::RangeStatus;
  switch (status) {
    case From::kValid:
      return To::kValid;
    case From::kTooNear:
      return To::kTooNear;
    case From::kNoTarget:
      return To::kNoTarget;
    case From::kWeak:
      return To::kWeak;
    case From::kStale:
      return To::kStale;
    case From::kFault:
      break;
  }
  return To::kFault;
}

bool breaks_the_rules(const stetro_driver::RangeReading & reading, Time cycle)
{
  const bool valid = reading.status == stetro_driver::RangeStatus::kValid;
  const bool stamped = reading.stamp > Time::zero() && reading.stamp <= cycle;
  return (valid && (!std::isfinite(reading.range_m) || !stamped)) ||
         (std::isfinite(reading.range_m) && reading.range_m < 0.0);
}

stetro_localizer::Switch to_switch(const stetro_driver::ContactReading & reading)
{
  return {!reading.fault, reading.closed};
}

stetro_supervisor::Contact to_contact(const stetro_driver::ContactReading & reading)
{
  using stetro_supervisor::ContactState;
  return {reading.closed ? ContactState::kClosed : ContactState::kOpen, reading.fault};
}

stetro_driver::MotionKind motion_kind(stetro_supervisor::MotionCommand::Kind kind)
{
  using From = stetro_supervisor::MotionCommand::Kind;
  using To = stetro_driver::MotionKind;
  switch (kind) {
    case From::kTwist:
      return To::kTwist;
    case From::kLift:
      return To::kLift;
    case From::kLower:
      return To::kLower;
    case From::kSteer:
      return To::kSteer;
    case From::kStop:
      return To::kStop;
    case From::kHold:
    case From::kNone:
      break;
  }
  return To::kHold;
}

stetro_supervisor::Integrity integrity_seen(stetro_localizer::Integrity integrity)
{
  using stetro_supervisor::Integrity;
  switch (integrity) {
    case stetro_localizer::Integrity::kOk:
      return Integrity::kOk;
    case stetro_localizer::Integrity::kDegraded:
      return Integrity::kDegraded;
    case stetro_localizer::Integrity::kLost:
      break;
  }
  return Integrity::kLost;
}

}  // namespace

stetro_localizer::OdometrySample to_odometry(const SensorFrame & frame)
{
  const auto & odometry = frame.odometry;
  return {odometry.stamp, odometry.vx_m_s, odometry.vy_m_s, odometry.wz_rad_s};
}

std::optional<stetro_localizer::GyroSample> to_gyro(const SensorFrame & frame)
{
  if (frame.gyro.fault || frame.gyro.stamp <= Time::zero()) {
    return std::nullopt;
  }
  return stetro_localizer::GyroSample{frame.gyro.stamp, frame.gyro.rate_rad_s[2]};
}

stetro_localizer::ContactSample to_contacts(const SensorFrame & frame)
{
  const auto at = [&](ContactPlace place) { return to_switch(frame.contact(place)); };
  return {
    frame.time,
    {at(ContactPlace::kLeftFront), at(ContactPlace::kLeftMiddle), at(ContactPlace::kLeftRear)},
    {at(ContactPlace::kRightFront), at(ContactPlace::kRightMiddle), at(ContactPlace::kRightRear)},
    at(ContactPlace::kRiserLeft),
    at(ContactPlace::kRiserRight)};
}

stetro_localizer::BlockSample to_blocks(const SensorFrame & frame)
{
  stetro_localizer::BlockSample sample;
  sample.stamp = frame.time;
  for (std::size_t i = 0; i < sample.blocks.size(); ++i) {
    const auto & from = frame.blocks[i];
    sample.blocks[i] = {from.fault ? 0.0 : from.height_m, from.load, true, from.moving, from.fault};
  }
  return sample;
}

std::optional<stetro_localizer::RangeSample> to_ranges(
  const SensorFrame & frame, stetro_localizer::Nanoseconds stale_after)
{
  stetro_localizer::RangeSample sample;
  sample.stamp = frame.time;
  for (std::size_t i = 0; i < stetro_driver::kRangePlaces; ++i) {
    const auto & from = frame.ranges[i];
    if (breaks_the_rules(from, frame.time)) {
      return std::nullopt;
    }
    const bool stale =
      from.status == stetro_driver::RangeStatus::kValid && from.stamp + stale_after < frame.time;
    sample[places()[i]] = {
      from.stamp, from.range_m, std::isfinite(from.std_dev_m) ? from.std_dev_m : 0.0,
      stale ? stetro_localizer::RangeStatus::kStale
            : status_as<stetro_localizer::RangeStatus>(from.status)};
  }
  return sample;
}

void observe_ranges(const SensorFrame & frame, stetro_supervisor::Observation & seen)
{
  const auto & ranges = frame.ranges;
  if (std::any_of(ranges.begin(), ranges.end(), [&](const auto & reading) {
        return breaks_the_rules(reading, frame.time);
      })) {
    return;
  }
  for (std::size_t i = 0; i < stetro_driver::kRangePlaces; ++i) {
    auto & last = seen.ranges[stetro_site::index_of(places()[i])];
    if (!last || last->measured != ranges[i].stamp) {  // a reading repeated is not a new one
      last = stetro_supervisor::Range{
        frame.time, ranges[i].range_m, status_as<stetro_supervisor::RangeStatus>(ranges[i].status),
        ranges[i].stamp};
    }
  }
}

void observe_contacts(const SensorFrame & frame, stetro_supervisor::Observation & seen)
{
  const auto at = [&](ContactPlace place) { return to_contact(frame.contact(place)); };
  seen.contacts = stetro_supervisor::Contacts{
    frame.time,
    {at(ContactPlace::kLeftFront), at(ContactPlace::kLeftMiddle), at(ContactPlace::kLeftRear)},
    {at(ContactPlace::kRightFront), at(ContactPlace::kRightMiddle), at(ContactPlace::kRightRear)},
    at(ContactPlace::kRiserLeft),
    at(ContactPlace::kRiserRight),
    at(ContactPlace::kEmergencyStop)};
}

void observe_blocks(const SensorFrame & frame, stetro_supervisor::Observation & seen)
{
  stetro_supervisor::Blocks blocks;
  blocks.time = frame.time;
  for (std::size_t i = 0; i < blocks.block.size(); ++i) {
    const auto & from = frame.blocks[i];
    blocks.block[i] = {from.height_m,      from.moving, from.at_lower_lock,
                       from.at_upper_lock, from.load,   from.fault};
  }
  blocks.steering_rad = frame.steering.angle_rad;
  blocks.steering_moving = frame.steering.moving;
  seen.blocks = blocks;
}

void observe_odometry(const SensorFrame & frame, stetro_supervisor::Observation & seen)
{
  const auto & odometry = frame.odometry;
  seen.odometry = stetro_supervisor::OdometryPose{
    frame.time, odometry.x_m, odometry.y_m, stetro_site::wrap_angle(odometry.yaw_rad)};
}

void observe_pose(
  const stetro_localizer::StairEstimate & estimate, const std::string & segment_id,
  stetro_supervisor::Observation & seen)
{
  const bool ok = estimate.integrity == stetro_localizer::Integrity::kOk;
  const bool finite = std::isfinite(estimate.pose.y_m) && std::isfinite(estimate.pose.yaw_rad);
  const bool old = seen.pose && estimate.stamp < seen.pose->time;
  if (estimate.stamp <= Time::zero() || old || (ok && !finite)) {
    return;
  }
  stetro_supervisor::StairPose pose;
  pose.time = estimate.stamp;
  pose.segment_id = segment_id;
  pose.on_flight = true;
  pose.step = estimate.step.value_or(-1);
  pose.x_m = estimate.pose.x_m;
  pose.tread_x_m = estimate.tread_x_m;
  pose.y_m = estimate.pose.y_m;
  pose.protection_along_m = estimate.protection_along_m;
  pose.heading_rad = finite ? estimate.pose.yaw_rad : stetro_supervisor::kNan;
  pose.integrity = integrity_seen(estimate.integrity);
  pose.reasons = estimate.reasons;
  seen.pose = pose;
}

stetro_driver::CommandRequest to_request(
  const stetro_supervisor::MotionCommand & command, std::uint64_t sequence_number, Time now,
  Time valid_for)
{
  stetro_driver::CommandRequest request;
  request.issuer = "supervisor";
  request.issuer_instance = 1;
  request.sequence_number = sequence_number;
  request.stamp = now;
  request.valid_for = valid_for;
  request.motion = {
    motion_kind(command.kind), command.vx_mps, command.vy_mps, command.wz_rps, command.block,
    command.steering_rad};
  return request;
}

}  // namespace stetro_bringup
