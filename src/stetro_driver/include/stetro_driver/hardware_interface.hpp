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
#include <string>
#include <utility>
#include <vector>

#include "stetro_driver/joint_command.hpp"
#include "stetro_driver/result.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver
{

/// How one device of the robot is doing, for people.
struct DeviceStatus
{
  std::string name;
  std::optional<IoFault> fault{};  ///< that it has now; nothing: it is well
  std::vector<std::pair<std::string, std::string>> figures{};  ///< name and value, with its unit
};

/// One robot, real or simulated. SI units and the frame base_link on this side of it.
/**
 *   (made)   --configure()-->   INACTIVE   sensors are read, motors have no power, lifts are braked
 *   INACTIVE --activate()--->   ACTIVE     the robot may move, and moves only as write() says
 *   ACTIVE   --deactivate()->   INACTIVE
 *
 * One call at a time, but for make_safe(). Time is the caller's: the computer's or a simulated one;
 * stamps in a frame are of the same clock.
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

  /// What the sensors say now. A sensor that is in trouble says so in its own reading.
  /** A `now` that is not the present, or is before the last one, is a fault of kind kTime. */
  virtual Result<SensorFrame> read(Time now) = 0;

  /// Tells the motors what to do until the next write. Nothing: it went well.
  /**
   * What is refused is not done: the robot holds. Hardware may refuse to move while one of its
   * devices is in trouble; the fault is then that device's, and ends when it is well again.
   */
  virtual std::optional<IoFault> write(const JointCommand & command) = 0;

  /// Stops and holds; in any state, from any thread, twice.
  virtual void make_safe() noexcept = 0;

  /// How its devices are doing; from any thread. Nothing to tell: none.
  [[nodiscard]] virtual std::vector<DeviceStatus> devices() const { return {}; }
};

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__HARDWARE_INTERFACE_HPP_
