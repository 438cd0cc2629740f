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

#ifndef STETRO_DRIVER__HARDWARE_INTERFACE_HPP_
#define STETRO_DRIVER__HARDWARE_INTERFACE_HPP_

#include <optional>

#include "stetro_driver/joint_command.hpp"
#include "stetro_driver/result.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver
{

/// One robot, real or simulated. SI units and the frame base_link on this side of it.
/**
 *   (made)   --configure()-->   INACTIVE   sensors are read, motors have no power, lifts are braked
 *   INACTIVE --activate()--->   ACTIVE     the robot may move, and moves only as write() says
 *   ACTIVE   --deactivate()->   INACTIVE
 *
 * Called from one thread, but for make_safe().
 */
class HardwareInterface
{
public:
  HardwareInterface() = default;
  virtual ~HardwareInterface() = default;
  HardwareInterface(const HardwareInterface &) = delete;
  HardwareInterface & operator=(const HardwareInterface &) = delete;

  /// Opens buses and checks identities. \throws HardwareError naming device and what is wrong
  virtual void configure() = 0;

  /// Powers the motors, standing and holding.
  /** \throws HardwareError when they cannot be powered, and why; a latched emergency stop is one */
  virtual void activate() = 0;

  /// Stops, holds and takes the power from the motors; the lifts' brakes keep the blocks.
  virtual void deactivate() = 0;

  /// Ends a latched emergency stop; standing and holding. Only ever because a person asks for it.
  /** \throws HardwareError while the button is pressed */
  virtual void reset_emergency_stop() = 0;

  /// What the sensors say now.
  virtual Result<SensorFrame> read(Time now) = 0;

  /// Tells the motors what to do until the next write. Nothing: it went well.
  virtual std::optional<IoFault> write(const JointCommand & command) = 0;

  /// Stops and holds; in any state, from any thread, twice.
  virtual void make_safe() noexcept = 0;
};

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__HARDWARE_INTERFACE_HPP_
