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

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "linux/servo/servo_bank.hpp"
#include "servo_line.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using emulator::EmulatedServo;
using emulator::HerkulexEmulator;
using emulator::HerkulexFaults;
using namespace std::chrono_literals;

constexpr int kSamplePeriods = 3;  // in which a fault has to show

const std::vector<ServoPlace> kPlaces{
  {"wheel", 1, {ServoMode::kVelocity, 0x35, 0, true}},
  {"steering", 2, {ServoMode::kPosition, 0x24, 0, false}},
  {"lift", 3, {ServoMode::kPosition, 0x00, 0, false}}};

// One way in which a line or a servo fails, and how it comes back.
struct Trouble
{
  const char * name;
  std::function<void(HerkulexEmulator &)> begin;
  std::function<void(HerkulexEmulator &)> end;
  std::vector<IoFaultKind> kinds;  // that describe it
};

const std::vector<Trouble> kTroubles{
  {"unplugged",
   [](HerkulexEmulator & e) { e.unplug(); },
   [](HerkulexEmulator & e) { e.plug(); },
   {IoFaultKind::kSilent}},
  {"all silent",
   [](HerkulexEmulator & e) {
     e.set_faults({{1, 2, 3}, Time{0}, 0.0});
   },
   [](HerkulexEmulator & e) { e.set_faults({}); },
   {IoFaultKind::kSilent}},
  {"one silent",
   [](HerkulexEmulator & e) {
     e.set_faults({{3}, Time{0}, 0.0});
   },
   [](HerkulexEmulator & e) { e.set_faults({}); },
   {IoFaultKind::kSilent}},
  {"slow",
   [](HerkulexEmulator & e) {
     e.set_faults({{}, 150ms, 0.0});
   },
   [](HerkulexEmulator & e) { e.set_faults({}); },
   {IoFaultKind::kSilent, IoFaultKind::kBadAnswer}},
  {"garbled",
   [](HerkulexEmulator & e) {
     e.set_faults({{}, Time{0}, 1.0});
   },
   [](HerkulexEmulator & e) { e.set_faults({}); },
   {IoFaultKind::kSilent, IoFaultKind::kBadAnswer}},
  {"replaced by another id",
   [](HerkulexEmulator & e) { e.with(3, [](EmulatedServo & s) { s.set_id(9); }); },
   [](HerkulexEmulator & e) { e.with(9, [](EmulatedServo & s) { s.set_id(3); }); },
   {IoFaultKind::kSilent}},
  {"two with one id",
   [](HerkulexEmulator & e) { e.with(3, [](EmulatedServo & s) { s.set_id(2); }); },
   [](HerkulexEmulator & e) { e.with(2, [](EmulatedServo & s) { s.set_id(3); }); },
   {IoFaultKind::kSilent, IoFaultKind::kBadAnswer}},
};

bool is_one_of(IoFaultKind kind, const std::vector<IoFaultKind> & kinds)
{
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

// Asks once a period until all is well; the emulated servos need the processor in between.
bool recovers(ServoBank & bank)
{
  return eventually([&] { return !bank.cycle(); });
}

class ServoBankIn : public testing::TestWithParam<std::size_t>
{
protected:
  ServoBankIn() : line(test::fast_line("bank")), servos(line, {1, 2, 3}, clock) {}

  const Trouble & trouble = kTroubles[GetParam()];
  DeviceClock clock;
  emulator::HerkulexLine line;
  HerkulexEmulator servos;
};

TEST_P(ServoBankIn, TroubleAtTheStartIsNamedAndTheNextStartSucceeds)
{
  const OpenResources before;
  ServoBank bank{test::bus_config(line), kPlaces, clock};
  for (int i = 0; i < 2; ++i) {
    trouble.begin(servos);
    try {
      bank.open();
      ADD_FAILURE() << trouble.name << " was not noticed";
    } catch (const HardwareError & error) {
      EXPECT_NE(std::string(error.what()).find("accepted:"), std::string::npos) << error.what();
    }
    trouble.end(servos);
    ASSERT_TRUE(eventually([&] {
      try {
        bank.open();
        return true;
      } catch (const HardwareError &) {
        return false;  // replies that are late, or were, are still under way
      }
    }))
      << trouble.name;
    EXPECT_FALSE(bank.cycle()) << trouble.name;
    bank.bus().close();
  }
  EXPECT_TRUE(OpenResources{} == before) << trouble.name;
}

TEST_P(ServoBankIn, TroubleInTheMiddleIsATypedFaultAndEnds)
{
  ServoBank bank{test::bus_config(line), kPlaces, clock};
  bank.open();
  ASSERT_FALSE(bank.set_torque(Torque::kOn, true));
  const OpenResources before;
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(recovers(bank)) << trouble.name;
    trouble.begin(servos);
    std::optional<IoFault> fault;
    int periods = 0;
    while (!fault && periods < kSamplePeriods) {
      fault = bank.cycle();
      ++periods;
    }
    ASSERT_TRUE(fault) << trouble.name << " not seen in " << periods << " periods";
    EXPECT_TRUE(is_one_of(fault->kind, trouble.kinds)) << trouble.name << ": " << fault->detail;
    for (int more = 0; more < 5; ++more) {
      EXPECT_TRUE(bank.cycle()) << trouble.name << " is still there";
    }
    trouble.end(servos);
    ASSERT_TRUE(recovers(bank)) << trouble.name << ": " << bank.cycle()->detail;
    for (std::uint8_t id = 1; id <= 3; ++id) {
      const auto torque = servos.with(id, [](EmulatedServo & s) { return s.drive().torque; });
      EXPECT_EQ(torque, Torque::kOn) << trouble.name << ", servo " << int{id};
    }
  }
  EXPECT_TRUE(OpenResources{} == before) << trouble.name;
}

INSTANTIATE_TEST_SUITE_P(
  AllTroubles, ServoBankIn, testing::Range<std::size_t>(0, kTroubles.size()), [](const auto & at) {
    std::string name = kTroubles[at.param].name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  });

// Three emulated servos that are well.
struct Healthy
{
  explicit Healthy(const std::string & name)
  : line(test::fast_line(name)),
    servos(line, {1, 2, 3}, clock),
    bank(test::bus_config(line), kPlaces, clock)
  {
    bank.open();
  }

  emulator::ServoDrive drive(std::uint8_t id)
  {
    return servos.with(id, [](const EmulatedServo & servo) { return servo.drive(); });
  }

  DeviceClock clock;
  emulator::HerkulexLine line;
  HerkulexEmulator servos;
  ServoBank bank;
};

TEST(ServoBank, ForgivesASingleReplyThatIsLost)
{
  Healthy h{"forgive"};
  h.servos.set_faults({{2}, Time{0}, 0.0});
  EXPECT_FALSE(h.bank.cycle());
  h.servos.set_faults({});
  EXPECT_FALSE(h.bank.cycle());
  EXPECT_EQ(h.bank.servos()[1].health().counts().timeouts, 1U);
}

TEST(ServoBank, SetsUpAgainWhatWasWithoutPower)
{
  Healthy h{"power"};
  ASSERT_FALSE(h.bank.set_torque(Torque::kOn, true));
  h.servos.with(1, [](EmulatedServo & s) { s.power_cycle(); });
  const auto fault = h.bank.cycle();
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->detail, "wheel (servo 1): has lost its settings, was without power");
  ASSERT_TRUE(recovers(h.bank));
  EXPECT_EQ(h.drive(1).mode, ServoMode::kVelocity);
  EXPECT_EQ(h.drive(1).torque, Torque::kOn);
}

TEST(ServoBank, BrakesALiftInTroubleAndClearsItOnlyWhenAsked)
{
  Healthy h{"overload"};
  ASSERT_FALSE(h.bank.set_torque(Torque::kOn, true));
  h.servos.with(3, [](EmulatedServo & s) { s.trip(kOverloadError); });
  EXPECT_EQ(h.drive(3).torque, Torque::kOn) << "its policy does not let it go";
  const auto fault = h.bank.cycle();
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->detail, "lift (servo 3): latched error: overload");
  EXPECT_EQ(h.drive(3).torque, Torque::kBrake);
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(h.bank.cycle()) << "it latches";
  }
  ASSERT_FALSE(h.bank.set_torque(Torque::kOn, true));
  EXPECT_FALSE(h.bank.cycle());
  EXPECT_EQ(h.drive(3).torque, Torque::kOn);
}

TEST(ServoBank, RefusesALiftThatWouldHaveToBeFreed)
{
  const emulator::HerkulexLine line = test::fast_line("freed");
  const DeviceClock clock;
  HerkulexEmulator servos{line, {1, 2, 3}, clock};
  HerkulexPacket spin{3, HerkulexCommand::kSJog};
  spin.append({0, 0, 0, kJogVelocity, 3});
  servos.with(3, [&](EmulatedServo & s) { static_cast<void>(s.hear(spin, clock.now())); });
  ServoBank bank{test::bus_config(line), kPlaces, clock};
  EXPECT_THROW(bank.open(), HardwareError);
}

TEST(ServoBank, JogsAllInOnePacketWithTheSignsOfTheirModes)
{
  Healthy h{"jog"};
  const HerkulexBytes wire = h.bank.jog({{-300, true}, {600, true}, {700, false}}, 30ms);
  HerkulexDecoder decoder;
  std::vector<HerkulexPacket> packets;
  decoder.feed(wire.bytes.data(), wire.size, [&](const auto & p) { packets.push_back(p); });
  ASSERT_EQ(packets.size(), 1U);
  const HerkulexPacket & jog = packets.front();
  EXPECT_TRUE(jog.is(HerkulexCommand::kSJog));
  ASSERT_EQ(jog.size(), 9U) << "a playtime and two goals";
  EXPECT_EQ(jog[0], 2) << "30 ms of ticks of 11.2 ms";
  EXPECT_EQ(jog.word(1), 0x4000 | 300);
  EXPECT_EQ(jog[3], kJogVelocity);
  EXPECT_EQ(jog[4], 1);
  EXPECT_EQ(jog.word(5), 600);
  EXPECT_EQ(jog[7], 0);
  EXPECT_EQ(jog[8], 2);
}

}  // namespace
}  // namespace stetro_driver::linux_io
