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

#include "emulator/emulated_servo.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_driver::emulator
{
namespace
{

using linux_io::HerkulexCommand;
using linux_io::HerkulexPacket;
using linux_io::ServoMode;
using linux_io::Torque;
namespace ram = linux_io::ram;

constexpr std::uint8_t kRepliesToReads = 1;  // acknowledge policies
constexpr std::uint8_t kRepliesToAll = 2;
constexpr Time kRebootTime = std::chrono::seconds{1};
constexpr double kFullSpeed = 7.0;             // of a shaft nobody else moves [rad/s]
constexpr double kInPosition = 0.01;           // [rad]
constexpr std::uint16_t kUpperBits = 0x6000;   // real 0101 and 0201 set them in positions
constexpr double kDifferentialUnit = 0.50772;  // 29.09 degrees a second [rad/s]
constexpr double kPi = 3.14159265358979323846;

std::uint16_t as_word(double value)
{
  return static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(value)));
}

}  // namespace

EmulatedServo::EmulatedServo(std::uint8_t id)
{
  constexpr std::uint8_t kModel = 0x02;
  constexpr std::uint8_t kBaud115200 = 0x10;
  eep_[0] = kModel;
  eep_[1] = 0x01;
  eep_[4] = kBaud115200;
  const auto factory = [this](std::uint8_t address, std::uint8_t value) {
    eep_[address + ram::kEepOffset] = value;
  };
  factory(ram::kId, id);
  factory(ram::kAckPolicy, kRepliesToReads);
  factory(2, 0x7F);  // alarm LED policy
  factory(ram::kTorquePolicy, 0x35);
  factory(5, 0xDF);  // highest temperature
  factory(6, 0x5B);  // lowest and highest voltage
  factory(7, 0x89);
  factory(ram::kAccelerationRatio, 25);
  factory(9, 0x2D);  // longest acceleration
  power_cycle();
}

void EmulatedServo::power_cycle()
{
  ram_.fill(0);
  std::copy_n(eep_.begin() + ram::kEepOffset, ram::kLastCopied + 1, ram_.begin());
  set_voltage(7.4);
  ram_[ram::kTemperature] = 0x60;
  pwm_told_ = 0.0;
  trajectory_ = {shaft_rad_, shaft_rad_, now_, Time::zero(), 0.0};
  goal_rad_ = shaft_rad_;
  show();
}

void EmulatedServo::set_id(std::uint8_t id)
{
  ram_[ram::kId] = id;
  eep_[ram::kEepOffset] = id;
}

void EmulatedServo::set_voltage(double volts)
{
  ram_[ram::kVoltage] = static_cast<std::uint8_t>(std::lround(volts / linux_io::kVoltPerCount));
}

double EmulatedServo::Trajectory::at(Time now) const
{
  if (now >= begin + playtime) {
    return to_rad;
  }
  const double t = time_to_seconds(now - begin) / time_to_seconds(playtime);
  const double a = acceleration_share;
  const double top = 1.0 / (1.0 - a);  // speed in the middle, of a way of 1 in a time of 1
  double way = top * (t - a / 2.0);
  if (t < a) {
    way = top * t * t / (2.0 * a);
  } else if (t > 1.0 - a) {
    way = 1.0 - top * (1.0 - t) * (1.0 - t) / (2.0 * a);
  }
  return from_rad + way * (to_rad - from_rad);
}

ServoDrive EmulatedServo::drive() const
{
  return {
    static_cast<Torque>(ram_[ram::kTorqueControl]), static_cast<ServoMode>(ram_[ram::kControlMode]),
    goal_rad_, pwm_told_};
}

void EmulatedServo::advance(Time now)
{
  const double dt_s = time_to_seconds(std::max(Time::zero(), now - now_));
  now_ = std::max(now_, now);
  ram_[ram::kTick] = static_cast<std::uint8_t>(now_ / linux_io::kServoTick);
  goal_rad_ = trajectory_.at(now_);
  const ServoDrive told = drive();
  if (!moved_by_caller_ && dt_s > 0.0) {
    const double before_rad = shaft_rad_;
    if (told.torque == Torque::kOn && told.mode == ServoMode::kPosition) {
      const double most_rad = kFullSpeed * dt_s;
      shaft_rad_ += std::clamp(goal_rad_ - shaft_rad_, -most_rad, most_rad);
    } else if (told.torque == Torque::kOn) {
      shaft_rad_ += kFullSpeed * told.pwm * dt_s;
    }
    shaft_speed_rad_s_ = (shaft_rad_ - before_rad) / dt_s;
  }
  show();
}

void EmulatedServo::set_measured(double position_rad, double speed_rad_s)
{
  moved_by_caller_ = true;
  shaft_rad_ = position_rad;
  shaft_speed_rad_s_ = speed_rad_s;
  show();
}

void EmulatedServo::set_pwm(double share)
{
  pwm_shown_ = share;
  show();
}

void EmulatedServo::show()
{
  const double seen_rad = std::remainder(shaft_rad_, 2.0 * kPi);
  const int count = std::clamp(linux_io::position_count(seen_rad), 0, 1023);
  set_word(ram::kPosition, static_cast<std::uint16_t>(count | kUpperBits));
  set_word(60, static_cast<std::uint16_t>(count | kUpperBits));  // absolute: no calibration
  set_word(ram::kDifferential, as_word(shaft_speed_rad_s_ / kDifferentialUnit));
  const double pwm = drive().mode == ServoMode::kVelocity ? pwm_told_ : pwm_shown_;
  set_word(ram::kPwm, as_word(pwm * linux_io::kFullPwm));
  set_word(
    70, static_cast<std::uint16_t>(std::clamp(linux_io::position_count(goal_rad_), 0, 1023)));
  show_detail(linux_io::kMovingDetail, shaft_speed_rad_s_ != 0.0);
  show_detail(linux_io::kInPositionDetail, std::abs(trajectory_.to_rad - shaft_rad_) < kInPosition);
  show_detail(linux_io::kMotorOnDetail, drive().torque == Torque::kOn);
}

void EmulatedServo::show_detail(linux_io::ServoDetail bit, bool on)
{
  const int others = ram_[ram::kStatusDetail] & ~bit;
  ram_[ram::kStatusDetail] = static_cast<std::uint8_t>(others | (on ? bit : 0));
}

void EmulatedServo::trip(std::uint8_t errors)
{
  ram_[ram::kStatusError] |= errors;
  if ((ram_[ram::kStatusError] & ram_[ram::kTorquePolicy]) != 0) {
    ram_[ram::kTorqueControl] = static_cast<std::uint8_t>(Torque::kFree);
    pwm_told_ = 0.0;
  }
  show();
}

void EmulatedServo::refuse(linux_io::ServoDetail why)
{
  ram_[ram::kStatusDetail] |= why;
  trip(linux_io::kPacketError);
}

void EmulatedServo::hear_garbage() { refuse(linux_io::kChecksumDetail); }

void EmulatedServo::set_word(std::uint8_t address, std::uint16_t value)
{
  ram_[address] = static_cast<std::uint8_t>(value & 0xFF);
  ram_[address + 1] = static_cast<std::uint8_t>(value >> 8);
}

HerkulexPacket EmulatedServo::reply_to(const HerkulexPacket & packet) const
{
  return HerkulexPacket{id(), static_cast<std::uint8_t>(packet.command() + HerkulexPacket::kReply)};
}

void EmulatedServo::add_status(HerkulexPacket & reply) const
{
  reply.append({ram_[ram::kStatusError], ram_[ram::kStatusDetail]});
}

std::optional<HerkulexPacket> EmulatedServo::hear(const HerkulexPacket & packet, Time now)
{
  const bool to_all = packet.id() == HerkulexPacket::kBroadcast;
  if ((!to_all && packet.id() != id()) || now < deaf_until_) {
    return std::nullopt;
  }
  advance(now);
  std::optional<HerkulexPacket> reply;
  switch (static_cast<HerkulexCommand>(packet.command())) {
    case HerkulexCommand::kRamRead:
    case HerkulexCommand::kEepRead:
      reply = read(packet, packet.is(HerkulexCommand::kRamRead));
      return to_all || ram_[ram::kAckPolicy] == 0 ? std::nullopt : reply;
    case HerkulexCommand::kStat:
      reply = reply_to(packet);
      add_status(*reply);
      return reply;  // whatever the policy, and to all
    case HerkulexCommand::kRamWrite:
    case HerkulexCommand::kEepWrite:
      write(packet, packet.is(HerkulexCommand::kRamWrite));
      break;
    case HerkulexCommand::kIJog:
    case HerkulexCommand::kSJog:
      hear_jogs(packet, now);
      break;
    case HerkulexCommand::kReboot:
      power_cycle();
      deaf_until_ = now + kRebootTime;
      return std::nullopt;
    default:
      refuse(linux_io::kUnknownCommandDetail);
      break;
  }
  if (to_all || ram_[ram::kAckPolicy] != kRepliesToAll) {
    return std::nullopt;
  }
  reply = reply_to(packet);
  add_status(*reply);
  return reply;
}

std::optional<HerkulexPacket> EmulatedServo::read(const HerkulexPacket & packet, bool of_ram)
{
  const std::size_t most = of_ram ? ram_.size() : eep_.size();
  if (packet.size() != 2 || packet[0] + packet[1] > static_cast<int>(most)) {
    refuse(linux_io::kRegisterRangeDetail);
    return std::nullopt;
  }
  HerkulexPacket reply = reply_to(packet);
  reply.append({packet[0], packet[1]});
  const std::uint8_t * from = (of_ram ? ram_.data() : eep_.data()) + packet[0];
  for (std::size_t i = 0; i < packet[1]; ++i) {
    reply.append(from[i]);
  }
  add_status(reply);
  return reply;
}

void EmulatedServo::write(const HerkulexPacket & packet, bool to_ram)
{
  const std::size_t most = to_ram ? ram_.size() : eep_.size();
  const bool fits = packet.size() >= 2 && packet.size() == 2U + packet[1] &&
                    packet[0] + packet[1] <= static_cast<int>(most);
  if (!fits) {
    refuse(linux_io::kRegisterRangeDetail);
    return;
  }
  for (std::size_t i = 0; i < packet[1]; ++i) {
    const std::size_t address = packet[0] + i;
    const std::uint8_t value = packet[2 + i];
    if (!to_ram) {
      eep_[address] = value;
    } else if (address == ram::kTorqueControl) {
      set_torque(value);
    } else if (address < ram::kVoltage) {  // from there on they are read only
      ram_[address] = value;
    }
  }
  show();
}

void EmulatedServo::set_torque(std::uint8_t value)
{
  const bool latched = (ram_[ram::kStatusError] & ram_[ram::kTorquePolicy]) != 0;
  if (latched && static_cast<Torque>(value) == Torque::kOn) {
    return;
  }
  ram_[ram::kTorqueControl] = value;
  trajectory_ = {shaft_rad_, shaft_rad_, now_, Time::zero(), 0.0};
  goal_rad_ = shaft_rad_;
  pwm_told_ = 0.0;
}

void EmulatedServo::hear_jogs(const HerkulexPacket & packet, Time now)
{
  const bool together = packet.is(HerkulexCommand::kSJog);
  const std::size_t first = together ? 1 : 0;
  const std::size_t each = together ? 4 : 5;
  for (std::size_t at = first; at + each <= packet.size(); at += each) {
    if (packet[at + 3] == id()) {
      jog(packet.word(at), packet[at + 2], packet[together ? 0 : at + 4], now);
    }
  }
}

void EmulatedServo::jog(std::uint16_t word, std::uint8_t set, std::uint8_t playtime, Time now)
{
  const bool velocity = (set & linux_io::kJogVelocity) != 0;
  const auto asked = velocity ? ServoMode::kVelocity : ServoMode::kPosition;
  if (drive().torque != Torque::kOn) {
    ram_[ram::kControlMode] = static_cast<std::uint8_t>(asked);  // the only time it may change
    return;
  }
  if (drive().mode != asked || (set & linux_io::kJogInvalid) != 0) {
    return;
  }
  const bool stop = (set & linux_io::kJogStop) != 0;
  if (velocity) {
    const double share = static_cast<double>(word & 0x03FF) / linux_io::kFullPwm;
    pwm_told_ = stop ? 0.0 : ((word & linux_io::kBackwards) != 0 ? -share : share);
    return;
  }
  const double to_rad = stop ? shaft_rad_ : linux_io::position_rad(word);
  if (!stop && (word < linux_io::kLowestCount || word > linux_io::kHighestCount)) {
    trip(linux_io::kPositionLimitError);
    return;
  }
  trajectory_ = {
    goal_rad_, to_rad, now, playtime * linux_io::kServoTick, 0.01 * ram_[ram::kAccelerationRatio]};
}

}  // namespace stetro_driver::emulator
