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

#include <chrono>
#include <string>

#include "linux/servo/herkulex_bus.hpp"
#include "servo_line.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using emulator::EmulatedServo;
using emulator::HerkulexEmulator;
using emulator::HerkulexLine;
using namespace std::chrono_literals;

constexpr char kWho[] = "servo 1";

Result<HerkulexPacket> read_policy(HerkulexBus & bus)
{
  return bus.read(kWho, 1, HerkulexCommand::kRamRead, ram::kTorquePolicy, 1);
}

TEST(HerkulexBus, ReadsAndWritesRegisters)
{
  const HerkulexLine line = test::fast_line("bus");
  const DeviceClock clock;
  HerkulexEmulator servos{line, {1}, clock};
  HerkulexBus bus{test::bus_config(line), clock};
  bus.open();
  ASSERT_FALSE(bus.write_ram(1, ram::kTorquePolicy, {0x24}));
  const auto reply = read_policy(bus);
  ASSERT_TRUE(reply) << reply.fault().detail;
  EXPECT_EQ(reply.value()[2], 0x24);
}

// At the factory's speed a read of one register is 9 + 12 bytes: 1.82 ms on the wire.
TEST(HerkulexBus, TakesTheTimeOfTheWireAtTheSpeedOfTheLine)
{
  HerkulexLine line = test::fast_line("paced");
  line.baud = 115'200;
  const DeviceClock clock;
  HerkulexEmulator servos{line, {1}, clock};
  HerkulexBus bus{test::bus_config(line), clock};
  bus.open();
  constexpr int kReads = 20;
  const Time begin = clock.now();
  for (int i = 0; i < kReads; ++i) {
    ASSERT_TRUE(read_policy(bus));
  }
  const Time each = (clock.now() - begin) / kReads;
  EXPECT_GE(each, HerkulexBus::on_wire(21, line.baud) + line.turn_round);
  EXPECT_EQ(servos.heard(), static_cast<std::uint64_t>(kReads));
}

TEST(HerkulexBus, IsNotUnderstoodAtAnotherSpeed)
{
  const HerkulexLine line = test::fast_line("speed");
  const DeviceClock clock;
  HerkulexEmulator servos{line, {1}, clock};
  HerkulexBusConfig config = test::bus_config(line);
  config.port.baud = 666'666;
  HerkulexBus bus{config, clock};
  bus.open();
  const auto reply = read_policy(bus);
  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.fault().kind, IoFaultKind::kSilent);
  EXPECT_EQ(reply.fault().detail, "servo 1: no answer");
}

TEST(HerkulexBus, TellsNoiseFromSilence)
{
  const HerkulexLine line = test::fast_line("noise");
  const DeviceClock clock;
  HerkulexEmulator servos{line, {1}, clock};
  servos.set_faults({{}, Time{0}, 1.0});
  HerkulexBus bus{test::bus_config(line), clock};
  bus.open();
  int bad = 0;
  for (int i = 0; i < 10; ++i) {
    const auto reply = read_policy(bus);
    ASSERT_FALSE(reply) << "every reply is garbled";
    bad += reply.fault().kind == IoFaultKind::kBadAnswer ? 1 : 0;
  }
  EXPECT_GT(bad, 3) << "a flipped header is noise; a packet that lost a byte may look unfinished";
}

TEST(HerkulexBus, NeverTakesALateReplyForAnotherRequest)
{
  const HerkulexLine line = test::fast_line("late");
  const DeviceClock clock;
  HerkulexEmulator servos{line, {1}, clock};
  HerkulexBus bus{test::bus_config(line), clock};
  bus.open();
  servos.set_faults({{}, 150ms, 0.0});  // half as much again as its patience
  for (std::uint8_t address = 0; address < 8; ++address) {
    EXPECT_FALSE(bus.read(kWho, 1, HerkulexCommand::kRamRead, address, 1)) << int{address};
  }
}

TEST(HerkulexBus, RunsOnTheClockOfTheDevices)
{
  HerkulexLine line = test::fast_line("faster");
  line.baud = 57'600;
  const DeviceClock clock{Time::zero(), 4.0};
  HerkulexEmulator servos{line, {1}, clock};
  HerkulexBusConfig config = test::bus_config(line);
  config.reply_timeout_s = 0.1;
  HerkulexBus bus{config, clock};
  bus.open();
  const Time begin = clock.now();
  ASSERT_TRUE(read_policy(bus));
  EXPECT_GE(clock.now() - begin, HerkulexBus::on_wire(21, line.baud));
}

}  // namespace
}  // namespace stetro_driver::linux_io
