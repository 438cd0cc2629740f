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

#include "emulator/emulated_devices.hpp"

#include <stdlib.h>

#include <cerrno>
#include <cmath>
#include <string>
#include <system_error>
#include <vector>

#include "linux/tof/tof_address.hpp"

namespace stetro_driver::emulator
{
namespace
{

using linux_io::kPair;
using linux_io::kWheels;
using linux_io::TofAddress;

/// As long as any command may act; a busy computer is silent for a while, too.
constexpr Time kRelayAfter = std::chrono::milliseconds{200};
constexpr double kGravity = 9.81;
constexpr int kTooNearMm = 20;  // a number that means nothing but "near"

/// The listed devices with their ports in a directory of ours.
linux_io::Devices moved_to(linux_io::Devices devices, const std::filesystem::path & directory)
{
  devices.range_sensors.sysfs_root = directory.string();
  devices.chassis.bus.port.path = (directory / "servos").string();
  devices.imu.serial.path = (directory / "imu").string();
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    const auto address = linux_io::parse_tof_address(devices.range_sensors.sensors[i]);
    if (address && address->by == TofAddress::By::kPath) {
      devices.range_sensors.sensors[i] = "label:" + std::string(kRangeNames[i]);
    }
  }
  return devices;
}

HerkulexLine servo_line(const linux_io::Devices & devices)
{
  HerkulexLine line;
  line.link = devices.chassis.bus.port.path;
  line.baud = static_cast<std::uint32_t>(devices.chassis.bus.port.baud);
  for (const auto & wheel : devices.chassis.wheels.wheels) {
    if (wheel.id >= 0) {
      line.on_relay.insert(static_cast<std::uint8_t>(wheel.id));  // docs/hardware/servos.md
    }
  }
  line.relay_after = kRelayAfter;
  return line;
}

std::vector<std::uint8_t> ids_of(const linux_io::ChassisConfig & chassis)
{
  std::vector<std::uint8_t> ids;
  for (const auto & wheel : chassis.wheels.wheels) {
    if (wheel.id >= 0) {
      ids.push_back(static_cast<std::uint8_t>(wheel.id));
    }
  }
  for (std::size_t i = 0; i < kPair; ++i) {
    ids.push_back(static_cast<std::uint8_t>(chassis.steering.joints[i].id));
    ids.push_back(static_cast<std::uint8_t>(chassis.lifts.joints[i].id));
  }
  return ids;
}

Vn100EmulatorOptions imu_options(const linux_io::Vn100Config & config)
{
  Vn100EmulatorOptions options;
  options.link = config.serial.path;
  options.baud = static_cast<std::uint32_t>(config.serial.baud);
  options.mounting_roll_rad = config.mounting_roll_rad;
  options.mounting_pitch_rad = config.mounting_pitch_rad;
  options.mounting_yaw_rad = config.mounting_yaw_rad;
  if (!config.serial_number.empty()) {
    options.serial_number = config.serial_number;
  }
  return options;
}

int millimetres_of(const RangeReading & reading)
{
  if (std::isfinite(reading.range_m)) {
    return static_cast<int>(std::lround(reading.range_m * 1000.0));
  }
  return reading.range_m < 0.0 ? kTooNearMm : linux_io::kNoTargetMm;
}

}  // namespace

TemporaryDirectory::TemporaryDirectory()
{
  std::string name = (std::filesystem::temp_directory_path() / "stetro_emulated_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), name);
  }
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory()
{
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

EmulatedDevices::EmulatedDevices(
  const linux_io::Devices & listed, const linux_io::DeviceClock & clock)
: devices_(moved_to(listed, directory_.path())),
  tree_(directory_.path()),
  lines_(clock),
  servos_(servo_line(devices_), ids_of(devices_.chassis), clock),
  imu_(imu_options(devices_.imu), clock)
{
  plug_ranges(clock);
}

void EmulatedDevices::plug_ranges(const linux_io::DeviceClock & clock)
{
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    const auto address = linux_io::parse_tof_address(devices_.range_sensors.sensors[i]);
    if (!address || address->by == TofAddress::By::kNone) {
      continue;
    }
    IioDevice device;
    const bool by_label = address->by == TofAddress::By::kLabel;
    device.label = by_label ? address->key : "";
    device.i2c_name = by_label ? "7-003" + std::to_string(i) : address->key;
    device.tof = std::make_shared<EmulatedTof>(clock);
    tree_.plug(device);
    sensors_[i] = device;
  }
}

void EmulatedDevices::show(const SensorFrame & frame, double yaw_rad)
{
  const std::lock_guard<std::mutex> lock{mutex_};
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    show_range(i, frame.ranges[i]);
  }
  for (std::size_t i = 0; i < kContactPlaces; ++i) {
    show_contact(i, frame.contacts[i]);
  }
  ImuMotion motion;
  motion.base_in_world = linux_io::from_euler(0.0, 0.0, yaw_rad);
  motion.rate_rad_s = frame.gyro.rate_rad_s;
  motion.rate_rad_s[2] = spin_rad_s_.value_or(motion.rate_rad_s[2]);
  motion.acceleration_m_s2 = {0.0, 0.0, kGravity};
  imu_.set_motion(motion, frame.time);  // a tick late, so that nothing is to be foreseen
  if (frame.gyro.fault != imu_silenced_) {
    imu_silenced_ = frame.gyro.fault;
    Vn100Trouble trouble;
    trouble.silent = imu_silenced_;
    imu_.set_trouble(trouble);
  }
}

void EmulatedDevices::show_range(std::size_t place, const RangeReading & reading)
{
  if (!sensors_[place]) {
    return;
  }
  EmulatedTof & tof = *sensors_[place]->tof;
  const bool silent = reading.status == RangeStatus::kFault && reading.stamp > Time::zero();
  if (silent != silenced_[place]) {
    silenced_[place] = silent;
    tof.set_trouble(silent ? TofTrouble::kSilent : TofTrouble::kNone);
  }
  RangeReading seen = reading;
  if (held_m_[place]) {
    seen.range_m = *held_m_[place];
  }
  tof.see(millimetres_of(seen));
}

void EmulatedDevices::show_contact(std::size_t place, const ContactReading & reading)
{
  const linux_io::ContactLineConfig & line = devices_.contacts.lines[place];
  if (!line.fitted()) {
    return;
  }
  const LineName name{line.chip, static_cast<unsigned int>(line.line)};
  if (reading.fault != loose_[place]) {
    loose_[place] = reading.fault;
    lines_.set_chatter(name, reading.fault);
  }
  if (!reading.fault) {
    const bool closed = pressed_[place].value_or(reading.closed);
    lines_.drive(name, closed != (line.active == "low"));
  }
}

void EmulatedDevices::press(ContactPlace place, std::optional<bool> pressed)
{
  const std::lock_guard<std::mutex> lock{mutex_};
  pressed_[static_cast<std::size_t>(place)] = pressed;
}

void EmulatedDevices::hold_before(RangePlace place, std::optional<double> range_m)
{
  const std::lock_guard<std::mutex> lock{mutex_};
  held_m_[static_cast<std::size_t>(place)] = range_m;
}

void EmulatedDevices::spin(std::optional<double> rate_rad_s)
{
  const std::lock_guard<std::mutex> lock{mutex_};
  spin_rad_s_ = rate_rad_s;
}

ChassisDrives EmulatedDevices::drives()
{
  const auto drive_of = [this](std::int64_t id) {
    ServoDrive drive;
    servos_.if_there(
      static_cast<std::uint8_t>(id), [&](EmulatedServo & servo) { drive = servo.drive(); });
    return drive;
  };
  const linux_io::ChassisConfig & chassis = devices_.chassis;
  ChassisDrives drives;
  for (std::size_t i = 0; i < kWheels; ++i) {
    if (chassis.wheels.wheels[i].id >= 0) {
      drives.wheels[i] = drive_of(chassis.wheels.wheels[i].id);
    }
  }
  for (std::size_t i = 0; i < kPair; ++i) {
    drives.steering[i] = drive_of(chassis.steering.joints[i].id);
    drives.lifts[i] = drive_of(chassis.lifts.joints[i].id);
  }
  return drives;
}

void EmulatedDevices::turn(const ChassisShafts & shafts)
{
  const auto set = [this](std::int64_t id, const Shaft & shaft) {
    servos_.if_there(static_cast<std::uint8_t>(id), [&](EmulatedServo & servo) {
      servo.set_measured(shaft.position_rad, shaft.speed_rad_s);
    });
  };
  const linux_io::ChassisConfig & chassis = devices_.chassis;
  for (std::size_t i = 0; i < kWheels; ++i) {
    if (chassis.wheels.wheels[i].id >= 0) {
      set(chassis.wheels.wheels[i].id, shafts.wheels[i]);
    }
  }
  for (std::size_t i = 0; i < kPair; ++i) {
    set(chassis.steering.joints[i].id, shafts.steering[i]);
    set(chassis.lifts.joints[i].id, shafts.lifts[i]);
  }
}

}  // namespace stetro_driver::emulator
