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

#ifndef LINUX__DEVICES_FILE_HPP_
#define LINUX__DEVICES_FILE_HPP_

#include <optional>

#include "linux/imu/vn100_config.hpp"
#include "linux/lines/contact_lines_config.hpp"
#include "linux/motion/chassis_config.hpp"
#include "linux/tof/tof_array.hpp"
#include "stetro_config/fault.hpp"
#include "stetro_config/field.hpp"
#include "stetro_site/robot.hpp"

namespace stetro_driver::linux_io
{

/// Every device of the real robot, as the section `devices:` of the robot file lists them.
struct Devices
{
  TofArrayConfig range_sensors{};
  ContactLinesConfig contacts{};
  ChassisConfig chassis{};
  Vn100Config imu{};
};

template <class Visitor>
void visit(Devices & p, Visitor && each)
{
  using stetro_config::Group;
  visit(p.range_sensors, Group{"range_sensors", each});
  visit(p.contacts, Group{"contacts", each});
  visit(p.chassis, Group{"chassis", each});
  visit(p.imu, Group{"imu", each});
}

/// What contradicts each other: within a device, and two devices on one serial port.
void check(const Devices & devices, stetro_config::Faults & faults);

/// Reads the section. Every name must be given: a wiring that is guessed moves the wrong motor.
/** \return nothing if a fault was added, with its line of the robot file */
[[nodiscard]] std::optional<Devices> read_devices(
  const stetro_site::Robot & robot, stetro_config::Faults & faults);

}  // namespace stetro_driver::linux_io

#endif  // LINUX__DEVICES_FILE_HPP_
