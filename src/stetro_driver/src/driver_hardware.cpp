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

#include "stetro_driver/driver_hardware.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "emulator/emulated_robot.hpp"
#include "linux/devices_file.hpp"
#include "linux/lines/gpiod_lines.hpp"
#include "linux/linux_robot.hpp"
#include "stetro_driver/sim_robot.hpp"
#include "stetro_driver/site_shape.hpp"

namespace stetro_driver
{
namespace
{

constexpr double kReplyPatience_s = 0.3;   // with an emulated servo, of the computer's time
constexpr double kRangePatience_s = 0.06;  // with an emulated measurement, the same
constexpr double kLinesPatience_s = 0.1;   // with emulated lines, a third of it
constexpr double kImuPatience_s = 0.25;    // the same with an emulated VN-100

struct KernelDoors
{
  linux_io::SysfsFiles files;
  linux_io::GpiodLines lines;
};

/// The real robot, through the doors of the kernel.
class KernelRobot final : private KernelDoors, public linux_io::LinuxRobot
{
public:
  KernelRobot(const linux_io::Devices & devices, const linux_io::TofLimits & limits)
  : LinuxRobot(
      devices, limits, linux_io::DeviceClock{std::chrono::seconds{1}},
      linux_io::LinuxDoors{files, lines})
  {
  }
};

linux_io::TofLimits limits_of(const stetro_site::RangeSensor & sensor)
{
  return {sensor.min_range_m, sensor.reliable_range_m, sensor.sigma_m, sensor.sigma_per_m};
}

linux_io::Devices devices_of(const DriverSetup & setup)
{
  stetro_config::Faults faults;
  auto devices = linux_io::read_devices(setup.robot, faults);
  faults.throw_if_any();
  devices->chassis.blocks_file = setup.params.blocks_file;
  return std::move(devices).value();
}

/// Emulated devices wait for the processor, as real ones do not, and the more the faster they run.
linux_io::Devices patient_with(linux_io::Devices devices, double speed)
{
  linux_io::ChassisConfig & chassis = devices.chassis;
  chassis.bus.reply_timeout_s = std::max(chassis.bus.reply_timeout_s, kReplyPatience_s * speed);
  linux_io::TofArrayConfig & ranges = devices.range_sensors;
  ranges.period_s = std::min(std::max(ranges.period_s, kRangePatience_s * speed), 0.2);
  ranges.longest_s = std::min(std::max(ranges.longest_s, 3.0 * kRangePatience_s * speed), 1.0);
  linux_io::ContactLinesConfig & lines = devices.contacts;
  lines.poll_s = std::max(lines.poll_s, kLinesPatience_s * speed);
  linux_io::Vn100Config & imu = devices.imu;
  const auto periods = kImuPatience_s * speed * static_cast<double>(imu.rate_hz);
  imu.silent_periods = std::max(imu.silent_periods, static_cast<std::int64_t>(periods));
  return devices;
}

}  // namespace

DriverHardware make_hardware(const DriverSetup & setup)
{
  if (setup.params.hardware == "linux") {
    return {
      std::make_unique<KernelRobot>(
        devices_of(setup), limits_of(setup.robot.geometry.range_sensor)),
      nullptr, nullptr};
  }
  if (setup.params.hardware == "emulated") {
    auto robot = std::make_unique<emulator::EmulatedRobot>(
      building_of(setup), shape_of(setup.robot), sim_options(setup),
      patient_with(devices_of(setup), setup.params.sim.speed),
      limits_of(setup.robot.geometry.range_sensor), setup.params.sim.speed);
    SimulatedWorld & world = *robot;
    return {std::move(robot), &world, nullptr};
  }
  auto robot =
    std::make_unique<SimRobot>(building_of(setup), shape_of(setup.robot), sim_options(setup));
  SimRobot & simulated = *robot;
  return {std::move(robot), &simulated, &simulated};
}

}  // namespace stetro_driver
