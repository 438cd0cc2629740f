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

#ifndef EMULATOR__IIO_TREE_HPP_
#define EMULATOR__IIO_TREE_HPP_

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>

#include "emulator/emulated_tof.hpp"
#include "linux/tof/sysfs_attribute.hpp"

namespace stetro_driver::emulator
{

/// A device as the kernel shows it.
struct IioDevice
{
  std::string i2c_name;            ///< bus and address, such as 1-0030
  std::string label{};             ///< empty: the attribute is missing, as without a device tree
  std::string name = "vl53l0x";    ///< of the driver
  std::string scale = "0.001000";  ///< in_distance_scale
  std::shared_ptr<EmulatedTof> tof{};  ///< who answers
};

/// A tree as /sys, with range sensors on I2C buses that measure, block and fail as the kernel's.
/**
 *   <root>/bus/iio/devices/iio:device0 -> <root>/devices/platform/i2c-1/1-0030/iio:device0
 *
 * Directories, links, names, labels and scales are on disk, so finding a sensor goes the same way
 * as on the robot. Only the reading of `in_distance_raw` goes through AttributeSource to the
 * sensor: a plain file neither blocks nor fails with an errno, a FIFO blocks but knows no errno,
 * and FUSE, which does both, needs /dev/fuse and the right to mount, which builds in containers and
 * on servers do not have. So there is one way that works everywhere. The file itself is there too:
 * who opens a sensor holds it open, and a leak shows among the descriptors of the program.
 *
 * Thread safe. Sensors may be plugged and unplugged while they are read.
 */
class IioTree : public linux_io::AttributeSource
{
public:
  /// \param root a directory that exists; `bus` and `devices` are made in it and removed with this
  /// \throws std::filesystem::filesystem_error
  explicit IioTree(std::filesystem::path root);
  ~IioTree() override;

  /// The kernel finds a device. Its N is the lowest that is free, whatever it had before.
  /** \throws std::logic_error if there is one of that I2C name */
  void plug(const IioDevice & device);

  /// The kernel loses it: its directory goes, and who holds it open reads ENODEV.
  /** \throws std::logic_error if there is none */
  void unplug(const std::string & i2c_name);

  [[nodiscard]] const std::filesystem::path & root() const noexcept { return root_; }

  [[nodiscard]] std::unique_ptr<linux_io::Attribute> open(
    const std::string & path, std::error_code & error) const override;

private:
  struct Plugged
  {
    std::filesystem::path directory;
    std::filesystem::path link;
    std::shared_ptr<EmulatedTof> tof;
  };

  std::filesystem::path root_;
  linux_io::SysfsFiles files_{};
  mutable std::mutex mutex_{};
  std::map<std::string, Plugged> devices_{};  // by I2C name
};

}  // namespace stetro_driver::emulator

#endif  // EMULATOR__IIO_TREE_HPP_
