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

#include "network/wire_tap.hpp"

#include <arpa/inet.h>
#include <linux/if_packet.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "stetro_tests/deadline.hpp"
#include "stetro_tests/process.hpp"

namespace stetro_tests
{

namespace
{

constexpr const char * kNear = "outside";

void ip(const std::string & arguments)
{
  Process command({"/bin/sh", "-c", "PATH=$PATH:/usr/sbin:/sbin exec ip " + arguments});
  const auto ending = command.wait(10s);
  if (!ending || ending->exit_code != 0) {
    throw std::runtime_error("ip " + arguments + ": " + command.output());
  }
}

/// Describes an IPv4 packet; nothing for ARP and the kernel's own IPv6 chatter.
std::optional<std::string> described(const std::array<std::uint8_t, 2048> & frame, std::size_t size)
{
  constexpr std::size_t kEthernet = 14;
  if (size < kEthernet + 20 || frame[12] != 0x08 || frame[13] != 0x00) {
    return std::nullopt;
  }
  const std::uint8_t * packet = frame.data() + kEthernet;
  std::array<char, INET_ADDRSTRLEN> from{};
  std::array<char, INET_ADDRSTRLEN> to{};
  inet_ntop(AF_INET, packet + 12, from.data(), from.size());
  inet_ntop(AF_INET, packet + 16, to.data(), to.size());
  const std::size_t header = 4U * (packet[0] & 0x0fU);
  const bool udp = packet[9] == IPPROTO_UDP && size >= kEthernet + header + 8;
  const int port = udp ? packet[header + 2] * 256 + packet[header + 3] : 0;
  return (udp ? std::string("udp ") : "protocol " + std::to_string(packet[9]) + " ") + from.data() +
         " > " + to.data() + ":" + std::to_string(port);
}

}  // namespace

WireTap::WireTap()
{
  ip(std::string("link add ") + kNear + " type veth peer name farend");
  ip(std::string("addr add 10.90.0.1/24 dev ") + kNear);
  ip(std::string("link set ") + kNear + " up");
  ip("link set farend up");
  ip(std::string("route add 224.0.0.0/4 dev ") + kNear);
  socket_ = socket(AF_PACKET, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, htons(ETH_P_ALL));
  sockaddr_ll address{};
  address.sll_family = AF_PACKET;
  address.sll_protocol = htons(ETH_P_ALL);
  address.sll_ifindex = static_cast<int>(if_nametoindex(kNear));
  if (socket_ < 0 || bind(socket_, reinterpret_cast<sockaddr *>(&address), sizeof address) != 0) {
    throw std::runtime_error(std::string("packet socket: ") + std::strerror(errno));
  }
}

WireTap::~WireTap()
{
  close(socket_);
  try {
    ip(std::string("link del ") + kNear);
  } catch (const std::runtime_error &) {
    // It goes with the namespace anyway.
  }
}

std::vector<std::string> WireTap::packets()
{
  std::vector<std::string> result;
  std::array<std::uint8_t, 2048> frame{};
  for (;;) {
    const ssize_t size = recv(socket_, frame.data(), frame.size(), 0);
    if (size < 0) {
      return result;
    }
    if (const auto text = described(frame, static_cast<std::size_t>(size))) {
      result.push_back(*text);
    }
  }
}

}  // namespace stetro_tests
