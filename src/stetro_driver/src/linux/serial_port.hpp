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

#ifndef LINUX__SERIAL_PORT_HPP_
#define LINUX__SERIAL_PORT_HPP_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "stetro_config/field.hpp"
#include "stetro_config/rule.hpp"
#include "stetro_driver/result.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// Which serial port, and how fast.
struct SerialPortConfig
{
  std::string path;             ///< a stable name, such as /dev/serial/by-id/...
  std::int64_t baud = 115'200;  ///< any speed, standard or not [bit/s]
};

template <class Visitor>
void visit(SerialPortConfig & p, Visitor && each)
{
  each("path", p.path, stetro_config::Any{}, "serial device, by a name that stays");
  each("baud", p.baud, stetro_config::Within{1'200, 4'000'000}, "speed, as the device [bit/s]");
}

/// A serial port: raw, 8N1, nobody else's.
/**
 * Waits with poll() and never inside read() or write(). Times are real ones, what poll() waits;
 * a DeviceClock's owner converts with `real()`. A device that is unplugged is an IoFault of kind
 * kSilent from then on: make another SerialPort when it is back.
 *
 * One thread reads and one may write.
 */
class SerialPort
{
public:
  /// \param device what to call it in a fault, "servo bus"
  /** \throws HardwareError naming device and path, what happened and what is accepted */
  SerialPort(std::string device, const SerialPortConfig & config);
  ~SerialPort();
  SerialPort(const SerialPort &) = delete;
  SerialPort & operator=(const SerialPort &) = delete;

  /// Waits until there is something and takes it. \return how many bytes; 0: none in time
  [[nodiscard]] Result<std::size_t> read(std::uint8_t * to, std::size_t room, Time patience);

  /// Hands all bytes to the kernel, which may still be sending them when this returns.
  [[nodiscard]] std::optional<IoFault> write(
    const std::uint8_t * from, std::size_t size, Time patience);

  /// Forgets what was received and not yet read.
  void drop_input() noexcept;

  /// Whether the kernel agreed to hand bytes over at once. Ptys and some adapters do not know how.
  [[nodiscard]] bool low_latency() const { return low_latency_; }
  [[nodiscard]] const std::string & device() const { return device_; }
  [[nodiscard]] int fd() const { return fd_; }

private:
  void claim(const std::string & path);
  void set_raw(const SerialPortConfig & config);
  [[nodiscard]] IoFault gone(const char * what) const;

  std::string device_;
  int fd_ = -1;
  bool low_latency_ = false;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__SERIAL_PORT_HPP_
