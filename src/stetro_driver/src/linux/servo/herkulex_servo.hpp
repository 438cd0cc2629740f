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

#ifndef LINUX__SERVO__HERKULEX_SERVO_HPP_
#define LINUX__SERVO__HERKULEX_SERVO_HPP_

#include <cstdint>
#include <optional>
#include <string>

#include "linux/device_health.hpp"
#include "linux/servo/herkulex_bus.hpp"
#include "linux/servo/herkulex_registers.hpp"

namespace stetro_driver::linux_io
{

/// How a servo is set up for its work, at every start and whenever it was without power.
struct ServoSetup
{
  ServoMode mode = ServoMode::kPosition;
  std::uint8_t torque_policy = 0x35;    ///< errors on which it lets its shaft go by itself
  std::uint8_t acceleration_ratio = 0;  ///< of a trajectory [%]; 0: legs of a path join smoothly
  bool may_be_freed = false;            ///< changing its mode lets the shaft go for a moment
};

/// What a servo says of itself.
struct ServoState
{
  Time stamp{0};              ///< when it answered
  double position_rad = 0.0;  ///< about its middle; not to be used in the gap, see in_gap
  bool in_gap = false;        ///< beyond the 320 degrees it can measure
  double speed_rad_s = 0.0;   ///< coarse: one count is half a radian per second
  double pwm = 0.0;           ///< share of the full one, signed
  double voltage_v = 0.0;
  int temperature_raw = 0;  ///< of its thermistor, grows as it warms: 0xDF is near 85 C
  std::uint8_t errors = 0;  ///< ServoError bits
  std::uint8_t detail = 0;  ///< ServoDetail bits
  Torque torque = Torque::kFree;
  ServoMode mode = ServoMode::kPosition;
  std::uint8_t tick = 0;
};

/// One HerkuleX DRS-0101 or 0201 by its registers.
/**
 *   (made)    --set_up()----->  ready    it is the right model, and its RAM holds our policies
 *   ready     --refresh()---->  ready    it answered, and everything is as we set it up
 *   ready     --refresh()---->  (made)   twice without an answer, or back from a loss of power
 *
 * Errors latch in the servo. They are a fault until clear_errors(), which only a person asks for.
 */
class HerkulexServo
{
public:
  /// Errors on which the robot does not move; the others are for diagnostics.
  static constexpr std::uint8_t kGrave =
    kVoltageError | kTemperatureError | kOverloadError | kDriverError | kEepError;

  HerkulexServo(const std::string & name, std::uint8_t id, const ServoSetup & setup);

  /// Identifies it, writes policies and reads them back, sets mode and torque. Takes ten requests.
  [[nodiscard]] std::optional<IoFault> set_up(HerkulexBus & bus, Torque torque);

  /// Asks for its state. A single miss is forgiven: the state is that of before.
  [[nodiscard]] std::optional<IoFault> refresh(HerkulexBus & bus);

  [[nodiscard]] std::optional<IoFault> set_torque(HerkulexBus & bus, Torque torque);
  [[nodiscard]] std::optional<IoFault> clear_errors(HerkulexBus & bus);

  /// Nothing of it is known any more: the port it hung on is gone.
  void forget(Time now, const IoFault & fault);

  [[nodiscard]] bool ready() const { return ready_; }
  /// Whether it did when it was last asked for its state.
  [[nodiscard]] bool answered() const { return answered_; }
  /// Whether it is worth a try: one that does not answer costs the line its patience.
  [[nodiscard]] bool may_set_up(Time now) const
  {
    return !ready_ && (!health_.is_closed() || health_.may_open(now));
  }
  [[nodiscard]] const ServoState & state() const { return state_; }
  [[nodiscard]] const DeviceHealth & health() const { return health_; }
  [[nodiscard]] const std::string & name() const { return name_; }
  [[nodiscard]] std::uint8_t id() const { return id_; }

private:
  [[nodiscard]] std::optional<IoFault> identify(HerkulexBus & bus);
  [[nodiscard]] std::optional<IoFault> write_and_check(
    HerkulexBus & bus, std::uint8_t address, std::uint8_t value);
  [[nodiscard]] std::optional<IoFault> read_state(HerkulexBus & bus);
  /// The same as often as anything that sets up.
  [[nodiscard]] std::optional<IoFault> read_state_again(HerkulexBus & bus);
  [[nodiscard]] std::optional<IoFault> change_mode(HerkulexBus & bus);
  [[nodiscard]] std::optional<IoFault> try_set_up(HerkulexBus & bus, Torque torque);
  [[nodiscard]] IoFault failed(HerkulexBus & bus, IoFault fault);
  [[nodiscard]] std::optional<IoFault> latched() const;

  std::string name_;  // with its id, for faults
  std::uint8_t id_;
  ServoSetup setup_;
  ServoState state_{};
  DeviceHealth health_;
  Torque torque_ = Torque::kFree;
  bool ready_ = false;
  bool answered_ = false;
  bool odd_ = false;  // which of two requests is next
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__SERVO__HERKULEX_SERVO_HPP_
