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

#include "linux/servo/herkulex_bus.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace stetro_driver::linux_io
{
namespace
{

constexpr const char * kDevice = "servo bus";
constexpr Time kWritePatience = std::chrono::milliseconds{20};  // a full buffer empties by then

}  // namespace

HerkulexBus::HerkulexBus(const HerkulexBusConfig & config, DeviceClock clock)
: config_(config), clock_(clock)
{
}

void HerkulexBus::open()
{
  auto port = std::make_unique<SerialPort>(kDevice, config_.port);
  const std::lock_guard<std::mutex> lock{port_mutex_};
  port_ = std::move(port);
}

void HerkulexBus::close() noexcept
{
  const std::lock_guard<std::mutex> lock{port_mutex_};
  port_.reset();
}

IoFault HerkulexBus::lost(IoFault fault)
{
  close();
  return fault;
}

std::optional<IoFault> HerkulexBus::send(const HerkulexBytes & wire)
{
  if (!is_open()) {
    return IoFault{IoFaultKind::kSilent, std::string(kDevice) + ": closed"};
  }
  std::optional<IoFault> fault;
  {
    const std::lock_guard<std::mutex> lock{port_mutex_};
    fault = port_->write(wire.bytes.data(), wire.size, clock_.real(kWritePatience));
  }
  return fault ? std::optional<IoFault>{lost(std::move(*fault))} : std::nullopt;
}

std::optional<IoFault> HerkulexBus::send(const HerkulexPacket & packet)
{
  return send(encode(packet));
}

void HerkulexBus::send_from_anywhere(const HerkulexBytes & wire) noexcept
{
  try {
    const std::lock_guard<std::mutex> lock{port_mutex_};
    if (port_) {
      // Whoever uses the bus notices a port that hung up; there is nothing better to do here.
      static_cast<void>(port_->write(wire.bytes.data(), wire.size, Time::zero()));
    }
  } catch (...) {
    static_cast<void>(0);  // out of memory for the words of a fault: the packet is lost
  }
}

std::optional<IoFault> HerkulexBus::write_ram(
  std::uint8_t id, std::uint8_t address, std::initializer_list<std::uint8_t> values)
{
  HerkulexPacket packet{id, HerkulexCommand::kRamWrite};
  packet.append({address, static_cast<std::uint8_t>(values.size())});
  packet.append(values);
  return send(packet);
}

Result<HerkulexPacket> HerkulexBus::read(
  const std::string & who, std::uint8_t id, HerkulexCommand command, std::uint8_t address,
  std::uint8_t length)
{
  if (port_) {
    port_->drop_input();
  }
  decoder_.reset();
  HerkulexPacket request{id, command};
  request.append({address, length});
  if (auto fault = send(request)) {
    return *fault;
  }
  constexpr std::size_t kFrames = 2 * (HerkulexPacket::kHeader + 2) + 2;  // all but the registers
  const Time deadline = clock_.now() + on_wire(kFrames + length, config_.port.baud) +
                        seconds_to_time(config_.reply_timeout_s);
  const std::uint64_t noise = decoder_.dropped_bytes();
  bool other = false;
  std::optional<HerkulexPacket> reply;
  std::array<std::uint8_t, 256> chunk{};
  while (!reply) {
    const Time left = std::max(Time::zero(), deadline - clock_.now());
    const auto got = port_->read(chunk.data(), chunk.size(), clock_.real(left));
    if (!got) {
      return lost(got.fault());
    }
    if (got.value() == 0) {
      const bool garbled = other || decoder_.dropped_bytes() != noise;
      return garbled ? IoFault{IoFaultKind::kBadAnswer, who + ": garbled answer"}
                     : IoFault{IoFaultKind::kSilent, who + ": no answer"};
    }
    decoder_.feed(chunk.data(), got.value(), [&](const HerkulexPacket & packet) {
      const bool ours = packet.id() == id && packet.replies_to(command) &&
                        packet.size() == 4U + length && packet[0] == address && packet[1] == length;
      other = other || !ours;
      reply = ours ? packet : reply;
    });
  }
  return *reply;
}

}  // namespace stetro_driver::linux_io
