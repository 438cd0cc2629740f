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

#ifndef LINUX__SERVO__HERKULEX_BUS_HPP_
#define LINUX__SERVO__HERKULEX_BUS_HPP_

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "linux/device_clock.hpp"
#include "linux/serial_port.hpp"
#include "linux/servo/herkulex_packet.hpp"

namespace stetro_driver::linux_io
{

/// The line all servos hang on.
struct HerkulexBusConfig
{
  SerialPortConfig port{"", 500'000};
  double reply_timeout_s = 0.005;  ///< patience with a servo, beside the time on the wire [s]
};

template <class Visitor>
void visit(HerkulexBusConfig & p, Visitor && each)
{
  visit(p.port, each);
  each(
    "reply_timeout_s", p.reply_timeout_s, stetro_config::Within{0.001, 0.1},
    "patience with a servo, beside the time on the wire [s]");
}

/// Requests and replies on a line of HerkuleX servos.
/**
 * Servos acknowledge reads only (the factory's policy, which HerkulexServo also sets), so a write
 * or a jog is one packet and nothing comes back. One request is under way at a time. A reply that
 * comes after its time-out is thrown away with the next request; a reply counts only if id,
 * command, address and length are those asked for.
 *
 * When the port hangs up the bus closes itself; open() opens it again. One thread uses it, but
 * for send_from_anywhere().
 */
class HerkulexBus
{
public:
  HerkulexBus(const HerkulexBusConfig & config, DeviceClock clock);

  /// \throws HardwareError naming the port, what happened and what is accepted
  void open();
  void close() noexcept;
  [[nodiscard]] bool is_open() const { return port_ != nullptr; }

  /// Registers that a servo was asked for: payload from 2 on, then status error and detail.
  /** \param command kRamRead or kEepRead \param who for a fault, "lift front (servo 5)" */
  [[nodiscard]] Result<HerkulexPacket> read(
    const std::string & who, std::uint8_t id, HerkulexCommand command, std::uint8_t address,
    std::uint8_t length);

  [[nodiscard]] std::optional<IoFault> write_ram(
    std::uint8_t id, std::uint8_t address, std::initializer_list<std::uint8_t> values);

  /// A packet that nobody acknowledges.
  [[nodiscard]] std::optional<IoFault> send(const HerkulexPacket & packet);
  [[nodiscard]] std::optional<IoFault> send(const HerkulexBytes & wire);

  /// The same from any thread, without waiting; lost if the port is closed or full.
  void send_from_anywhere(const HerkulexBytes & wire) noexcept;

  [[nodiscard]] const DeviceClock & clock() const { return clock_; }

  /// How long bytes take on the wire.
  [[nodiscard]] static Time on_wire(std::size_t bytes, std::int64_t baud)
  {
    return Time{static_cast<Time::rep>(bytes) * 10'000'000'000 / baud};
  }

private:
  [[nodiscard]] IoFault lost(IoFault fault);

  HerkulexBusConfig config_;
  DeviceClock clock_;
  std::mutex port_mutex_;  // of port_ as such, and of its writing end
  std::unique_ptr<SerialPort> port_;
  HerkulexDecoder decoder_;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__SERVO__HERKULEX_BUS_HPP_
