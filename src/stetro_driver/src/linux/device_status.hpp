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

#ifndef LINUX__DEVICE_STATUS_HPP_
#define LINUX__DEVICE_STATUS_HPP_

#include <string>

#include "linux/device_health.hpp"
#include "linux/imu/vn100.hpp"
#include "linux/lines/contact_lines.hpp"
#include "linux/motion/chassis.hpp"
#include "linux/tof/tof_reader.hpp"
#include "stetro_driver/hardware_interface.hpp"

namespace stetro_driver::linux_io
{

/// A fault that a box could only name by its kind, with the words of the device's health.
[[nodiscard]] IoFault words_of(const DeviceHealth & health, IoFaultKind kind);

/// What a device says of itself, for people.
[[nodiscard]] DeviceStatus status_of(const std::string & place, const TofReport & report);
[[nodiscard]] DeviceStatus status_of(const ContactReport & report);
[[nodiscard]] DeviceStatus status_of(const Vn100 & imu, Time now);
[[nodiscard]] DeviceStatus status_of(const ServoDiagnostics & servo);

}  // namespace stetro_driver::linux_io

#endif  // LINUX__DEVICE_STATUS_HPP_
