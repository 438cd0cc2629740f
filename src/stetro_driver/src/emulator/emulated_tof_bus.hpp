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

#ifndef EMULATOR__EMULATED_TOF_BUS_HPP_
#define EMULATOR__EMULATED_TOF_BUS_HPP_

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "linux/tof/tof_bus.hpp"

namespace stetro_driver::emulator
{

/// VL53L0X sensors of one bus with their XSHUT lines: what a register gets and who answers where.
/** Two awake sensors of one address answer together, as open-drain lines do: the zeros win. */
class EmulatedTofBus : public linux_io::TofBus
{
public:
  /// Adds a sensor that is powered. \param xshut none: not wired, it is always awake
  void add(const std::optional<linux_io::XshutLine> & xshut, std::uint8_t model = 0xEE);

  void hold_low(const linux_io::XshutLine & line) override;
  void let_go(const linux_io::XshutLine & line) override;
  void wait(Time duration) override;
  [[nodiscard]] std::optional<std::uint8_t> read_register(int address, std::uint8_t index) override;
  void write_register(int address, std::uint8_t index, std::uint8_t value) override;
  void forget(int address) override;
  void bind(int address) override;

  /// Where the awake sensors are, in the order they were added.
  [[nodiscard]] std::vector<int> addresses() const;
  /// What the kernel's driver has.
  [[nodiscard]] const std::set<int> & bound() const noexcept { return bound_; }

private:
  struct Sensor
  {
    std::string xshut;  ///< empty: not wired
    std::uint8_t model;
    int address;
    Time awake_for;  ///< negative while it is shut down
  };
  [[nodiscard]] std::vector<Sensor *> who_answers(int address);

  std::vector<Sensor> sensors_{};
  std::set<int> bound_{};
};

}  // namespace stetro_driver::emulator

#endif  // EMULATOR__EMULATED_TOF_BUS_HPP_
