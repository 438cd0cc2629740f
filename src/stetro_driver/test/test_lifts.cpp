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
#include <cmath>

#include "linux/motion/lifts.hpp"
#include "linux/motion/steering.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using namespace std::chrono_literals;

constexpr double kPeriodS = 0.02;
constexpr Time kPeriod = 20ms;

LiftsConfig robot()
{
  LiftsConfig config;
  config.m_per_rad = 0.045;
  config.speed_m_s = 0.06;
  config.stroke_m = 0.18;
  return config;
}

// Lifts and what they move: servos that follow, between stops that nothing passes.
struct Body
{
  Body() { measure(); }

  void measure()
  {
    lifts.measure(
      now, {servo_rad(config.joints[0], extensions_m[0] / config.m_per_rad),
            servo_rad(config.joints[1], extensions_m[1] / config.m_per_rad)});
  }

  // One period: the servos go where they are told unless something is in the way.
  void period()
  {
    now += kPeriod;
    lifts.advance(now, kPeriodS);
    const auto goals = lifts.servo_goals_rad();
    for (std::size_t i = 0; i < kPair; ++i) {
      const double goal_m = config.m_per_rad * joint_rad(config.joints[i], goals[i]);
      extensions_m[i] = std::clamp(goal_m - (i == 0 ? droop_m : 0.0), lowest_m[i], highest_m[i]);
    }
    measure();
  }

  void periods(int count)
  {
    for (int i = 0; i < count; ++i) {
      period();
    }
  }

  // \return periods until it is done
  int run(MotionKind kind, int block)
  {
    lifts.start(kind, block);
    int periods = 0;
    do {
      lifts.start(kind, block);
      period();
      ++periods;
    } while (reading(block).moving && periods < 1000);
    return periods;
  }

  BlockReading reading(int block) const
  {
    return lifts.readings()[static_cast<std::size_t>(block - 1)];
  }

  LiftsConfig config = robot();
  Lifts lifts{config};
  LiftExtensions extensions_m{};
  LiftExtensions lowest_m{-1.0, -1.0};
  LiftExtensions highest_m{1.0, 1.0};
  double droop_m = 0.0;  // of block 1 under its weight
  Time now{1s};
};

TEST(Lifts, GiveHeightsAboveTheLowestBlock)
{
  using Heights = std::array<double, kBlocks>;
  EXPECT_EQ(block_heights_m({0.0, 0.0}), (Heights{0.0, 0.0, 0.0}));
  EXPECT_EQ(block_heights_m({0.14, 0.0}), (Heights{0.14, 0.0, 0.0}));
  EXPECT_EQ(block_heights_m({0.0, -0.14}), (Heights{0.14, 0.14, 0.0}));
  const Heights lifted = block_heights_m({-0.04, -0.18});  // block 2 in the air
  EXPECT_NEAR(lifted[0], 0.14, 1e-12);
  EXPECT_NEAR(lifted[1], 0.18, 1e-12);
  EXPECT_EQ(lifted[2], 0.0);
}

TEST(Lifts, LiftABlockByTheStrokeAtItsSpeed)
{
  Body body;
  const int periods = body.run(MotionKind::kLift, 1);
  EXPECT_NEAR(periods, 150, 4);  // 0.18 m at 0.06 m/s are 3 s
  EXPECT_NEAR(body.reading(1).height_m, 0.18, 0.0016);
  EXPECT_TRUE(body.reading(1).at_upper_lock);
  EXPECT_FALSE(body.reading(1).at_lower_lock);
  EXPECT_FALSE(body.reading(1).fault);
  EXPECT_EQ(body.reading(1).load, 0.0);
  EXPECT_TRUE(body.reading(2).at_lower_lock);
  EXPECT_TRUE(std::isnan(body.reading(2).load)) << "not measured";
}

TEST(Lifts, StandWhenTheGroundStopsThem)
{
  Body body;
  body.run(MotionKind::kLift, 1);
  body.lowest_m[0] = 0.14;  // the tread
  body.run(MotionKind::kLower, 1);
  EXPECT_TRUE(body.reading(1).at_lower_lock);
  EXPECT_FALSE(body.reading(1).at_upper_lock);
  EXPECT_FALSE(body.reading(1).moving);
  EXPECT_NEAR(body.reading(1).height_m, 0.14, 1e-9);
  const auto goals = body.lifts.servo_goals_rad();
  EXPECT_NEAR(body.config.m_per_rad * joint_rad(body.config.joints[0], goals[0]), 0.14, 1e-9)
    << "it does not press on";
}

TEST(Lifts, LiftTheMiddleBlockWithBoth)
{
  Body body;
  body.run(MotionKind::kLift, 1);
  body.lowest_m[0] = 0.14;
  body.run(MotionKind::kLower, 1);
  body.lowest_m[0] = -1.0;
  body.run(MotionKind::kLift, 2);
  EXPECT_TRUE(body.reading(2).at_upper_lock);
  EXPECT_NEAR(body.extensions_m[0], -0.04, 0.0016);
  EXPECT_NEAR(body.extensions_m[1], -0.18, 0.0016);
  EXPECT_NEAR(body.reading(1).height_m, 0.14, 0.0016);
  body.highest_m = {0.0, -0.14};  // block 2 stands on the next tread
  body.run(MotionKind::kLower, 2);
  EXPECT_TRUE(body.reading(2).at_lower_lock);
  EXPECT_NEAR(body.reading(2).height_m, 0.14, 1e-9);
  EXPECT_NEAR(body.reading(3).height_m, 0.0, 1e-9);
}

TEST(Lifts, TakeAStopNearTheStrokeForTheLockAndAnyOtherForAJam)
{
  Body locked;
  locked.highest_m[0] = 0.172;
  locked.run(MotionKind::kLift, 1);
  EXPECT_TRUE(locked.reading(1).at_upper_lock);
  EXPECT_FALSE(locked.reading(1).fault);

  Body jammed;
  jammed.highest_m[0] = 0.10;
  jammed.run(MotionKind::kLift, 1);
  EXPECT_FALSE(jammed.reading(1).at_upper_lock);
  EXPECT_TRUE(jammed.reading(1).fault);
  jammed.highest_m[0] = 1.0;
  jammed.lifts.hold();
  jammed.run(MotionKind::kLift, 1);
  EXPECT_TRUE(jammed.reading(1).at_upper_lock) << "the stroke counts from where it stood";
  EXPECT_NEAR(jammed.reading(1).height_m, 0.18, 0.0016);
}

TEST(Lifts, SayThatThereIsNothingBelow)
{
  Body body;
  body.run(MotionKind::kLift, 1);
  body.run(MotionKind::kLower, 1);
  EXPECT_FALSE(body.reading(1).at_lower_lock);
  EXPECT_TRUE(body.reading(1).fault);
  EXPECT_GT(body.extensions_m[0], -0.02) << "it looks no further for the ground";
}

TEST(Lifts, StayWhereTheyAreWhenHeld)
{
  Body body;
  body.lifts.start(MotionKind::kLift, 1);
  body.periods(50);
  body.lifts.hold();
  const double held_m = body.extensions_m[0];
  EXPECT_NEAR(held_m, 0.06, 0.002);
  body.periods(50);
  EXPECT_NEAR(body.extensions_m[0], held_m, 1e-9);
  EXPECT_FALSE(body.reading(1).moving);
  EXPECT_FALSE(body.reading(1).at_lower_lock);
}

// A hand may be under the block: no leg is ended when all is stopped.
TEST(Lifts, StopAtOnceWhileLowering)
{
  Body body;
  body.run(MotionKind::kLift, 1);
  body.lifts.start(MotionKind::kLower, 1);
  body.periods(50);
  const double stopped_m = body.extensions_m[0];
  body.lifts.stop();
  body.periods(50);
  EXPECT_NEAR(body.extensions_m[0], stopped_m, 1e-9);
  EXPECT_FALSE(body.reading(1).moving);
  EXPECT_FALSE(body.reading(1).at_lower_lock);
}

// A servo under a load stands a little below its goal, which is no ground.
TEST(Lifts, DoNotTakeADroopForTheGround)
{
  Body body;
  body.run(MotionKind::kLift, 1);
  body.lifts.start(MotionKind::kLower, 1);
  body.periods(25);
  body.lifts.hold();
  body.droop_m = 0.0045;
  body.periods(50);
  EXPECT_FALSE(body.reading(1).at_lower_lock);
  EXPECT_GT(body.reading(1).height_m, 0.1);
}

// Raised block 1 onto the next tread, lifts block 2 half way: as a restart finds it.
Body in_mid_climb()
{
  Body body;
  body.run(MotionKind::kLift, 1);
  body.lowest_m[0] = 0.14;
  body.run(MotionKind::kLower, 1);
  body.lowest_m[0] = -1.0;
  body.lifts.start(MotionKind::kLift, 2);
  body.periods(75);
  body.lifts.stop();
  return body;
}

TEST(Lifts, GoOnWhereAProgramBeforeThemEnded)
{
  const Body before = in_mid_climb();
  Body body;
  body.lifts = Lifts{body.config, before.lifts.known()};
  body.extensions_m = before.extensions_m;
  body.measure();
  EXPECT_TRUE(body.reading(1).at_lower_lock);
  EXPECT_FALSE(body.reading(2).at_lower_lock);
  EXPECT_TRUE(body.reading(3).at_lower_lock);
  body.run(MotionKind::kLift, 2);
  EXPECT_TRUE(body.reading(2).at_upper_lock);
  EXPECT_NEAR(body.reading(2).height_m, 0.18, 0.0016) << "the stroke counts from where it stood";
}

TEST(Lifts, DoNotBelieveWhatHasMovedSince)
{
  const Body before = in_mid_climb();
  Body body;
  body.lifts = Lifts{body.config, before.lifts.known()};
  body.extensions_m = {before.extensions_m[0] + 0.02, before.extensions_m[1]};
  body.measure();
  EXPECT_FALSE(body.reading(1).at_lower_lock);
  EXPECT_FALSE(body.reading(2).at_lower_lock);
  EXPECT_TRUE(body.reading(3).at_lower_lock) << "the lowest";
}

TEST(Lifts, TakeTheLowestToStandWhenNothingIsKnown)
{
  Body body;
  EXPECT_TRUE(body.reading(1).at_lower_lock && body.reading(3).at_lower_lock) << "level";
  body.lifts = Lifts{body.config};
  body.extensions_m = {0.14, 0.0};
  body.measure();
  EXPECT_FALSE(body.reading(1).at_lower_lock) << "on a tread, or in the air";
  EXPECT_TRUE(body.reading(2).at_lower_lock);
  body.lowest_m[0] = 0.14;
  body.run(MotionKind::kLower, 1);
  EXPECT_TRUE(body.reading(1).at_lower_lock);
  EXPECT_NEAR(body.reading(1).height_m, 0.14, 1e-9);
}

TEST(Lifts, LookAgainAtWhatStandsAfterALoss)
{
  Body body;
  body.run(MotionKind::kLift, 1);
  body.lowest_m[0] = 0.14;
  body.run(MotionKind::kLower, 1);
  body.lifts.restart();
  body.measure();
  EXPECT_TRUE(body.reading(1).at_lower_lock) << "nothing has moved";
  body.extensions_m[0] = 0.0;  // it slid off, or was lifted off, while there was no power
  body.lifts.restart();
  body.measure();
  EXPECT_TRUE(body.reading(1).at_lower_lock && body.reading(2).at_lower_lock) << "level";
  body.extensions_m[0] = 0.08;
  body.lifts.restart();
  body.measure();
  EXPECT_FALSE(body.reading(1).at_lower_lock);
}

TEST(Lifts, EndWhereTheirServoEnds)
{
  Body body;
  body.run(MotionKind::kLift, 3);  // from level: this servo is mounted for the way down
  EXPECT_TRUE(body.reading(3).fault);
  EXPECT_FALSE(body.reading(3).at_upper_lock);
  EXPECT_LT(body.extensions_m[1], 0.054);  // (2.785 - 1.6) x 0.045
}

TEST(Lifts, DoNotLowerWhatStands)
{
  Body body;
  EXPECT_EQ(body.run(MotionKind::kLower, 3), 1);
  EXPECT_EQ(body.extensions_m[1], 0.0);
  EXPECT_TRUE(body.reading(3).at_lower_lock);
}

TEST(Lifts, BeginAgainWhereTheyAreAfterALoss)
{
  Body body;
  body.lifts.start(MotionKind::kLift, 1);
  body.periods(50);
  body.extensions_m[0] = 0.03;  // it sank while nobody looked
  body.lifts.restart();
  body.measure();
  body.period();
  EXPECT_NEAR(body.extensions_m[0], 0.03, 1e-9);
}

}  // namespace
}  // namespace stetro_driver::linux_io
