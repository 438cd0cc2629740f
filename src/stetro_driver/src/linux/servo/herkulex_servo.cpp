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

#include "linux/servo/herkulex_servo.hpp"

#include <utility>

namespace stetro_driver::linux_io
{
namespace
{

constexpr int kTries = 3;                  // of a request that sets up
constexpr std::uint64_t kMissesTaken = 1;  // in a row, of a state
constexpr std::uint8_t kAckReadsOnly = 1;
constexpr std::uint8_t kModel0101 = 0x01;
constexpr std::uint8_t kModel0201 = 0x02;
constexpr double kDifferentialUnit = 29.09 * kRadPerDegree;  // [rad/s]

// The state's registers. Every other request begins one lower: a reply that comes a whole request
// late is never taken for the one that is awaited.
constexpr std::uint8_t kStateFrom = ram::kTorqueControl;
constexpr std::uint8_t kStateSize = ram::kPwm + 2 - kStateFrom;

}  // namespace

HerkulexServo::HerkulexServo(const std::string & name, std::uint8_t id, const ServoSetup & setup)
: name_(name + " (servo " + std::to_string(id) + ")"), id_(id), setup_(setup), health_(name_)
{
}

IoFault HerkulexServo::failed(HerkulexBus & bus, IoFault fault)
{
  health_.failed(bus.clock().now(), fault);
  return fault;
}

void HerkulexServo::forget(Time now, const IoFault & fault)
{
  health_.failed(now, fault);
  ready_ = false;
}

std::optional<IoFault> HerkulexServo::latched() const
{
  if ((state_.errors & kGrave) == 0) {
    return std::nullopt;
  }
  return IoFault{
    IoFaultKind::kBadAnswer, name_ + ": latched error: " + describe_errors(state_.errors)};
}

std::optional<IoFault> HerkulexServo::set_up(HerkulexBus & bus, Torque torque)
{
  ready_ = false;
  if (auto fault = try_set_up(bus, torque)) {
    const IoFault known = failed(bus, std::move(*fault));
    health_.closed(bus.clock().now());
    return known;
  }
  ready_ = true;
  health_.opened();
  health_.answered();
  return latched();
}

std::optional<IoFault> HerkulexServo::try_set_up(HerkulexBus & bus, Torque torque)
{
  if (auto fault = identify(bus)) {
    return fault;
  }
  const std::pair<std::uint8_t, std::uint8_t> policies[] = {
    {ram::kAckPolicy, kAckReadsOnly},
    {ram::kTorquePolicy, setup_.torque_policy},
    {ram::kAccelerationRatio, setup_.acceleration_ratio}};
  for (const auto & [address, value] : policies) {
    if (auto fault = write_and_check(bus, address, value)) {
      return fault;
    }
  }
  if (auto fault = read_state_again(bus)) {
    return fault;
  }
  if (state_.mode != setup_.mode) {
    if (auto fault = change_mode(bus)) {
      return fault;
    }
  }
  if (state_.torque != torque) {
    const bool refused = torque == Torque::kOn && latched().has_value();
    if (auto fault = set_torque(bus, refused ? Torque::kBrake : torque)) {
      return fault;
    }
  }
  torque_ = torque;
  return read_state_again(bus);
}

std::optional<IoFault> HerkulexServo::identify(HerkulexBus & bus)
{
  IoFault fault;
  for (int i = 0; i < kTries; ++i) {
    const auto reply = bus.read(name_, id_, HerkulexCommand::kEepRead, 0, 2);
    if (!reply) {
      fault = reply.fault();
      continue;
    }
    const std::uint8_t model = reply.value()[2];
    if (model == kModel0101 || model == kModel0201) {
      return std::nullopt;
    }
    return IoFault{
      IoFaultKind::kBadAnswer,
      name_ + ": is model " + std::to_string(model) + ", accepted: 1 (DRS-0101) or 2 (DRS-0201)"};
  }
  return fault;
}

std::optional<IoFault> HerkulexServo::write_and_check(
  HerkulexBus & bus, std::uint8_t address, std::uint8_t value)
{
  IoFault fault;
  for (int i = 0; i < kTries; ++i) {
    if (auto lost = bus.write_ram(id_, address, {value})) {
      return lost;
    }
    const auto reply = bus.read(name_, id_, HerkulexCommand::kRamRead, address, 1);
    if (!reply) {
      fault = reply.fault();
    } else if (reply.value()[2] == value) {
      return std::nullopt;
    } else {
      fault = IoFault{
        IoFaultKind::kBadAnswer, name_ + ": register " + std::to_string(address) + " stays at " +
                                   std::to_string(reply.value()[2]) + " instead of " +
                                   std::to_string(value)};
    }
  }
  return fault;
}

std::optional<IoFault> HerkulexServo::change_mode(HerkulexBus & bus)
{
  if (!setup_.may_be_freed) {
    return IoFault{
      IoFaultKind::kBadAnswer, name_ +
                                 ": turns freely, and changing that would let its load drop; "
                                 "support the load and switch the servo off and on"};
  }
  if (auto fault = set_torque(bus, Torque::kFree)) {
    return fault;
  }
  HerkulexPacket jog{id_, HerkulexCommand::kSJog};
  const bool velocity = setup_.mode == ServoMode::kVelocity;
  jog.append({0, 0, 0, static_cast<std::uint8_t>(velocity ? kJogVelocity : kJogInvalid), id_});
  if (auto fault = bus.send(jog)) {
    return fault;
  }
  if (auto fault = read_state_again(bus)) {
    return fault;
  }
  if (state_.mode != setup_.mode) {
    return IoFault{IoFaultKind::kBadAnswer, name_ + ": keeps its control mode"};
  }
  return std::nullopt;
}

std::optional<IoFault> HerkulexServo::set_torque(HerkulexBus & bus, Torque torque)
{
  torque_ = torque;
  return write_and_check(bus, ram::kTorqueControl, static_cast<std::uint8_t>(torque));
}

std::optional<IoFault> HerkulexServo::clear_errors(HerkulexBus & bus)
{
  return bus.write_ram(id_, ram::kStatusError, {0, 0});
}

std::optional<IoFault> HerkulexServo::read_state_again(HerkulexBus & bus)
{
  auto fault = read_state(bus);
  for (int i = 1; fault && i < kTries; ++i) {
    fault = read_state(bus);
  }
  return fault;
}

std::optional<IoFault> HerkulexServo::read_state(HerkulexBus & bus)
{
  odd_ = !odd_;
  const auto from = static_cast<std::uint8_t>(kStateFrom - (odd_ ? 1 : 0));
  const auto size = static_cast<std::uint8_t>(kStateFrom + kStateSize - from);
  const auto answer = bus.read(name_, id_, HerkulexCommand::kRamRead, from, size);
  answered_ = answer.ok();
  if (!answered_) {
    return answer.fault();
  }
  const HerkulexPacket & reply = answer.value();
  const auto at = [&](std::uint8_t address) { return 2U + address - from; };
  ServoState & s = state_;
  s.stamp = bus.clock().now();
  s.torque = static_cast<Torque>(reply[at(ram::kTorqueControl)]);
  s.voltage_v = kVoltPerCount * reply[at(ram::kVoltage)];
  s.temperature_raw = reply[at(ram::kTemperature)];
  s.mode = static_cast<ServoMode>(reply[at(ram::kControlMode)]);
  s.tick = reply[at(ram::kTick)];
  const std::uint16_t position = reply.word(at(ram::kPosition));
  const int count = position & kPositionMask;
  s.position_rad = position_rad(position);
  s.in_gap = count < kLowestCount || count > kHighestCount;
  s.speed_rad_s = kDifferentialUnit * static_cast<std::int16_t>(reply.word(at(ram::kDifferential)));
  s.pwm = static_cast<double>(static_cast<std::int16_t>(reply.word(at(ram::kPwm)))) / kFullPwm;
  s.errors = reply[reply.size() - 2];
  s.detail = reply[reply.size() - 1];
  return std::nullopt;
}

std::optional<IoFault> HerkulexServo::refresh(HerkulexBus & bus)
{
  if (auto fault = read_state(bus)) {
    const IoFault known = failed(bus, std::move(*fault));
    if (health_.failures_in_a_row() <= kMissesTaken && bus.is_open()) {
      return std::nullopt;
    }
    ready_ = false;
    health_.closed(bus.clock().now());
    return known;
  }
  if (auto fault = latched()) {
    return failed(bus, std::move(*fault));
  }
  if (state_.torque != torque_ || state_.mode != setup_.mode) {
    ready_ = false;
    return failed(
      bus, IoFault{IoFaultKind::kBadAnswer, name_ + ": has lost its settings, was without power"});
  }
  health_.answered();
  return std::nullopt;
}

}  // namespace stetro_driver::linux_io
