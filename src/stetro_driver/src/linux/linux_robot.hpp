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

#ifndef LINUX__LINUX_ROBOT_HPP_
#define LINUX__LINUX_ROBOT_HPP_

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "linux/clock_shift.hpp"
#include "linux/device_clock.hpp"
#include "linux/devices_file.hpp"
#include "linux/imu/vn100.hpp"
#include "linux/lines/contact_lines.hpp"
#include "linux/lines/line_port.hpp"
#include "linux/motion/chassis.hpp"
#include "linux/tof/sysfs_attribute.hpp"
#include "linux/tof/tof_array.hpp"
#include "stetro_driver/hardware_interface.hpp"

namespace stetro_driver::linux_io
{

/// The ways into the computer that have no path in a file; they outlive the robot.
struct LinuxDoors
{
  const AttributeSource & files;  ///< to the range sensors' attributes
  LinePort & lines;               ///< to switches
};

/// The real robot: its devices, each with threads of its own, behind the one door.
/**
 * read() and write() pass through boxes, wait for no device, and allocate only words of a fault.
 * Whatever is wrong with a device, the robot holds: write() refuses with that device's fault, and
 * obeys again when it is well. Only a contact that is stuck does not hold it, for it would never
 * leave the wall that presses it: its reading says so.
 *
 * Devices keep time on a clock of their own; read() moves their stamps to the caller's.
 */
class LinuxRobot : public HardwareInterface
{
public:
  LinuxRobot(
    const Devices & devices, const TofLimits & limits, const DeviceClock & clock,
    const LinuxDoors & doors);
  ~LinuxRobot() override;

  /// Opens and checks every device, all although one has failed; devices() then says which.
  /** \throws HardwareError naming each that failed, and why. It may be tried again. */
  void configure() override;
  void activate() override;
  void deactivate() override;
  void reset_emergency_stop() override;
  Result<SensorFrame> read(Time now) override;
  std::optional<IoFault> write(const JointCommand & command) override;
  void make_safe() noexcept override;
  [[nodiscard]] std::vector<DeviceStatus> devices() const override;

private:
  /// Keeps from a mission what is over at once.
  /**
   * Servos or switches that miss a few questions are no news: write() refuses meanwhile, and the
   * robot holds. Broken ones are those that are silent for longer; who hears of them gives up its
   * climb.
   */
  class BriefTrouble
  {
  public:
    /** \return whether a device may be told as it says that it is, in trouble or well */
    [[nodiscard]] bool lets_pass(bool in_trouble, Time device_now);

  private:
    Time well_{0};  // when it last was
  };

  void open(const std::string & kind, const std::function<void()> & action);
  void release();
  void sense(Time now);
  void sense_ranges(Time device_now, Time shift);
  void sense_blocks(Time device_now, Time shift);
  void sense_contacts(Time device_now, Time shift);
  [[nodiscard]] bool cycle_complete(Time device_now);
  [[nodiscard]] std::optional<IoFault> refusal(const JointCommand & command);
  void find_trouble(Time device_now);
  [[nodiscard]] IoFault range_trouble(RangePlace place) const;

  const Devices devices_;
  const TofLimits limits_;
  const DeviceClock clock_;
  const LinuxDoors doors_;
  std::unique_ptr<TofArray> ranges_{};
  std::unique_ptr<ContactLines> contacts_{};
  std::unique_ptr<Vn100> imu_{};
  mutable std::mutex chassis_mutex_{};  // of the pointer: make_safe() comes from anywhere
  std::unique_ptr<Chassis> chassis_{};
  std::vector<DeviceStatus> openings_{};  // what became of each kind of device in configure()

  bool configured_ = false;
  bool active_ = false;
  std::atomic<bool> safe_{false};
  SensorFrame frame_{};
  ClockShift shift_{};
  std::array<TofLatest, kRangePlaces> latest_{};
  std::array<std::uint64_t, kRangePlaces> told_{};  // numbers of the last complete cycle
  Time cycle_ended_{0};
  BriefTrouble of_chassis_{};
  BriefTrouble of_contacts_{};
  ContactLatest switches_{};
  ChassisReading motion_{};
  std::optional<IoFault> trouble_{};  // of the first device that has one
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__LINUX_ROBOT_HPP_
