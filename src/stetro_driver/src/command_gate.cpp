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

#include "stetro_driver/command_gate.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stetro_driver
{
namespace
{

constexpr double kHalfPi = 1.57079632679489661923;
constexpr std::size_t kIssuersRemembered = 16;

Verdict refuse(Refusal reason, std::string detail) { return Verdict{reason, std::move(detail)}; }

std::string seconds_text(Time time) { return std::to_string(time_to_seconds(time)) + " s"; }

void require_positive(double value, const char * name)
{
  if (!(std::isfinite(value) && value > 0.0)) {
    throw std::invalid_argument(
      std::string(name) + " is " + std::to_string(value) + ", accepted: finite and above 0");
  }
}

Verdict judge_speed(const char * name, double value, double limit)
{
  if (std::abs(value) <= limit) {
    return {};
  }
  return refuse(
    Refusal::kOutOfBounds,
    std::string(name) + " " + std::to_string(value) + ", at most " + std::to_string(limit));
}

Verdict judge_steering(
  const JointCommand & motion, const GateSituation & situation, double tolerance_rad)
{
  const bool along_x = motion.vx_m_s != 0.0;
  const bool along_y = motion.vy_m_s != 0.0 || motion.wz_rad_s != 0.0;
  if (!along_x && !along_y) {
    return {};
  }
  const auto stands_at = [&](double angle_rad) {
    return !situation.steering_moving &&
           std::abs(situation.steering_rad - angle_rad) <= tolerance_rad;
  };
  const std::string wheels = "wheels at " + std::to_string(situation.steering_rad) + " rad";
  if (along_x && !stands_at(0.0)) {
    return refuse(Refusal::kWrongSteering, "vx needs the wheels at 0, " + wheels);
  }
  if (along_y && !stands_at(kHalfPi)) {
    return refuse(Refusal::kWrongSteering, "vy and wz need the wheels at pi/2, " + wheels);
  }
  return {};
}

Verdict judge_support(int block, const std::array<bool, 3> & standing)
{
  const bool carried = block == 2 ? standing[0] && standing[2] : standing[1];
  if (carried) {
    return {};
  }
  return refuse(
    Refusal::kUnsafe, block == 2 ? "block 2 is lifted only while 1 and 3 stand"
                                 : "blocks 1 and 3 are lifted only while 2 stands");
}

}  // namespace

std::string_view to_string(Refusal reason)
{
  constexpr std::array<std::string_view, kRefusals> kNames{
    "none",           "out_of_order", "foreign_issuer", "not_finite", "out_of_bounds",
    "wrong_steering", "not_active",   "emergency_stop", "fault",      "bad_stamp",
    "not_supported",  "unknown_kind", "bad_issuer",     "busy",       "unsafe"};
  return kNames[static_cast<std::size_t>(reason)];
}

CommandGate::CommandGate(const GateLimits & limits) : limits_(limits)
{
  require_positive(limits.max_vx_m_s, "max_vx_m_s");
  require_positive(limits.max_vy_m_s, "max_vy_m_s");
  require_positive(limits.max_wz_rad_s, "max_wz_rad_s");
  require_positive(limits.steering_tolerance_rad, "steering_tolerance_rad");
  require_positive(time_to_seconds(limits.max_valid_for), "max_valid_for");
  require_positive(time_to_seconds(limits.stall_limit), "stall_limit");
  if (limits.max_skew < Time::zero()) {
    throw std::invalid_argument(
      "max_skew is " + seconds_text(limits.max_skew) + ", accepted: 0 or more");
  }
}

Verdict CommandGate::offer(
  const CommandRequest & request, const GateClocks & clocks, const GateSituation & situation)
{
  observe(clocks);
  Verdict verdict = judge_content(request);
  if (verdict.accepted()) {
    verdict = judge_stamp(request, clocks.now);
  }
  if (verdict.accepted()) {
    verdict = judge_issuer(request);
  }
  if (verdict.accepted()) {
    listen_for_reset(request, situation);
    verdict = judge_situation(request.motion, situation);
  }
  if (!verdict.accepted()) {
    ++counters_.refused[static_cast<std::size_t>(verdict.reason)];
    return verdict;
  }
  ++counters_.accepted;
  remember(request);
  lease_ = Lease{
    Expiry{request.issuer, request.issuer_instance, request.sequence_number}, request.motion,
    std::min(request.stamp, clocks.now) + request.valid_for, clocks.steady};
  return verdict;
}

InForce CommandGate::in_force(const GateClocks & clocks)
{
  observe(clocks);
  InForce result;
  if (lease_) {
    result.command = lease_->command;
    result.until = lease_->deadline;
  }
  result.expired = std::move(expired_);
  expired_.reset();
  return result;
}

void CommandGate::drop()
{
  lease_.reset();
  expired_.reset();
}

void CommandGate::latch_emergency_stop()
{
  emergency_stop_ = true;
  drop();
}

void CommandGate::reset_emergency_stop()
{
  emergency_stop_ = false;
  stoppers_.clear();
  reset_asked_ = false;
}

void CommandGate::listen_for_reset(const CommandRequest & request, const GateSituation & situation)
{
  const bool latched = emergency_stop_ || situation.emergency_stop;
  if (!latched && !situation.fault && !situation.refused_power) {
    return;
  }
  const auto mine = std::find_if(stoppers_.begin(), stoppers_.end(), [&](const Expiry & stopper) {
    return stopper.issuer_instance == request.issuer_instance && stopper.issuer == request.issuer;
  });
  if (request.motion.kind == MotionKind::kStop) {
    if (mine != stoppers_.end()) {
      stoppers_.erase(mine);
    }
    stoppers_.push_back({request.issuer, request.issuer_instance, request.sequence_number});
    if (stoppers_.size() > kIssuersRemembered) {
      stoppers_.pop_front();
    }
  } else if (mine != stoppers_.end() && mine->sequence_number < request.sequence_number) {
    reset_asked_ = request.motion.kind == MotionKind::kHold && !situation.emergency_stop_pressed;
    stoppers_.erase(mine);
  }
}

void CommandGate::observe(const GateClocks & clocks)
{
  // Time that a command spent under a clock that stood still, also when it goes on by now.
  const bool stalled =
    lease_ &&
    clocks.steady - std::max(last_advance_.steady, lease_->received_steady) >= limits_.stall_limit;
  if (!clock_seen_ || clocks.now != last_advance_.now) {
    last_advance_ = clocks;
    clock_seen_ = true;
  }
  if (!lease_ || (clocks.now < lease_->deadline && !stalled)) {
    return;
  }
  ++counters_.expired;
  counters_.stalls += stalled ? 1 : 0;
  expired_ = std::move(lease_->holder);
  lease_.reset();
}

Verdict CommandGate::judge_content(const CommandRequest & request) const
{
  if (request.issuer.empty() || request.issuer_instance == 0) {
    return refuse(Refusal::kBadIssuer, "issuer empty or instance zero");
  }
  if (request.issuer_cut) {
    return refuse(Refusal::kBadIssuer, "issuer fills its field and may be cut, accepted: shorter");
  }
  const JointCommand & motion = request.motion;
  if (motion.kind >= MotionKind::kUnknown) {
    return refuse(
      Refusal::kUnknownKind, "kind is not one of twist, lift, lower, steer, hold, stop");
  }
  const auto finite = {motion.vx_m_s, motion.vy_m_s, motion.wz_rad_s, motion.steering_rad};
  if (!std::all_of(finite.begin(), finite.end(), [](double v) { return std::isfinite(v); })) {
    return refuse(Refusal::kNotFinite, "a speed or an angle is NaN or infinite");
  }
  if (request.valid_for <= Time::zero() || request.valid_for > limits_.max_valid_for) {
    return refuse(
      Refusal::kOutOfBounds, "valid_for " + seconds_text(request.valid_for) +
                               ", above 0 and at most " + seconds_text(limits_.max_valid_for));
  }
  switch (motion.kind) {
    case MotionKind::kTwist:
      for (const Verdict & verdict :
           {judge_speed("vx", motion.vx_m_s, limits_.max_vx_m_s),
            judge_speed("vy", motion.vy_m_s, limits_.max_vy_m_s),
            judge_speed("wz", motion.wz_rad_s, limits_.max_wz_rad_s)}) {
        if (!verdict.accepted()) {
          return verdict;
        }
      }
      return {};
    case MotionKind::kLift:
    case MotionKind::kLower:
      if (motion.block < 1 || motion.block > 3) {
        return refuse(
          Refusal::kOutOfBounds, "block " + std::to_string(motion.block) + ", accepted: 1, 2, 3");
      }
      return {};
    case MotionKind::kSteer:
      if (
        motion.steering_rad < -limits_.steering_tolerance_rad ||
        motion.steering_rad > kHalfPi + limits_.steering_tolerance_rad) {
        return refuse(
          Refusal::kOutOfBounds,
          "steering_angle " + std::to_string(motion.steering_rad) + ", accepted: 0 to pi/2");
      }
      return {};
    default:
      return {};
  }
}

Verdict CommandGate::judge_stamp(const CommandRequest & request, Time now) const
{
  if (request.stamp <= Time::zero()) {
    return refuse(Refusal::kBadStamp, "stamp zero or negative");
  }
  const Time age = now - request.stamp;
  if (age < -limits_.max_skew) {
    return refuse(Refusal::kBadStamp, "stamp " + seconds_text(-age) + " in the future");
  }
  if (age >= request.valid_for) {
    return refuse(Refusal::kBadStamp, "expired on arrival, " + seconds_text(age) + " old");
  }
  return {};
}

Verdict CommandGate::judge_issuer(const CommandRequest & request) const
{
  if (lease_) {
    const Expiry & holder = lease_->holder;
    if (holder.issuer != request.issuer || holder.issuer_instance != request.issuer_instance) {
      return refuse(Refusal::kForeignIssuer, "the lease is held by " + holder.issuer);
    }
  }
  const Issuer * known = find_issuer(request);
  if (known != nullptr && request.sequence_number <= known->last_sequence) {
    return refuse(
      Refusal::kOutOfOrder, "sequence_number " + std::to_string(request.sequence_number) +
                              ", accepted: above " + std::to_string(known->last_sequence));
  }
  return {};
}

Verdict CommandGate::judge_situation(
  const JointCommand & motion, const GateSituation & situation) const
{
  if (emergency_stop_ || situation.emergency_stop) {
    return refuse(Refusal::kEmergencyStop, "the emergency stop is latched");
  }
  if (!situation.active) {
    return refuse(Refusal::kNotActive, "the driver is not active");
  }
  if (situation.fault) {
    return refuse(Refusal::kFault, "the hardware has a fault");
  }
  if (motion.kind == MotionKind::kTwist) {
    return judge_steering(motion, situation, limits_.steering_tolerance_rad);
  }
  if (motion.kind == MotionKind::kLift) {
    return judge_support(motion.block, situation.standing);
  }
  return {};
}

const CommandGate::Issuer * CommandGate::find_issuer(const CommandRequest & request) const
{
  const auto found = std::find_if(issuers_.begin(), issuers_.end(), [&](const Issuer & issuer) {
    return issuer.instance == request.issuer_instance && issuer.name == request.issuer;
  });
  return found == issuers_.end() ? nullptr : &*found;
}

void CommandGate::remember(const CommandRequest & request)
{
  const auto forgotten =
    std::remove_if(issuers_.begin(), issuers_.end(), [&](const Issuer & issuer) {
      return issuer.instance == request.issuer_instance && issuer.name == request.issuer;
    });
  issuers_.erase(forgotten, issuers_.end());
  issuers_.push_back({request.issuer, request.issuer_instance, request.sequence_number});
  if (issuers_.size() > kIssuersRemembered) {
    issuers_.pop_front();
  }
}

}  // namespace stetro_driver
