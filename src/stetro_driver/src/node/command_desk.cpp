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

#include "node/command_desk.hpp"

#include <cmath>

#include "stetro_dds/instance_id.hpp"
#include "stetro_dds/qos.hpp"

namespace stetro_driver
{
namespace
{

namespace status = stetro_msgs::msg::CommandStatus_Constants;

constexpr std::size_t kLongestDetail = 128;
constexpr double kAngleReached = 0.03;  // what the gate takes for a direction [rad]

bool reached(const JointCommand & motion, const SensorFrame & frame)
{
  switch (motion.kind) {
    case MotionKind::kLift:
      return frame.block(motion.block).at_upper_lock;
    case MotionKind::kLower:
      return frame.block(motion.block).at_lower_lock;
    case MotionKind::kSteer:
      return !frame.steering.moving &&
             std::abs(frame.steering.angle_rad - motion.steering_rad) < kAngleReached;
    default:
      return false;
  }
}

}  // namespace

CommandDesk::CommandDesk(stetro_dds::Node & node, const GateLimits & limits)
: node_(node),
  gate_(limits),
  driver_instance_(stetro_dds::draw_instance_id()),
  status_(node.advertise<stetro_msgs::msg::CommandStatus>(
    "command_status", stetro_dds::qos::kCommandStatus))
{
}

std::optional<stetro_dds::Refusal> CommandDesk::offer(
  const CommandRequest & request, const GateClocks & clocks, const GateSituation & situation)
{
  const Verdict verdict = gate_.offer(request, clocks, situation);
  const Expiry who{request.issuer, request.issuer_instance, request.sequence_number};
  if (!verdict.accepted()) {
    tell(
      who, status::OUTCOME_REFUSED, static_cast<std::uint8_t>(verdict.reason), verdict.detail,
      clocks.now);
    return stetro_dds::Refusal{std::string(to_string(verdict.reason)), verdict.detail};
  }
  // A renewal of what is already concluded concludes again: its sender may have missed the first.
  current_ = Current{who, request.motion};
  tell(who, status::OUTCOME_ACCEPTED, status::REASON_NONE, "", clocks.now);
  return std::nullopt;
}

InForce CommandDesk::in_force(const GateClocks & clocks)
{
  InForce in_force = gate_.in_force(clocks);
  if (in_force.expired) {
    tell(*in_force.expired, status::OUTCOME_EXPIRED, status::REASON_NONE, "", clocks.now);
    current_.reset();
  }
  return in_force;
}

void CommandDesk::observe(const SensorFrame & frame)
{
  if (current_ && !current_->concluded && reached(current_->motion, frame)) {
    current_->concluded = true;
    tell(current_->who, status::OUTCOME_DONE, status::REASON_NONE, "", frame.time);
  }
}

void CommandDesk::give_up(const IoFault & fault, Time now)
{
  if (!current_ || current_->concluded) {
    return;
  }
  current_->concluded = true;
  std::uint8_t reason = status::REASON_FAULT;
  if (fault.kind == IoFaultKind::kEmergencyStop) {
    reason = status::REASON_EMERGENCY_STOP;
  } else if (fault.kind == IoFaultKind::kWrongSteering) {
    reason = status::REASON_WRONG_STEERING;
  } else if (fault.kind == IoFaultKind::kNotActive) {
    reason = status::REASON_NOT_ACTIVE;
  }
  tell(current_->who, status::OUTCOME_REFUSED, reason, fault.detail, now);
}

void CommandDesk::tell(
  const Expiry & who, std::uint8_t outcome, std::uint8_t reason, const std::string & detail,
  Time now)
{
  stetro_msgs::msg::CommandStatus message;
  message.header(header_of(now, "base_link"));
  message.sequence_number(who.sequence_number);
  message.issuer(who.issuer);
  message.issuer_instance(who.issuer_instance);
  message.driver_instance(driver_instance_);
  message.outcome(outcome);
  message.reason(reason);
  message.detail(detail.substr(0, kLongestDetail));
  message.driver_state(driver_state());
  status_.publish(message);
}

std::uint8_t CommandDesk::driver_state() const
{
  switch (node_.lifecycle().state()) {
    case stetro_dds::LifecycleState::kUnconfigured:
      return status::DRIVER_UNCONFIGURED;
    case stetro_dds::LifecycleState::kInactive:
      return status::DRIVER_INACTIVE;
    case stetro_dds::LifecycleState::kActive:
      return status::DRIVER_ACTIVE;
    case stetro_dds::LifecycleState::kFinalized:
      return status::DRIVER_FINALIZED;
  }
  return status::DRIVER_UNKNOWN;
}

}  // namespace stetro_driver
