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

#ifndef EMULATOR__EMULATED_ROBOT_HPP_
#define EMULATOR__EMULATED_ROBOT_HPP_

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "emulator/emulated_devices.hpp"
#include "emulator/emulated_mechanics.hpp"
#include "linux/device_clock.hpp"
#include "linux/linux_robot.hpp"
#include "stetro_driver/hardware_interface.hpp"
#include "stetro_driver/sim_robot.hpp"
#include "stetro_driver/simulated_world.hpp"

namespace stetro_driver::emulator
{

/// The driver of the real robot, with emulated devices, in the simulated world.
/**
 *   LinuxRobot --ports, attributes, lines--> EmulatedDevices --shafts--> EmulatedMechanics
 *                                                   ^                          |
 *                                                   +--what is sensed-- SimRobot's world
 *
 * The world moves by itself, a tick each 10 ms of the device clock, in a thread of its own. That
 * clock runs `rate` times as fast as the computer's; at 1 every protocol has its real speed.
 */
class EmulatedRobot final : public HardwareInterface, public SimulatedWorld
{
public:
  /// \throws std::invalid_argument as SimRobot; std::system_error when a device cannot be emulated
  EmulatedRobot(
    const BuildingShape & building, const BodyShape & body, const SimOptions & options,
    const linux_io::Devices & listed, const linux_io::TofLimits & limits, double rate);
  ~EmulatedRobot() override;

  void configure() override { robot_.configure(); }
  void activate() override { robot_.activate(); }
  void deactivate() override { robot_.deactivate(); }
  void reset_emergency_stop() override { robot_.reset_emergency_stop(); }
  Result<SensorFrame> read(Time now) override { return robot_.read(now); }
  std::optional<IoFault> write(const JointCommand & command) override
  {
    return robot_.write(command);
  }
  void make_safe() noexcept override { robot_.make_safe(); }
  [[nodiscard]] std::vector<DeviceStatus> devices() const override { return robot_.devices(); }

  [[nodiscard]] Time time() const override { return clock_.now(); }
  [[nodiscard]] GroundTruth truth() const override;

  /// For whoever wants something to go wrong, or to put a hand before a sensor.
  [[nodiscard]] EmulatedDevices & emulated() { return emulated_; }

private:
  void run();
  void tick();

  SimRobot world_;  // the thread's
  const linux_io::DeviceClock clock_;
  EmulatedDevices emulated_;
  EmulatedMechanics mechanics_;
  linux_io::LinuxRobot robot_;

  mutable std::mutex mutex_;
  GroundTruth truth_{};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace stetro_driver::emulator

#endif  // EMULATOR__EMULATED_ROBOT_HPP_
