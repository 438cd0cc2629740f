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

#ifndef LINUX__TOF__TOF_BUS_HPP_
#define LINUX__TOF__TOF_BUS_HPP_

#include <cstdint>
#include <optional>
#include <string>

#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// The GPIO line at a sensor's XSHUT pin: low, the sensor is shut down and forgets its address.
struct XshutLine
{
  std::string chip;
  unsigned int offset = 0;
};

[[nodiscard]] inline std::string to_string(const XshutLine & line)
{
  return line.chip + ":" + std::to_string(line.offset);
}

/// One I2C bus with range sensors on it, and the lines that shut them down.
/** Everything throws HardwareError if it cannot be done, and says what. */
class TofBus
{
public:
  TofBus() = default;
  virtual ~TofBus() = default;
  TofBus(const TofBus &) = delete;
  TofBus & operator=(const TofBus &) = delete;

  /// Pulls a line low; the sensor is in reset as long.
  virtual void hold_low(const XshutLine & line) = 0;
  /// Makes a line an input again: the pull-up of the sensor's board lets it boot.
  virtual void let_go(const XshutLine & line) = 0;
  virtual void wait(Time duration) = 0;

  /// \return nothing if nobody answers at this address
  [[nodiscard]] virtual std::optional<std::uint8_t> read_register(
    int address, std::uint8_t index) = 0;
  virtual void write_register(int address, std::uint8_t index, std::uint8_t value) = 0;

  /// Takes a sensor from the kernel that was given to it before; none is none.
  virtual void forget(int address) = 0;
  /// Gives a sensor to the kernel's driver, and waits until that has taken it.
  virtual void bind(int address) = 0;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__TOF__TOF_BUS_HPP_
