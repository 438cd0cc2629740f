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

#ifndef LINUX__TOF__TOF_ADDRESS_HPP_
#define LINUX__TOF__TOF_ADDRESS_HPP_

#include <optional>
#include <string>

#include "linux/tof/sysfs_attribute.hpp"
#include "stetro_driver/result.hpp"

namespace stetro_driver::linux_io
{

/// How a range sensor is told from the others. The N of `iio:deviceN` will not do: it follows the
/// order in which the kernel found them.
struct TofAddress
{
  enum class By { kNone, kLabel, kI2cName, kPath };
  By by = By::kNone;  ///< kNone: this sensor is not fitted
  std::string key{};  ///< label, I2C device name such as 1-0030, or directory of the IIO device
};

/// Reads `label:side_left`, `i2c:1-0030`, `path:/sys/bus/iio/devices/iio:device0` or `none`.
[[nodiscard]] std::optional<TofAddress> parse_tof_address(const std::string & text);

/// The rule of a field that holds one, see stetro_config/rule.hpp.
struct IsTofAddress
{
  [[nodiscard]] bool accepts(const std::string & text) const
  {
    return parse_tof_address(text).has_value();
  }
  [[nodiscard]] static std::string words()
  {
    return "label:NAME, i2c:BUS-ADDRESS, path:DIRECTORY or none";
  }
};

/// Finds the directory of an IIO device.
/**
 * \param sysfs_root `/sys`, or where an emulated tree stands
 * \param address not kNone
 * \return the real path of its directory, or in words why there is none, or more than one
 */
[[nodiscard]] Result<std::string> find_iio_device(
  const AttributeSource & files, const std::string & sysfs_root, const TofAddress & address);

}  // namespace stetro_driver::linux_io

#endif  // LINUX__TOF__TOF_ADDRESS_HPP_
