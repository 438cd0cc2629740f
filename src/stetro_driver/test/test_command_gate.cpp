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

#include <limits>

#include "stetro_driver/command_gate.hpp"

namespace stetro_driver
{
namespace
{

using std::chrono::milliseconds;

constexpr double kHalfPi = 1.57079632679489661923;

GateClocks at(int ms) { return {milliseconds{1'000'000 + ms}, milliseconds{5'000 + ms}}; }

GateSituation able()
{
  GateSituation situation;
  situation.active = true;
  return situation;
}

/// A valid command to roll forward, issued at `ms`, good for 150 ms.
CommandRequest roll(std::uint64_t sequence, int ms)
{
  CommandRequest request;
  request.issuer = "supervisor";
  request.issuer_instance = 7;
  request.sequence_number = sequence;
  request.stamp = at(ms).now;
  request.valid_for = milliseconds{150};
  request.motion.kind = MotionKind::kTwist;
  request.motion.vx_m_s = 0.05;
  return request;
}

class CommandGateTest : public ::testing::Test
{
protected:
  Refusal offer(const CommandRequest & request, int ms)
  {
    return gate_.offer(request, at(ms), situation_).reason;
  }

  MotionKind acting(int ms) { return gate_.in_force(at(ms)).command.kind; }

  CommandGate gate_{GateLimits{}};
  GateSituation situation_ = able();
};

TEST_F(CommandGateTest, HoldsUntilSomebodyCommands)
{
  EXPECT_EQ(acting(0), MotionKind::kHold);
  EXPECT_EQ(offer(roll(1, 0), 0), Refusal::kNone);
  EXPECT_EQ(acting(0), MotionKind::kTwist);
}

TEST_F(CommandGateTest, HoldsWhenTheLastCommandHasExpired)
{
  offer(roll(1, 0), 0);
  EXPECT_EQ(acting(149), MotionKind::kTwist);
  const InForce after = gate_.in_force(at(150));
  EXPECT_EQ(after.command.kind, MotionKind::kHold);
  ASSERT_TRUE(after.expired);
  EXPECT_EQ(after.expired->sequence_number, 1u);
  EXPECT_FALSE(gate_.in_force(at(151)).expired) << "told once";
  EXPECT_EQ(gate_.counters().expired, 1u);
}

TEST_F(CommandGateTest, CountsLifeFromTheStampNotFromTheArrival)
{
  offer(roll(1, 0), 100);  // 100 ms on the way: 50 ms are left
  EXPECT_EQ(acting(149), MotionKind::kTwist);
  EXPECT_EQ(acting(150), MotionKind::kHold);
}

TEST_F(CommandGateTest, AStampAheadOfUsDoesNotLiveLonger)
{
  offer(roll(1, 20), 0);  // the issuer's clock is 20 ms ahead
  EXPECT_EQ(acting(150), MotionKind::kHold);
}

TEST_F(CommandGateTest, HealsWhenCommandsReturn)
{
  offer(roll(1, 0), 0);
  EXPECT_EQ(acting(1000), MotionKind::kHold);
  EXPECT_EQ(offer(roll(2, 1000), 1000), Refusal::kNone);
  EXPECT_EQ(acting(1000), MotionKind::kTwist);
}

TEST_F(CommandGateTest, HoldsWhenTheRobotsClockStandsStill)
{
  offer(roll(1, 0), 0);
  GateClocks clocks = at(10);
  EXPECT_EQ(gate_.in_force(clocks).command.kind, MotionKind::kTwist);
  clocks.steady += milliseconds{199};
  EXPECT_EQ(gate_.in_force(clocks).command.kind, MotionKind::kTwist);
  clocks.steady += milliseconds{1};
  EXPECT_EQ(gate_.in_force(clocks).command.kind, MotionKind::kHold);
  EXPECT_EQ(gate_.counters().stalls, 1u);
  EXPECT_EQ(acting(20), MotionKind::kHold) << "a stalled command does not wake up again";
  EXPECT_EQ(offer(roll(2, 20), 20), Refusal::kNone);
}

TEST_F(CommandGateTest, HoldsWhenTheRobotsClockStoodStillUnwatched)
{
  offer(roll(1, 0), 0);
  GateClocks clocks = at(10);
  EXPECT_EQ(gate_.in_force(clocks).command.kind, MotionKind::kTwist);
  clocks = at(20);
  clocks.steady += milliseconds{200};  // nobody asked while it stood
  EXPECT_EQ(gate_.in_force(clocks).command.kind, MotionKind::kHold);
  EXPECT_EQ(gate_.counters().stalls, 1u);
}

TEST_F(CommandGateTest, RefusesWhatIsNotInOrder)
{
  offer(roll(5, 0), 0);
  EXPECT_EQ(offer(roll(5, 10), 10), Refusal::kOutOfOrder);
  EXPECT_EQ(offer(roll(4, 10), 10), Refusal::kOutOfOrder);
  EXPECT_EQ(offer(roll(9, 10), 10), Refusal::kNone);
  EXPECT_EQ(offer(roll(6, 1000), 1000), Refusal::kOutOfOrder) << "also after the lease ended";
  EXPECT_EQ(gate_.counters().refused_for(Refusal::kOutOfOrder), 3u);
}

TEST_F(CommandGateTest, LeasesToOneIssuerAtATime)
{
  offer(roll(1, 0), 0);
  CommandRequest other = roll(1, 10);
  other.issuer = "joystick";
  EXPECT_EQ(offer(other, 10), Refusal::kForeignIssuer);
  other.stamp = at(150).now;
  EXPECT_EQ(offer(other, 150), Refusal::kNone) << "the lease was free again";
  EXPECT_EQ(offer(roll(2, 160), 160), Refusal::kForeignIssuer);
}

TEST_F(CommandGateTest, ARestartedIssuerIsANewInstance)
{
  offer(roll(50, 0), 0);
  CommandRequest restarted = roll(1, 10);
  restarted.issuer_instance = 8;
  EXPECT_EQ(offer(restarted, 10), Refusal::kForeignIssuer);
  restarted.stamp = at(200).now;
  EXPECT_EQ(offer(restarted, 200), Refusal::kNone) << "its numbers start anew";
}

TEST_F(CommandGateTest, RefusesBadStampsAndLifetimes)
{
  CommandRequest request = roll(1, 0);
  request.stamp = Time::zero();
  EXPECT_EQ(offer(request, 0), Refusal::kBadStamp) << "zero";
  EXPECT_EQ(offer(roll(1, 21), 0), Refusal::kBadStamp) << "in the future";
  EXPECT_EQ(offer(roll(1, 0), 150), Refusal::kBadStamp) << "older than it is valid";
  request = roll(1, 0);
  request.valid_for = milliseconds{201};
  EXPECT_EQ(offer(request, 0), Refusal::kOutOfBounds);
  request.valid_for = Time::zero();
  EXPECT_EQ(offer(request, 0), Refusal::kOutOfBounds);
  EXPECT_EQ(acting(0), MotionKind::kHold);
}

TEST_F(CommandGateTest, RefusesNumbersThatAreNone)
{
  CommandRequest request = roll(1, 0);
  request.motion.vx_m_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(offer(request, 0), Refusal::kNotFinite);
  request = roll(1, 0);
  request.motion.steering_rad = std::numeric_limits<double>::infinity();
  EXPECT_EQ(offer(request, 0), Refusal::kNotFinite) << "even in a field that the kind ignores";
  request = roll(1, 0);
  request.motion.vx_m_s = -0.31;
  EXPECT_EQ(offer(request, 0), Refusal::kOutOfBounds);
  request.motion = {};
  request.motion.kind = MotionKind::kLift;
  request.motion.block = 4;
  EXPECT_EQ(offer(request, 0), Refusal::kOutOfBounds);
  request.motion = {};
  request.motion.kind = MotionKind::kUnknown;
  EXPECT_EQ(offer(request, 0), Refusal::kUnknownKind);
}

TEST_F(CommandGateTest, RollsOnlyWhereTheWheelsPoint)
{
  CommandRequest across = roll(1, 0);
  across.motion.vx_m_s = 0.0;
  across.motion.vy_m_s = 0.1;
  EXPECT_EQ(offer(across, 0), Refusal::kWrongSteering);
  situation_.steering_rad = kHalfPi;
  EXPECT_EQ(offer(across, 0), Refusal::kNone);
  CommandRequest turn = roll(2, 0);
  EXPECT_EQ(offer(turn, 0), Refusal::kWrongSteering) << "vx with the wheels at pi/2";
  turn.motion.vx_m_s = 0.0;
  turn.motion.wz_rad_s = 0.1;
  situation_.steering_moving = true;
  EXPECT_EQ(offer(turn, 0), Refusal::kWrongSteering) << "while they turn";
  situation_.steering_moving = false;
  EXPECT_EQ(offer(turn, 0), Refusal::kNone);
}

TEST_F(CommandGateTest, KeepsTheRobotOnItsFeet)
{
  CommandRequest lift = roll(1, 0);
  lift.motion = {};
  lift.motion.kind = MotionKind::kLift;
  lift.motion.block = 2;
  situation_.standing = {true, true, false};
  EXPECT_EQ(offer(lift, 0), Refusal::kUnsafe);
  situation_.standing = {true, true, true};
  EXPECT_EQ(offer(lift, 0), Refusal::kNone);
  lift = roll(2, 0);
  lift.motion = {};
  lift.motion.kind = MotionKind::kLift;
  lift.motion.block = 1;
  situation_.standing = {true, false, true};
  EXPECT_EQ(offer(lift, 0), Refusal::kUnsafe);
}

TEST_F(CommandGateTest, RefusesEverythingWhileItMayNotMove)
{
  situation_.active = false;
  EXPECT_EQ(offer(roll(1, 0), 0), Refusal::kNotActive);
  situation_ = able();
  situation_.fault = true;
  EXPECT_EQ(offer(roll(1, 0), 0), Refusal::kFault);
  situation_ = able();
  CommandRequest nobody = roll(1, 0);
  nobody.issuer.clear();
  EXPECT_EQ(offer(nobody, 0), Refusal::kBadIssuer);
  CommandRequest stump = roll(1, 0);
  stump.issuer_cut = true;
  EXPECT_EQ(offer(stump, 0), Refusal::kBadIssuer);
  EXPECT_EQ(offer(roll(1, 0), 0), Refusal::kNone) << "a refused number is not used up";
}

TEST_F(CommandGateTest, LatchesTheEmergencyStop)
{
  offer(roll(1, 0), 0);
  gate_.latch_emergency_stop();
  EXPECT_EQ(acting(1), MotionKind::kHold);
  EXPECT_EQ(offer(roll(2, 10), 10), Refusal::kEmergencyStop);
  gate_.reset_emergency_stop();
  EXPECT_EQ(acting(11), MotionKind::kHold) << "it needs a new command";
  EXPECT_EQ(offer(roll(3, 20), 20), Refusal::kNone);
}

TEST_F(CommandGateTest, AStopThenAHoldOfOneInstanceAskForTheReset)
{
  const auto of = [&](MotionKind kind, std::uint64_t number, std::uint64_t instance) {
    CommandRequest request = roll(number, 0);
    request.issuer_instance = instance;
    request.motion = JointCommand{};
    request.motion.kind = kind;
    EXPECT_EQ(offer(request, 0), Refusal::kEmergencyStop);
    return gate_.take_reset_request();
  };
  gate_.latch_emergency_stop();
  EXPECT_FALSE(of(MotionKind::kHold, 1, 7)) << "it holds, as it did before";
  EXPECT_FALSE(of(MotionKind::kStop, 2, 7));
  EXPECT_FALSE(of(MotionKind::kHold, 1, 8)) << "another one, such as after a restart";
  EXPECT_TRUE(of(MotionKind::kHold, 3, 7));
  EXPECT_FALSE(of(MotionKind::kHold, 4, 7)) << "once";
  EXPECT_FALSE(of(MotionKind::kStop, 5, 7));
  EXPECT_FALSE(of(MotionKind::kTwist, 6, 7)) << "no motion resets";
  EXPECT_FALSE(of(MotionKind::kHold, 7, 7));
  EXPECT_FALSE(of(MotionKind::kStop, 8, 7));
  situation_.emergency_stop_pressed = true;
  EXPECT_FALSE(of(MotionKind::kHold, 9, 7));
  situation_.emergency_stop_pressed = false;
  EXPECT_FALSE(of(MotionKind::kHold, 10, 7)) << "it was too early, it takes another STOP";
}

// A supervisor that is in its fault state goes on sending STOP.
TEST_F(CommandGateTest, AnotherOnesStopDoesNotUndoTheFirst)
{
  gate_.latch_emergency_stop();
  const auto send = [&](MotionKind kind, std::uint64_t number, std::uint64_t instance) {
    CommandRequest request = roll(number, 0);
    request.issuer_instance = instance;
    request.motion = JointCommand{kind};
    offer(request, 0);
  };
  send(MotionKind::kStop, 1, 7);
  send(MotionKind::kStop, 1, 8);
  send(MotionKind::kHold, 2, 7);
  EXPECT_TRUE(gate_.take_reset_request());
}

TEST_F(CommandGateTest, HardwareThatNeedsAPersonIsResetTheSameWay)
{
  const auto asks_with = [&](GateSituation situation, std::uint64_t number) {
    situation_ = situation;
    CommandRequest request = roll(number, 0);
    for (const MotionKind kind : {MotionKind::kStop, MotionKind::kHold}) {
      request.sequence_number = ++number;
      request.motion = JointCommand{kind};
      offer(request, 0);
    }
    return gate_.take_reset_request();
  };
  const GateSituation well = situation_;
  EXPECT_FALSE(asks_with(well, 10)) << "there is nothing to reset";
  GateSituation broken = well;
  broken.fault = true;
  EXPECT_TRUE(asks_with(broken, 20));
  GateSituation dark = well;
  dark.active = false;
  EXPECT_FALSE(asks_with(dark, 30)) << "nobody wanted it to have power";
  dark.refused_power = true;
  EXPECT_TRUE(asks_with(dark, 40));
}

TEST_F(CommandGateTest, AnEmergencyStopIsTheReasonAlsoWithoutPower)
{
  situation_.active = false;
  situation_.emergency_stop = true;
  EXPECT_EQ(offer(roll(1, 0), 0), Refusal::kEmergencyStop);
}

TEST(GateLimits, AreChecked)
{
  GateLimits limits;
  limits.max_vx_m_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CommandGate{limits}, std::invalid_argument);
}

}  // namespace
}  // namespace stetro_driver
