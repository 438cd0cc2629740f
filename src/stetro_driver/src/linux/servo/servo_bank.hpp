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

#ifndef LINUX__SERVO__SERVO_BANK_HPP_
#define LINUX__SERVO__SERVO_BANK_HPP_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "linux/servo/herkulex_servo.hpp"

namespace stetro_driver::linux_io
{

/// A servo, what it is called, and what it does when things go wrong.
struct ServoPlace
{
  std::string name;
  std::uint8_t id = 0;
  ServoSetup setup{};
};

/// What a servo is to do until it is told again.
struct ServoGoal
{
  int count = 0;     ///< of position, or PWM with a sign
  bool told = true;  ///< false: it is left alone
};

/// All servos of a line: found, set up, asked once in a period, and told together.
/**
 * cycle() asks every servo and heals what it can: a port that hung up is opened again after its
 * back-off, a servo that was away or without power is set up again, one in a cycle. Two servos in
 * a row that do not answer are a dead line, and the rest is not asked: a dead line is known within
 * one period. Used by one thread.
 */
class ServoBank
{
public:
  ServoBank(
    const HerkulexBusConfig & config, const std::vector<ServoPlace> & places, DeviceClock clock);

  /// Opens the line and sets up every servo, braked. \throws HardwareError naming all that failed
  void open();

  /// Asks every servo. \return what is wrong with the line or with the first that is not well
  [[nodiscard]] std::optional<IoFault> cycle();

  /// Powers or brakes all; clears latched errors first when `forgive`.
  [[nodiscard]] std::optional<IoFault> set_torque(Torque torque, bool forgive);

  /// One packet with a goal for each; they arrive together. \param playtime of positions
  [[nodiscard]] HerkulexBytes jog(const std::vector<ServoGoal> & goals, Time playtime) const;

  [[nodiscard]] HerkulexBus & bus() { return bus_; }
  [[nodiscard]] const std::vector<HerkulexServo> & servos() const { return servos_; }
  [[nodiscard]] const DeviceHealth & health() const { return health_; }  ///< of the line

private:
  [[nodiscard]] std::optional<IoFault> reopen();
  [[nodiscard]] std::optional<IoFault> ask_all();
  void heal_one();
  void lose_all(const IoFault & fault);
  void brake_if_grave(std::size_t i);

  std::vector<ServoPlace> places_;
  HerkulexBus bus_;
  std::vector<HerkulexServo> servos_;
  DeviceHealth health_;
  Torque torque_ = Torque::kBrake;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__SERVO__SERVO_BANK_HPP_
