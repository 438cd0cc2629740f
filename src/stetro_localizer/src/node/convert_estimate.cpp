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

#include <cmath>

#include "node/convert.hpp"

namespace stetro_localizer
{
namespace
{

namespace wire = stetro_msgs::msg::StairPose_Constants;

static_assert(kNoSideRange == wire::REASON_NO_SIDE_RANGE);
static_assert(kNoFrontReference == wire::REASON_NO_FRONT_REFERENCE);
static_assert(kStepUncertain == wire::REASON_STEP_UNCERTAIN);
static_assert(kNotInitialised == wire::REASON_NOT_INITIALISED);
static_assert(kInputSilent == wire::REASON_INPUT_SILENT);
static_assert(kCalibrationDamaged == wire::REASON_CALIBRATION_DAMAGED);
static_assert(kClosureViolated == wire::REASON_CLOSURE_VIOLATED);
static_assert(kSensorStuck == wire::REASON_SENSOR_STUCK);
static_assert(kSensorDead == wire::REASON_SENSOR_DEAD);
static_assert(kProfileDisagrees == wire::REASON_PROFILE_DISAGREES);
static_assert(kProtectionExceeded == wire::REASON_PROTECTION_EXCEEDED);
static_assert(kContactConflict == wire::REASON_CONTACT_CONFLICT);
static_assert(kSlip == wire::REASON_SLIP);
static_assert(kSensorCalibration == wire::REASON_SENSOR_CALIBRATION);
static_assert(kHeadingConflict == wire::REASON_HEADING_CONFLICT);
static_assert(kOffTread == wire::REASON_OFF_TREAD);
static_assert(kContactClosure == wire::REASON_CONTACT_CLOSURE);

std::uint8_t integrity_of(Integrity integrity)
{
  switch (integrity) {
    case Integrity::kOk:
      return wire::INTEGRITY_OK;
    case Integrity::kDegraded:
      return wire::INTEGRITY_DEGRADED;
    case Integrity::kLost:
      return wire::INTEGRITY_LOST;
  }
  return wire::INTEGRITY_UNKNOWN;
}

std::uint8_t kind_of(SegmentKind kind)
{
  switch (kind) {
    case SegmentKind::kNowhere:
      return wire::SEGMENT_UNKNOWN;
    case SegmentKind::kFloor:
      return wire::SEGMENT_FLOOR;
    case SegmentKind::kFlight:
      return wire::SEGMENT_FLIGHT;
  }
  return wire::SEGMENT_UNKNOWN;
}

std::uint8_t outcome_of(Outcome outcome)
{
  namespace code = stetro_msgs::msg::Innovation_Constants;
  switch (outcome) {
    case Outcome::kFused:
      return code::OUTCOME_FUSED;
    case Outcome::kGated:
      return code::OUTCOME_GATED;
    case Outcome::kStale:
      return code::OUTCOME_STALE;
    case Outcome::kNotVisible:
      return code::OUTCOME_NOT_VISIBLE;
    case Outcome::kNone:
    case Outcome::kRefused:
      break;
  }
  return code::OUTCOME_UNKNOWN;
}

geometry_msgs::msg::Quaternion turned(double yaw_rad)
{
  geometry_msgs::msg::Quaternion q;
  q.x(0.0);
  q.y(0.0);
  q.z(std::sin(yaw_rad / 2.0));
  q.w(std::cos(yaw_rad / 2.0));
  return q;
}

void fill_pose(
  geometry_msgs::msg::PoseWithCovariance & message, const stetro_site::Pose & pose,
  const stetro_site::Covariance & covariance)
{
  message.pose().position().x(pose.x_m);
  message.pose().position().y(pose.y_m);
  message.pose().position().z(pose.z_m);
  message.pose().orientation(turned(pose.yaw_rad));
  for (int i = 0; i < 36; ++i) {
    message.covariance()[static_cast<std::size_t>(i)] = covariance(i / 6, i % 6);
  }
}

void fill_header(std_msgs::msg::Header & header, Nanoseconds stamp, const std::string & frame)
{
  header.stamp(stamp_of(stamp));
  header.frame_id(frame);
}

void add_transform(
  tf2_msgs::msg::TFMessage & message, Nanoseconds now, const std::string & child,
  const stetro_site::Pose & pose)
{
  geometry_msgs::msg::TransformStamped transform;
  fill_header(transform.header(), now, "map");
  transform.child_frame_id(child);
  transform.transform().translation().x(pose.x_m);
  transform.transform().translation().y(pose.y_m);
  transform.transform().translation().z(pose.z_m);
  transform.transform().rotation(turned(pose.yaw_rad));
  message.transforms().push_back(transform);
}

}  // namespace

bool is_known(const stetro_site::Pose & pose)
{
  return std::isfinite(pose.x_m + pose.y_m + pose.z_m + pose.yaw_rad);
}

void fill(
  geometry_msgs::msg::PoseWithCovarianceStamped & message, const StairEstimate & estimate,
  const Segment & segment)
{
  fill_header(message.header(), estimate.stamp, "map");
  fill_pose(
    message.pose(), segment.T_map_segment.to_map(estimate.pose),
    segment.T_map_segment.to_map(estimate.covariance));
}

void fill(
  stetro_msgs::msg::StairPose & message, const StairEstimate & estimate, const Segment & segment)
{
  fill_header(message.header(), estimate.stamp, segment.frame_id());
  message.segment_id(segment.id);
  message.segment_kind(kind_of(segment.kind));
  message.step_index(estimate.step.value_or(wire::STEP_UNKNOWN));
  message.step_count(segment.steps);
  message.step_probability(estimate.step_probability);
  fill_pose(message.pose(), estimate.pose, estimate.covariance);
  message.tread_x(estimate.tread_x_m);
  message.tread_y(estimate.tread_y_m);
  message.block_heights(estimate.block_heights_m);
  message.integrity(integrity_of(estimate.integrity));
  message.reasons(estimate.reasons);
  message.protection_along(estimate.protection_along_m);
  message.protection_across(estimate.protection_across_m);
  message.protection_heading(estimate.protection_heading_rad);
  message.integrity_risk(estimate.integrity_risk);
  message.reset_counter(estimate.reset_counter);
  message.reset_delta_x(estimate.reset_delta.x_m);
  message.reset_delta_y(estimate.reset_delta.y_m);
  message.reset_delta_z(estimate.reset_delta.z_m);
  message.reset_delta_heading(estimate.reset_delta.yaw_rad);
}

void fill(
  stetro_msgs::msg::Innovations & message, const Estimator & estimator, const Segment & segment)
{
  fill_header(message.header(), estimator.estimate().stamp, segment.frame_id());
  const std::vector<Source> & compared = estimator.compared();
  message.innovations().resize(compared.size());
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const SourceReport & report = estimator.reports()[compared[i]];
    auto & to = message.innovations()[i];
    to.source(std::string(to_string(compared[i])));
    to.innovation(report.innovation);
    to.innovation_variance(report.innovation_variance);
    to.test_ratio(report.test_ratio);
    to.outcome(outcome_of(report.outcome));
    to.reject_count(report.reject_streak);
  }
  const auto biases = estimator.biases();
  message.biases().resize(biases.size());
  for (std::size_t i = 0; i < biases.size(); ++i) {
    auto & to = message.biases()[i];
    to.name(std::string(biases[i].name));
    to.value(biases[i].estimate.value);
    to.variance(biases[i].estimate.variance);
  }
}

void fill(
  tf2_msgs::msg::TFMessage & message, const StairEstimate & estimate, const Segment & segment,
  const stetro_site::Pose & odom)
{
  const stetro_site::Pose base = segment.T_map_segment.to_map(estimate.pose);
  const double yaw_rad = base.yaw_rad - odom.yaw_rad;
  message.transforms().resize(1);
  auto & transform = message.transforms().front();
  fill_header(transform.header(), estimate.stamp, "map");
  transform.child_frame_id("odom");
  auto & to = transform.transform();
  to.translation().x(base.x_m - (std::cos(yaw_rad) * odom.x_m - std::sin(yaw_rad) * odom.y_m));
  to.translation().y(base.y_m - (std::sin(yaw_rad) * odom.x_m + std::cos(yaw_rad) * odom.y_m));
  to.translation().z(base.z_m - odom.z_m);
  to.rotation(turned(yaw_rad));
}

tf2_msgs::msg::TFMessage to_static_transforms(Nanoseconds now, const stetro_site::Site & site)
{
  tf2_msgs::msg::TFMessage message;
  for (const stetro_site::Flight & flight : site.flights()) {
    add_transform(message, now, flight.id(), flight.spec().pose_in_map);
  }
  for (const stetro_site::Floor & floor : site.floors()) {
    if (floor.is_drawn()) {
      add_transform(message, now, floor.id, floor.pose_in_map);
    }
  }
  return message;
}

}  // namespace stetro_localizer
