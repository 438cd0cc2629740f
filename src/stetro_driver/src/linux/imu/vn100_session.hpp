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

#ifndef LINUX__IMU__VN100_SESSION_HPP_
#define LINUX__IMU__VN100_SESSION_HPP_

#include <array>
#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "linux/device_clock.hpp"
#include "linux/imu/vn100_config.hpp"
#include "linux/imu/vn100_stream.hpp"
#include "linux/serial_port.hpp"
#include "stetro_driver/result.hpp"

namespace stetro_driver::linux_io
{

/// Who answers.
struct Vn100Identity
{
  std::string model;
  std::string serial_number;
};

/// One connection to a VN-100, from opening its port to losing it.
/** One thread. */
class Vn100Session
{
public:
  /// \param stop ends waiting for answers early
  /** \throws HardwareError when the port cannot be opened */
  Vn100Session(
    const Vn100Config & config, const DeviceClock & clock, const std::atomic<bool> & stop);

  /// Asks for model and serial number.
  [[nodiscard]] Result<Vn100Identity> identify();

  /// Has the configured output sent, and no other. Not stored in the sensor.
  [[nodiscard]] std::optional<IoFault> configure();

  using Sink = std::function<void(const Vn100Frame & frame, Time arrival)>;

  /// Takes in what comes within a patience of device time, or at once if there is something.
  /** \param sink is given each frame and when its first bit came */
  [[nodiscard]] std::optional<IoFault> listen(Time patience, const Sink & sink);

  [[nodiscard]] const StreamCounts & counts() const { return stream_.counts(); }

private:
  /// Sends a command and awaits its answer. \return the answer's fields behind the register
  Result<std::string> ask(const std::string & command, unsigned number, const std::string & fields);
  std::optional<IoFault> write_register(unsigned number, const std::string & fields);
  [[nodiscard]] IoFault bad_answer(const std::string & what) const;

  Vn100Config config_;
  DeviceClock clock_;
  const std::atomic<bool> & stop_;
  SerialPort port_;
  Vn100Stream stream_;
  std::array<std::uint8_t, 1024> bytes_{};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__IMU__VN100_SESSION_HPP_
