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

#ifndef EMULATOR__EMULATED_SERVO_HPP_
#define EMULATOR__EMULATED_SERVO_HPP_

#include <array>
#include <cstdint>
#include <optional>

#include "linux/servo/herkulex_packet.hpp"
#include "linux/servo/herkulex_registers.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::emulator
{

/// What a servo's motor is told at one time.
struct ServoDrive
{
  linux_io::Torque torque = linux_io::Torque::kFree;
  linux_io::ServoMode mode = linux_io::ServoMode::kPosition;
  double goal_rad = 0.0;  ///< position mode: where its trajectory is now
  double pwm = 0.0;       ///< velocity mode: share of the full one, -1 to 1
};

/// One HerkuleX DRS-0201 as its host sees it: registers, jogs, trajectory, latched errors.
/**
 * It is born as at power-up: position mode, torque free, factory policies. Its shaft follows what
 * its motor is told until somebody else says where the shaft is: set_measured().
 */
class EmulatedServo
{
public:
  explicit EmulatedServo(std::uint8_t id);

  /// Hears a packet. \return its reply, if it gives one
  [[nodiscard]] std::optional<linux_io::HerkulexPacket> hear(
    const linux_io::HerkulexPacket & packet, Time now);

  /// Hears a packet whose checksum is wrong.
  void hear_garbage();

  /// Lets time pass: the tick, the trajectory, and the shaft if nobody moves it.
  void advance(Time now);

  /// What its motor does now.
  [[nodiscard]] ServoDrive drive() const;

  /// Where the shaft really is and how fast it turns; from now on it is moved by the caller.
  void set_measured(double position_rad, double speed_rad_s);
  /// From now on the shaft follows its motor again.
  void release() { moved_by_caller_ = false; }
  void set_pwm(double share);  ///< that the motor needs to hold or to move, -1 to 1
  void set_voltage(double volts);
  void set_temperature(std::uint8_t raw) { ram_[linux_io::ram::kTemperature] = raw; }

  /// Latches errors; frees the shaft if the torque policy says so.
  void trip(std::uint8_t errors);

  /// As after power was lost: everything in RAM is as in EEP, and the shaft is free.
  void power_cycle();

  void set_id(std::uint8_t id);
  [[nodiscard]] std::uint8_t id() const { return ram_[linux_io::ram::kId]; }
  [[nodiscard]] double position_rad() const { return shaft_rad_; }
  [[nodiscard]] std::uint8_t ram(std::uint8_t address) const { return ram_[address]; }

private:
  /// A move in position mode: speed grows, stays and falls again.
  struct Trajectory
  {
    double from_rad = 0.0;
    double to_rad = 0.0;
    Time begin{0};
    Time playtime{0};
    double acceleration_share = 0.0;  ///< of the playtime, at either end

    [[nodiscard]] double at(Time now) const;
  };

  void jog(std::uint16_t word, std::uint8_t set, std::uint8_t playtime, Time now);
  void hear_jogs(const linux_io::HerkulexPacket & packet, Time now);
  void write(const linux_io::HerkulexPacket & packet, bool to_ram);
  void set_torque(std::uint8_t value);
  [[nodiscard]] std::optional<linux_io::HerkulexPacket> read(
    const linux_io::HerkulexPacket & packet, bool of_ram);
  [[nodiscard]] linux_io::HerkulexPacket reply_to(const linux_io::HerkulexPacket & packet) const;
  void add_status(linux_io::HerkulexPacket & reply) const;
  void set_word(std::uint8_t address, std::uint16_t value);
  void refuse(linux_io::ServoDetail why);
  void show();
  void show_detail(linux_io::ServoDetail bit, bool on);

  std::array<std::uint8_t, 54> eep_{};
  std::array<std::uint8_t, linux_io::ram::kSize> ram_{};
  Trajectory trajectory_{};
  double goal_rad_ = 0.0;  // of the trajectory, now
  double pwm_told_ = 0.0;
  double pwm_shown_ = 0.0;
  double shaft_rad_ = 0.0;
  double shaft_speed_rad_s_ = 0.0;
  bool moved_by_caller_ = false;
  Time now_{0};
  Time deaf_until_{0};  // it is rebooting
};

}  // namespace stetro_driver::emulator

#endif  // EMULATOR__EMULATED_SERVO_HPP_
