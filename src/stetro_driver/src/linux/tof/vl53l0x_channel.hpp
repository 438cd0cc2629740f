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

#ifndef LINUX__TOF__VL53L0X_CHANNEL_HPP_
#define LINUX__TOF__VL53L0X_CHANNEL_HPP_

#include <memory>
#include <optional>
#include <string>

#include "linux/device_clock.hpp"
#include "linux/tof/sysfs_attribute.hpp"
#include "linux/tof/tof_address.hpp"
#include "stetro_driver/result.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// One answer of a sensor.
struct TofMeasurement
{
  int millimetres = 0;  ///< 0 to 8191
  Time begun{0};        ///< when it was asked
  Time ended{0};        ///< when it had answered

  /// When the light was out: half-way, a measurement fills the whole time.
  [[nodiscard]] Time stamp() const noexcept { return begun + (ended - begun) / 2; }
  [[nodiscard]] Time took() const noexcept { return ended - begun; }
};

/// One VL53L0X through the kernel's IIO driver (drivers/iio/proximity/vl53l0x-i2c.c).
/**
 * Reading `in_distance_raw` starts a measurement and waits for it, 20 to 100 ms; the driver takes
 * no lock, so two readers of one sensor would spoil each other. One thread at a time.
 */
class Vl53l0xChannel
{
public:
  /// \param place how faults call it
  /// \param files outlives the channel
  Vl53l0xChannel(
    std::string place, TofAddress address, std::string sysfs_root, const AttributeSource & files,
    const DeviceClock & clock);

  /// Finds the device and checks that it is one: `name` is vl53l0x, the scale is a millimetre.
  [[nodiscard]] std::optional<IoFault> open();
  void close() noexcept;
  [[nodiscard]] bool is_open() const noexcept { return raw_ != nullptr; }
  /// Real path of its directory; empty while closed.
  [[nodiscard]] const std::string & directory() const noexcept { return directory_; }

  /// Measures, and blocks as long. Closes if the device is gone. \pre is_open()
  [[nodiscard]] Result<TofMeasurement> measure();

private:
  [[nodiscard]] IoFault fault(IoFaultKind kind, const std::string & what) const;
  [[nodiscard]] std::optional<IoFault> check_identity(const std::string & directory) const;

  std::string place_;
  TofAddress address_;
  std::string sysfs_root_;
  const AttributeSource & files_;
  DeviceClock clock_;
  std::string directory_{};
  std::unique_ptr<Attribute> raw_{};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__TOF__VL53L0X_CHANNEL_HPP_
