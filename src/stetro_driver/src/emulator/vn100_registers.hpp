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

#ifndef EMULATOR__VN100_REGISTERS_HPP_
#define EMULATOR__VN100_REGISTERS_HPP_

#include <cstdint>
#include <map>
#include <string>

#include "linux/imu/vn100_ascii.hpp"

namespace stetro_driver::emulator
{

/// What a VN-100 answers to a command, and what it was told to send.
/**
 * Knows the registers 1 model, 3 serial number, 5 baud, 6 and 7 type and rate of ASCII output, 30
 * which checksum, 75 binary output, and the commands RRG, WRG and ASY. The rest is refused as the
 * sensor refuses it. Only measurements of type YMR and binary packets with the driver's fields can
 * be switched on.
 */
class Vn100Registers
{
public:
  /// With the settings of the factory: ASCII YMR, 40 times a second.
  Vn100Registers(const std::string & model, const std::string & serial_number, std::uint32_t baud);

  /// \param line a command as it came, without its end \return the sentence that answers
  [[nodiscard]] std::string answer(const std::string & line);

  /// Measurements a second, 0: none.
  [[nodiscard]] double ascii_rate_hz() const;
  [[nodiscard]] double binary_rate_hz() const;
  [[nodiscard]] std::uint32_t baud() const;
  [[nodiscard]] linux_io::AsciiChecksum checksum() const;

private:
  [[nodiscard]] std::string obey(const linux_io::AsciiSentence & command);
  [[nodiscard]] std::string write(unsigned number, const linux_io::AsciiSentence & command);
  [[nodiscard]] unsigned field(unsigned number, std::size_t which) const;

  std::map<unsigned, std::string> registers_;  ///< their fields, with commas
  bool sending_ = true;                        ///< not paused by ASY
};

}  // namespace stetro_driver::emulator

#endif  // EMULATOR__VN100_REGISTERS_HPP_
