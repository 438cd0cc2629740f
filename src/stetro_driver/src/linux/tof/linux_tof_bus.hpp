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

#ifndef LINUX__TOF__LINUX_TOF_BUS_HPP_
#define LINUX__TOF__LINUX_TOF_BUS_HPP_

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "linux/tof/tof_bus.hpp"

struct gpiod_chip;

namespace stetro_driver::linux_io
{

/// A bus of this machine: /dev/i2c-N, the GPIO character devices, and /sys/bus/i2c. Takes root.
class LinuxTofBus : public TofBus
{
public:
  /// \param number N of i2c-N
  /// \throws HardwareError if the bus cannot be opened
  LinuxTofBus(int number, std::string sysfs_root);
  ~LinuxTofBus() override;

  void hold_low(const XshutLine & line) override;
  void let_go(const XshutLine & line) override;
  void wait(Time duration) override;
  [[nodiscard]] std::optional<std::uint8_t> read_register(int address, std::uint8_t index) override;
  void write_register(int address, std::uint8_t index, std::uint8_t value) override;
  void forget(int address) override;
  void bind(int address) override;

private:
  struct CloseChip
  {
    void operator()(gpiod_chip * chip) const noexcept;
  };

  void select(int address);
  [[nodiscard]] gpiod_chip * chip(const std::string & name);
  [[nodiscard]] std::string device(int address) const;  ///< its directory in /sys
  void tell_kernel(const std::string & attribute, const std::string & text);

  int number_;
  std::string sysfs_root_;
  int fd_;
  std::map<std::string, std::unique_ptr<gpiod_chip, CloseChip>> chips_{};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__TOF__LINUX_TOF_BUS_HPP_
