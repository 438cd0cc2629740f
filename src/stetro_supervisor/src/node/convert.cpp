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
#include "convert.hpp"

#include <cmath>
#include <limits>

#include "stetro_msgs/bounds.hpp"
#include "stetro_supervisor/pose_reason.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr std::int64_t kNanosPerSecond = 1'000'000'000;

namespace pose_wire = stetro_msgs::msg::StairPose_Constants;
static_assert(kNoSideRange == pose_wire::REASON_NO_SIDE_RANGE);
static_assert(kNoFrontReference == pose_wire::REASON_NO_FRONT_REFERENCE);
static_assert(kStepUncertain == pose_wire::REASON_STEP_UNCERTAIN);
static_assert(kNotInitialised == pose_wire::REASON_NOT_INITIALISED);
static_assert(kInputSilent == pose_wire::REASON_INPUT_SILENT);
static_assert(kCalibrationDamaged == pose_wire::REASON_CALIBRATION_DAMAGED);
static_assert(kClosureViolated == pose_wire::REASON_CLOSURE_VIOLATED);
static_assert(kSensorStuck == pose_wire::REASON_SENSOR_STUCK);
static_assert(kSensorDead == pose_wire::REASON_SENSOR_DEAD);
static_assert(kProfileDisagrees == pose_wire::REASON_PROFILE_DISAGREES);
static_assert(kProtectionExceeded == pose_wire::REASON_PROTECTION_EXCEEDED);
static_assert(kClockJump == pose_wire::REASON_CLOCK_JUMP);
static_assert(kContactConflict == pose_wire::REASON_CONTACT_CONFLICT);
static_assert(kSlip == pose_wire::REASON_SLIP);
static_assert(kSensorCalibration == pose_wire::REASON_SENSOR_CALIBRATION);
static_assert(kHeadingConflict == pose_wire::REASON_HEADING_CONFLICT);
static_assert(kOffTread == pose_wire::REASON_OFF_TREAD);
static_assert(kContactClosure == pose_wire::REASON_CONTACT_CLOSURE);

/// Of (x, y, heading); a metre and a radian where it is unknown.
Eigen::Matrix3d planar(const geometry_msgs::msg::PoseWithCovariance & pose)
{
  using Wire = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  const Eigen::Matrix3d covariance =
    stetro_site::planar(Eigen::Map<const Wire>(pose.covariance().data()));
  const bool known = covariance.allFinite() && covariance.diagonal().minCoeff() >= 0.0;
  return known ? covariance : Eigen::Matrix3d::Identity();
}

/// NaN means unknown on the wire; infinity means nothing there and is refused.
bool finite_or_unknown(double value) { return !std::isinf(value); }

std::optional<Contact> contact_of(const stetro_msgs::msg::ContactState & message)
{
  namespace wire = stetro_msgs::msg::ContactState_Constants;
  switch (message.state()) {
    case wire::STATE_UNKNOWN:
      return Contact{ContactState::kUnknown, message.fault()};
    case wire::STATE_OPEN:
      return Contact{ContactState::kOpen, message.fault()};
    case wire::STATE_CLOSED:
      return Contact{ContactState::kClosed, message.fault()};
    default:
      return std::nullopt;
  }
}

std::optional<RangeStatus> status_of(std::uint8_t status)
{
  namespace wire = stetro_msgs::msg::RangeReading_Constants;
  switch (status) {
    case wire::STATUS_UNKNOWN:
      return RangeStatus::kUnknown;
    case wire::STATUS_VALID:
      return RangeStatus::kValid;
    case wire::STATUS_TOO_NEAR:
      return RangeStatus::kTooNear;
    case wire::STATUS_NO_TARGET:
      return RangeStatus::kNoTarget;
    case wire::STATUS_WEAK:
      return RangeStatus::kWeak;
    case wire::STATUS_STALE:
      return RangeStatus::kStale;
    case wire::STATUS_FAULT:
      return RangeStatus::kFault;
    default:
      return std::nullopt;
  }
}

std::optional<Block> block_of(const stetro_msgs::msg::BlockState & message)
{
  const bool sound = finite_or_unknown(message.height()) && !(message.height() < 0.0) &&
                     !(message.load() < 0.0) && !(message.load() > 1.0);
  if (!sound) {
    return std::nullopt;
  }
  return Block{message.height(),        message.moving(), message.at_lower_lock(),
               message.at_upper_lock(), message.load(),   message.fault()};
}

double yaw_of(const geometry_msgs::msg::Quaternion & q)
{
  return std::atan2(
    2.0 * (q.w() * q.z() + q.x() * q.y()), 1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
}

bool is_unit(const geometry_msgs::msg::Quaternion & q)
{
  const double norm = q.x() * q.x() + q.y() * q.y() + q.z() * q.z() + q.w() * q.w();
  return std::abs(norm - 1.0) < 1e-3;  // false for NaN
}

Integrity integrity_of(std::uint8_t integrity)
{
  namespace wire = stetro_msgs::msg::StairPose_Constants;
  switch (integrity) {
    case wire::INTEGRITY_OK:
      return Integrity::kOk;
    case wire::INTEGRITY_DEGRADED:
      return Integrity::kDegraded;
    case wire::INTEGRITY_LOST:
      return Integrity::kLost;
    default:
      return Integrity::kUnknown;
  }
}

bool is_upright(const geometry_msgs::msg::Quaternion & q)
{
  return is_unit(q) && std::hypot(q.x(), q.y()) < 0.05;
}

ToldPose told_by(const stetro_msgs::msg::MissionRequest & message)
{
  const auto & pose = message.pose().pose();
  const auto & at = pose.position();
  const double yaw_rad = is_upright(pose.orientation()) ? yaw_of(pose.orientation()) : kNan;
  ToldPose told;
  told.frame_id = message.header().frame_id().c_str();
  told.pose = {at.x(), at.y(), at.z(), yaw_rad};
  told.step = message.step();
  for (int i = 0; i < 36; ++i) {
    told.covariance(i / 6, i % 6) = message.pose().covariance()[static_cast<std::size_t>(i)];
  }
  return told;
}

std_msgs::msg::Header header(Time now, const std::string & frame)
{
  std_msgs::msg::Header result;
  result.stamp(stamp_of(now));
  result.frame_id(frame);
  return result;
}

}  // namespace

std::optional<Refusal> take(
  const stetro_msgs::msg::RangeArray & message, Time received, Observation & seen)
{
  Observation next = seen;
  for (const auto & reading : message.readings()) {
    const std::string name = reading.sensor().c_str();
    const auto place = stetro_site::place_named(name);
    const auto status = status_of(reading.status());
    if (!place) {
      return Refusal{"unknown_sensor", "'" + name + "', accepted: the places of the robot file"};
    }
    if (
      !status || (*status == RangeStatus::kValid &&
                  !(reading.range() >= 0.0 && std::isfinite(reading.range())))) {
      return Refusal{
        "bad_range", name + ": " + std::to_string(reading.range()) + " m, status " +
                       std::to_string(reading.status())};
    }
    auto & last = next.ranges[stetro_site::index_of(*place)];
    const Time measured = time_of(reading.stamp());
    if (!last || last->measured != measured) {
      last = Range{received, reading.range(), *status, measured};
    }
  }
  seen = next;
  return std::nullopt;
}

std::optional<Refusal> take(const stetro_msgs::msg::Contacts & m, Time received, Observation & seen)
{
  const std::array<std::optional<Contact>, 9> all{
    contact_of(m.left_front()),  contact_of(m.left_middle()),  contact_of(m.left_rear()),
    contact_of(m.right_front()), contact_of(m.right_middle()), contact_of(m.right_rear()),
    contact_of(m.riser_left()),  contact_of(m.riser_right()),  contact_of(m.emergency_stop())};
  for (const auto & contact : all) {
    if (!contact) {
      return Refusal{"bad_contact", "a state is none of those defined"};
    }
  }
  seen.contacts = Contacts{
    received, {*all[0], *all[1], *all[2]}, {*all[3], *all[4], *all[5]}, *all[6], *all[7], *all[8]};
  return std::nullopt;
}

std::optional<Refusal> take(
  const stetro_msgs::msg::BlockStates & message, Time received, Observation & seen)
{
  const auto front = block_of(message.block1());
  const auto middle = block_of(message.block2());
  const auto rear = block_of(message.block3());
  if (!front || !middle || !rear || !finite_or_unknown(message.steering_angle())) {
    return Refusal{"bad_blocks", "a height below 0, a load outside 0 to 1, or an infinite value"};
  }
  seen.blocks =
    Blocks{received, {*front, *middle, *rear}, message.steering_angle(), message.steering_moving()};
  return std::nullopt;
}

std::optional<Refusal> take(
  const nav_msgs::msg::Odometry & message, Time received, Observation & seen)
{
  const auto & pose = message.pose().pose();
  const double x = pose.position().x();
  const double y = pose.position().y();
  if (!std::isfinite(x) || !std::isfinite(y) || !is_unit(pose.orientation())) {
    return Refusal{"not_finite", "position not finite, or orientation no unit quaternion"};
  }
  seen.odometry = OdometryPose{received, x, y, yaw_of(pose.orientation())};
  return std::nullopt;
}

std::optional<Refusal> take(
  const stetro_msgs::msg::StairPose & message, Time received, Observation & seen)
{
  namespace wire = stetro_msgs::msg::StairPose_Constants;
  const auto & pose = message.pose().pose();
  const Integrity integrity = integrity_of(message.integrity());
  const bool finite = std::isfinite(pose.position().y()) && is_unit(pose.orientation());
  if (integrity == Integrity::kOk && !finite) {
    return Refusal{"not_finite", "integrity OK with y not finite or no unit quaternion"};
  }
  StairPose stair;
  stair.time = received;
  stair.segment_id = message.segment_id().c_str();
  stair.on_flight = message.segment_kind() == wire::SEGMENT_FLIGHT;
  stair.step = message.step_index();
  stair.x_m = pose.position().x();
  stair.tread_x_m = message.tread_x();
  stair.protection_along_m = message.protection_along();
  stair.y_m = pose.position().y();
  stair.covariance = planar(message.pose());
  stair.heading_rad = finite ? yaw_of(pose.orientation()) : kNan;
  stair.integrity = integrity;
  stair.reasons = message.reasons();
  stair.resets = message.reset_counter();
  seen.pose = stair;
  return std::nullopt;
}

std::optional<Refusal> take(
  const stetro_msgs::msg::CommandStatus & message, Time received, Observation & seen)
{
  namespace wire = stetro_msgs::msg::CommandStatus_Constants;
  const bool replaced = message.reason() == wire::REASON_REPLACED;
  const bool refused = message.outcome() == wire::OUTCOME_REFUSED && !replaced;
  if (!refused && message.outcome() == wire::OUTCOME_EXPIRED) {
    return std::nullopt;  // says nothing about the command that renewed it
  }
  std::string reason;
  if (refused) {
    reason =
      "reason " + std::to_string(message.reason()) + " " + std::string(message.detail().c_str());
  }
  seen.driver_answer = DriverAnswer{received, refused, reason};
  return std::nullopt;
}

std::optional<Refusal> doubt_of(const stetro_msgs::msg::MissionRequest & message)
{
  if (message.request_id().size() == 0 || message.issuer().size() == 0) {
    return Refusal{"empty_id", "request_id or issuer is empty, accepted: both given"};
  }
  if (stetro_msgs::fills_a_string(message)) {
    return Refusal{
      "full_string",
      "request_id, issuer or segment_id fills its 64 bytes and may be cut, accepted: at most 63"};
  }
  return std::nullopt;
}

MissionRequest from_message(const stetro_msgs::msg::MissionRequest & message)
{
  namespace wire = stetro_msgs::msg::MissionRequest_Constants;
  const auto kind = [&] {
    switch (message.kind()) {
      case wire::KIND_CLEAN_FLIGHT:
        return RequestKind::kCleanFlight;
      case wire::KIND_GO_TO_SEGMENT:
        return RequestKind::kGoToSegment;
      case wire::KIND_RELOCALISE:
        return RequestKind::kRelocalise;
      case wire::KIND_PAUSE:
        return RequestKind::kPause;
      case wire::KIND_RESUME:
        return RequestKind::kResume;
      case wire::KIND_ABORT:
        return RequestKind::kAbort;
      case wire::KIND_CLEAR_FAULT:
        return RequestKind::kClearFault;
      case wire::KIND_CHECK_POSE:
        return RequestKind::kCheckPose;
      default:
        return RequestKind::kUnknown;
    }
  };
  MissionRequest request{
    message.request_id().c_str(), message.issuer().to_string(), kind(),
    message.segment_id().c_str()};
  if (request.kind == RequestKind::kRelocalise) {
    request.told = told_by(message);
  }
  return request;
}

geometry_msgs::msg::PoseWithCovarianceStamped told_to_localizer(
  const stetro_msgs::msg::MissionRequest & message, Time stamp)
{
  geometry_msgs::msg::PoseWithCovarianceStamped told;
  told.header(header(stamp, message.header().frame_id().c_str()));
  told.pose(message.pose());
  return told;
}

stetro_msgs::msg::Command to_message(
  const MotionCommand & command, const Issuer & issuer, std::uint64_t sequence, Time now)
{
  namespace wire = stetro_msgs::msg::Command_Constants;
  const auto kind = [&] {
    switch (command.kind) {
      case MotionCommand::Kind::kTwist:
        return wire::KIND_TWIST;
      case MotionCommand::Kind::kLift:
        return wire::KIND_LIFT;
      case MotionCommand::Kind::kLower:
        return wire::KIND_LOWER;
      case MotionCommand::Kind::kSteer:
        return wire::KIND_STEER;
      case MotionCommand::Kind::kStop:
        return wire::KIND_STOP;
      default:
        return wire::KIND_HOLD;
    }
  };
  stetro_msgs::msg::Command message;
  message.header(header(now, "base_link"));
  message.sequence_number(sequence);
  message.issuer(issuer.name);
  message.issuer_instance(issuer.instance);
  message.valid_for().sec(static_cast<std::int32_t>(issuer.valid_for.count() / kNanosPerSecond));
  message.valid_for().nanosec(
    static_cast<std::uint32_t>(issuer.valid_for.count() % kNanosPerSecond));
  message.kind(kind());
  message.vx(command.vx_mps);
  message.vy(command.vy_mps);
  message.wz(command.wz_rps);
  message.block(static_cast<std::uint8_t>(command.block));
  message.steering_angle(command.steering_rad);
  return message;
}

}  // namespace stetro_supervisor
