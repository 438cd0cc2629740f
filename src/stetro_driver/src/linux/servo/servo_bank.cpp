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

#include "linux/servo/servo_bank.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace stetro_driver::linux_io
{
namespace
{

constexpr int kDeadLine = 2;  // servos in a row that do not answer

}  // namespace

ServoBank::ServoBank(
  const HerkulexBusConfig & config, const std::vector<ServoPlace> & places, DeviceClock clock)
: places_(places), bus_(config, clock), health_("servo bus")
{
  for (const ServoPlace & place : places_) {
    servos_.emplace_back(place.name, place.id, place.setup);
  }
}

void ServoBank::open()
{
  torque_ = Torque::kBrake;
  bus_.close();
  bus_.open();
  std::string faults;
  for (HerkulexServo & servo : servos_) {
    if (const auto fault = servo.set_up(bus_, torque_); fault && !servo.ready()) {
      faults += (faults.empty() ? "" : "; ") + fault->detail;
    }
  }
  if (!faults.empty()) {
    bus_.close();
    throw HardwareError(faults + "; accepted: every servo of the robot file on the line, powered");
  }
  health_.opened();
}

std::optional<IoFault> ServoBank::cycle()
{
  if (auto fault = reopen()) {
    return fault;
  }
  heal_one();
  auto fault = ask_all();
  if (!bus_.is_open()) {
    fault = fault ? fault : IoFault{IoFaultKind::kSilent, "servo bus: unplugged"};
    lose_all(*fault);
  }
  return fault;
}

std::optional<IoFault> ServoBank::reopen()
{
  if (bus_.is_open()) {
    return std::nullopt;
  }
  const Time now = bus_.clock().now();
  if (health_.is_closed() && !health_.may_open(now)) {
    return health_.last_fault();
  }
  try {
    bus_.open();
  } catch (const HardwareError & error) {
    health_.failed(now, IoFault{IoFaultKind::kSilent, error.what()});
    health_.closed(now);
    return health_.last_fault();
  }
  health_.opened();
  return std::nullopt;
}

void ServoBank::lose_all(const IoFault & fault)
{
  const Time now = bus_.clock().now();
  health_.failed(now, fault);
  health_.closed(now);
  for (HerkulexServo & servo : servos_) {
    servo.forget(now, fault);
  }
}

void ServoBank::heal_one()
{
  const Time now = bus_.clock().now();
  for (HerkulexServo & servo : servos_) {
    if (servo.may_set_up(now)) {
      static_cast<void>(servo.set_up(bus_, torque_));  // ask_all() says whether it is well now
      return;
    }
  }
}

std::optional<IoFault> ServoBank::ask_all()
{
  std::optional<IoFault> first;
  int missed = 0;
  for (std::size_t i = 0; i < servos_.size() && bus_.is_open(); ++i) {
    HerkulexServo & servo = servos_[i];
    std::optional<IoFault> fault = servo.health().last_fault();
    if (servo.ready()) {
      fault = servo.refresh(bus_);
      missed = servo.answered() ? 0 : missed + 1;
      brake_if_grave(i);
    }
    if (fault && !first) {
      first = std::move(fault);
    }
    if (missed >= kDeadLine) {
      first = IoFault{IoFaultKind::kSilent, "servo bus: no servo answers"};
      health_.failed(bus_.clock().now(), *first);
      return first;
    }
  }
  if (!first) {
    health_.answered();
  }
  return first;
}

// A motor that overheats or is overloaded is not driven on. Its shaft is braked, not freed.
void ServoBank::brake_if_grave(std::size_t i)
{
  const ServoState & state = servos_[i].state();
  if ((state.errors & HerkulexServo::kGrave) != 0 && state.torque == Torque::kOn) {
    static_cast<void>(servos_[i].set_torque(bus_, Torque::kBrake));
  }
}

std::optional<IoFault> ServoBank::set_torque(Torque torque, bool forgive)
{
  torque_ = torque;
  std::optional<IoFault> first;
  for (HerkulexServo & servo : servos_) {
    std::optional<IoFault> fault = servo.health().last_fault();
    if (servo.ready()) {
      fault = forgive && servo.state().errors != 0 ? servo.clear_errors(bus_) : std::nullopt;
      fault = fault ? std::move(fault) : servo.set_torque(bus_, torque);
    }
    if (fault && !first) {
      first = std::move(fault);
    }
  }
  return first;
}

HerkulexBytes ServoBank::jog(const std::vector<ServoGoal> & goals, Time playtime) const
{
  HerkulexPacket packet{HerkulexPacket::kBroadcast, HerkulexCommand::kSJog};
  const auto ticks = std::clamp<Time::rep>(playtime / kServoTick, 1, 255);
  packet.append(static_cast<std::uint8_t>(ticks));
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    if (!goals[i].told) {
      continue;
    }
    const bool velocity = places_[i].setup.mode == ServoMode::kVelocity;
    const auto size = static_cast<std::uint16_t>(std::abs(goals[i].count));
    const bool back = velocity && goals[i].count < 0;
    packet.append_word(static_cast<std::uint16_t>(size | (back ? kBackwards : 0)));
    packet.append({static_cast<std::uint8_t>(velocity ? kJogVelocity : 0), places_[i].id});
  }
  return encode(packet);
}

}  // namespace stetro_driver::linux_io
