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

// Nothing leaves the computer while the robot climbs.

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "integration/simulated_time.hpp"
#include "network/sockets.hpp"
#include "network/wire_tap.hpp"

namespace stetro_tests
{

TEST(LoopbackOnly, EverySocketIsBoundToTheLoopback)
{
  RobotRun run;
  ASSERT_EQ(run.start_climb(), "");
  for (Process * process : {&run.stack.driver(), &run.stack.localizer(), &run.stack.supervisor()}) {
    const auto sockets = sockets_of(process->pid());
    EXPECT_GE(sockets.size(), 3U) << "two to receive and one to send";
    for (const OpenSocket & socket : sockets) {
      EXPECT_EQ(socket.address, "127.0.0.1")
        << socket.protocol << " port " << socket.port << " of " << process->tail(1);
    }
  }
}

// test_wire_tap.cpp shows that this tap hears a participant that does talk to the subnet.
TEST(LoopbackOnly, NoPacketPassesAnotherInterfaceDuringAClimb)
{
  if (const auto refusal = enter_network_of_its_own(); !refusal.empty()) {
    GTEST_SKIP() << "needs a network of its own to tap: " << refusal;
  }
  std::unique_ptr<WireTap> tap;
  try {
    tap = std::make_unique<WireTap>();
  } catch (const std::runtime_error & error) {
    GTEST_SKIP() << "needs a tap: " << error.what();
  }
  RobotRun run;
  ASSERT_EQ(run.start_climb(), "");
  ASSERT_TRUE(let_pass(run, 20s)) << run.stack.tails();
  const auto packets = tap->packets();
  EXPECT_EQ(packets.size(), 0U) << "the first: " << packets.front();
}

}  // namespace stetro_tests
