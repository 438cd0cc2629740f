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

#ifndef STETRO_DRIVER__DRIVER_HARDWARE_HPP_
#define STETRO_DRIVER__DRIVER_HARDWARE_HPP_

#include <memory>

#include "stetro_driver/driver_setup.hpp"
#include "stetro_driver/hardware_interface.hpp"
#include "stetro_driver/simulated_world.hpp"

namespace stetro_driver
{

/// A robot as the driver takes it, and what is simulated about it.
struct DriverHardware
{
  std::unique_ptr<HardwareInterface> robot;
  SimulatedWorld * world = nullptr;  ///< around the robot and owned by it; null: the real one
  SteppedWorld * stepped = nullptr;  ///< the same world, if it waits for its steps
};

/// The robot that the parameter `hardware` names, not yet configured.
/** \throws stetro_config::ConfigError when the robot file does not list its devices */
[[nodiscard]] DriverHardware make_hardware(const DriverSetup & setup);

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__DRIVER_HARDWARE_HPP_
