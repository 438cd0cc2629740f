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

#ifndef EMULATOR__EMULATED_DEVICES_HPP_
#define EMULATOR__EMULATED_DEVICES_HPP_

#include <array>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>

#include "emulator/emulated_lines.hpp"
#include "emulator/emulated_mechanics.hpp"
#include "emulator/emulated_tof.hpp"
#include "emulator/herkulex_emulator.hpp"
#include "emulator/iio_tree.hpp"
#include "emulator/vn100_emulator.hpp"
#include "linux/device_clock.hpp"
#include "linux/devices_file.hpp"
#include "linux/linux_robot.hpp"
#include "stetro_driver/sensor_frame.hpp"

namespace stetro_driver::emulator
{

/// A directory of our own under the temporary ones, removed with this.
class TemporaryDirectory
{
public:
  TemporaryDirectory();  ///< \throws std::system_error
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory &) = delete;
  TemporaryDirectory & operator=(const TemporaryDirectory &) = delete;
  [[nodiscard]] const std::filesystem::path & path() const { return path_; }

private:
  std::filesystem::path path_;
};

/// The other end of every wire that the robot file lists.
/**
 * Ids, addresses, lines, speeds and directions are those of the file; only where the computer finds
 * ports and attributes is ours, and devices() says so. What is wrong with a device is set on it.
 */
class EmulatedDevices
{
public:
  EmulatedDevices(const linux_io::Devices & listed, const linux_io::DeviceClock & clock);

  /// The devices as listed, at the places where these emulated ones are.
  [[nodiscard]] const linux_io::Devices & devices() const { return devices_; }
  [[nodiscard]] linux_io::LinuxDoors doors() { return {tree_, lines_}; }

  /// What the sensors see from now on. Ranges in trouble do not answer, switches in trouble have a
  /// loose wire.
  void show(const SensorFrame & frame, double yaw_rad);

  [[nodiscard]] ChassisDrives drives();
  void turn(const ChassisShafts & shafts);

  /// A range sensor as the tree has it; null: it is not fitted.
  [[nodiscard]] EmulatedTof * tof(RangePlace place)
  {
    return sensor(place) ? sensor(place)->tof.get() : nullptr;
  }
  [[nodiscard]] const std::optional<IioDevice> & sensor(RangePlace place) const
  {
    return sensors_[static_cast<std::size_t>(place)];
  }
  [[nodiscard]] IioTree & tree() { return tree_; }
  [[nodiscard]] EmulatedLines & lines() { return lines_; }
  [[nodiscard]] HerkulexEmulator & servos() { return servos_; }
  [[nodiscard]] Vn100Emulator & imu() { return imu_; }

  /// Presses or releases a switch, whatever the world says, or leaves it to the world again.
  void press(ContactPlace place, std::optional<bool> pressed);

  /// Shows a range sensor a target, whatever the world says, or leaves it to the world again.
  void hold_before(RangePlace place, std::optional<double> range_m);

  /// Turns the inertial sensor about the vertical, whatever the world says, or leaves it again.
  void spin(std::optional<double> rate_rad_s);

private:
  void plug_ranges(const linux_io::DeviceClock & clock);
  void show_range(std::size_t place, const RangeReading & reading);
  void show_contact(std::size_t place, const ContactReading & reading);

  TemporaryDirectory directory_;
  linux_io::Devices devices_;
  IioTree tree_;
  std::array<std::optional<IioDevice>, kRangePlaces> sensors_{};
  EmulatedLines lines_;
  HerkulexEmulator servos_;
  Vn100Emulator imu_;

  std::mutex mutex_{};                         // guards what follows
  std::array<bool, kRangePlaces> silenced_{};  // by the world
  bool imu_silenced_ = false;
  std::array<bool, kContactPlaces> loose_{};
  std::array<std::optional<bool>, kContactPlaces> pressed_{};
  std::array<std::optional<double>, kRangePlaces> held_m_{};
  std::optional<double> spin_rad_s_{};
};

}  // namespace stetro_driver::emulator

#endif  // EMULATOR__EMULATED_DEVICES_HPP_
