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

#ifndef LINUX__TOF__TOF_READDRESSING_HPP_
#define LINUX__TOF__TOF_READDRESSING_HPP_

#include <string>
#include <vector>

#include "linux/tof/tof_bus.hpp"

namespace stetro_driver::linux_io
{

/// One sensor of a bus, and the address it is to have.
struct SharedSensor
{
  XshutLine xshut;
  int address = 0;  ///< 7 bits
};

/// Reads `CHIP:LINE=ADDRESS`, such as `gpiochip0:17=0x30`.
/** \throws HardwareError naming the text and what is accepted */
[[nodiscard]] SharedSensor parse_shared_sensor(const std::string & text);

/// Gives each VL53L0X of a bus an address of its own, and then to the kernel's driver.
/**
 * All wake at 0x29, and the kernel's driver cannot move them: so all are shut down, and one after
 * the other is let go, asked who it is, moved, and asked again. The new address lasts until the
 * sensor is shut down or loses its power. Sensors the kernel had from an earlier run are taken from
 * it first, so it may be run again whenever a sensor was lost.
 *
 * \throws HardwareError if two sensors share an address or a line, or an address is none for them;
 *   if a sensor does not answer, is another device, or does not move; if one answers although all
 *   are shut down. Then no sensor is given to the kernel.
 */
void give_addresses(const std::vector<SharedSensor> & sensors, TofBus & bus);

}  // namespace stetro_driver::linux_io

#endif  // LINUX__TOF__TOF_READDRESSING_HPP_
