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

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <memory>

#include "network/sockets.hpp"
#include "network/wire_tap.hpp"
#include "stetro_dds/context.hpp"
#include "stetro_tests/deadline.hpp"
#include "stetro_tests/loopback_domain.hpp"

namespace stetro_tests
{

// The tap hears a participant that talks to the subnet: a silence it reports means something.
TEST(WireTap, HearsAParticipantThatTalksToTheSubnet)
{
  const LoopbackDomain domain;
  if (const auto refusal = enter_network_of_its_own(); !refusal.empty()) {
    GTEST_SKIP() << refusal;
  }
  WireTap tap;
  stetro_dds::ContextOptions options;
  options.domain_id = domain.id();
  options.scope = stetro_dds::NetworkScope::kSubnet;
  const stetro_dds::Context context(options);
  const int port = 7400 + 250 * static_cast<int>(domain.id());
  const std::string announcement = "239.255.0.1:" + std::to_string(port);
  EXPECT_TRUE(poll_until(
    [&] {
      const auto packets = tap.packets();
      return std::any_of(packets.begin(), packets.end(), [&](const std::string & packet) {
        return packet.find(announcement) != std::string::npos;
      });
    },
    10s));
}

TEST(Sockets, OfAConfinedParticipantAreOnTheLoopback)
{
  const LoopbackDomain domain;
  stetro_dds::ContextOptions options;
  options.domain_id = domain.id();
  const stetro_dds::Context context(options);
  const auto sockets = sockets_of(getpid());
  EXPECT_GE(sockets.size(), 3U) << "two to receive and one to send";
  for (const OpenSocket & socket : sockets) {
    EXPECT_EQ(socket.address, "127.0.0.1") << socket.protocol << " port " << socket.port;
  }
}

}  // namespace stetro_tests
