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

#include <array>
#include <cmath>

#include "stetro_tests/counted_allocations.hpp"
#include "support/hand_set_blocks.hpp"

namespace stetro_localizer
{
namespace
{

TEST(StepFilter, CountsAWholeFlight)
{
  HandSetBlocks blocks;
  blocks.filter.assume_foot();
  EXPECT_FALSE(blocks.filter.step());
  EXPECT_EQ(blocks.filter.reasons(), kNotInitialised);
  blocks.stand({0.0, 0.0, 0.0});
  EXPECT_EQ(blocks.filter.step(), 0);
  blocks.hold({0.18, 0.0, 0.0}, {false, true, true});
  blocks.stand({0.14, 0.0, 0.0});
  EXPECT_EQ(blocks.filter.step(), 0);
  for (int step = 1; step < kSteps; ++step) {
    blocks.climb();
    ASSERT_EQ(blocks.filter.step(), step);
    ASSERT_EQ(blocks.filter.reasons(), 0u);
  }
  blocks.hold({0.14, 0.18, 0.0}, {true, false, true});
  EXPECT_EQ(blocks.stand({0.14, 0.14, 0.0}), StepEvent::kClimbed);
  blocks.hold({0.0, 0.0, 0.04}, {true, true, false});
  blocks.stand({0.0, 0.0, 0.0});
  EXPECT_EQ(blocks.filter.step(), kSteps);
}

TEST(StepFilter, GoesDownAsItGoesUp)
{
  HandSetBlocks blocks;
  blocks.filter.tell(4);
  blocks.stand({0.14, 0.14, 0.0});
  blocks.hold({0.14, 0.18, 0.0}, {true, false, true});
  EXPECT_EQ(blocks.stand({0.14, 0.0, 0.0}), StepEvent::kUndone);
  EXPECT_EQ(blocks.filter.step(), 3);
}

TEST(StepFilter, CountsAtTheSettledTouchDownOnly)
{
  HandSetBlocks blocks = aloft_over(3);
  EXPECT_EQ(blocks.filter.step(), 3) << "aloft";
  EXPECT_TRUE(blocks.filter.block2_aloft());
  EXPECT_EQ(blocks.hold({0.14, 0.14, 0.0}, {true, true, true}, 3), StepEvent::kNone);
  EXPECT_EQ(blocks.filter.step(), 3) << "not settled yet";
  EXPECT_EQ(blocks.stand({0.14, 0.14, 0.0}), StepEvent::kClimbed);
  EXPECT_FALSE(blocks.filter.block2_aloft());
  EXPECT_EQ(blocks.stand({0.14, 0.14, 0.0}), StepEvent::kNone) << "no double count";
}

TEST(StepFilter, KnowsTheOldTread)
{
  HandSetBlocks blocks = aloft_over(3);
  EXPECT_EQ(blocks.stand({0.14, 0.002, 0.0}), StepEvent::kOldTread);
  EXPECT_EQ(blocks.filter.step(), 3);
}

TEST(StepFilter, IsLostAfterAJumpOfTwoTreads)
{
  HandSetBlocks blocks = aloft_over(3);
  EXPECT_EQ(blocks.stand({0.14, 0.28, 0.0}), StepEvent::kLost);
  EXPECT_FALSE(blocks.filter.step());
  EXPECT_TRUE(blocks.filter.lost());
  EXPECT_EQ(blocks.filter.reasons(), kStepUncertain);
  EXPECT_EQ(blocks.stand({0.14, 0.0, 0.0}), StepEvent::kNone) << "until told";
  blocks.filter.tell(5);
  blocks.stand({0.14, 0.0, 0.0});
  EXPECT_EQ(blocks.filter.step(), 5);
}

TEST(StepFilter, IsLostAfterAChangeWithoutALift)
{
  HandSetBlocks dropped = aloft_over(3);
  dropped.stand({0.14, 0.14, 0.0});
  EXPECT_EQ(dropped.stand({0.14, 0.0, 0.0}), StepEvent::kLost) << "fell off the nosing";
  EXPECT_EQ(sweeping(3).stand({0.14, 0.14, 0.0}), StepEvent::kLost) << "nothing was lifted";
  EXPECT_EQ(sweeping(3).stand({0.0, 0.0, 0.0}), StepEvent::kLost) << "nor was block 1";
  EXPECT_EQ(aloft_over(3).stand({0.28, 0.14, 0.0}), StepEvent::kLost) << "1 moved against 3";
}

TEST(StepFilter, IsLostWhenBlock2StandsWhereNoTreadIs)
{
  EXPECT_EQ(aloft_over(3).stand({0.14, 0.07, 0.0}), StepEvent::kLost) << "half a riser";
  HandSetBlocks halted = aloft_over(3);
  halted.evidence.block2_down_m = 0.105;
  halted.stand({0.14, 0.07, 0.0});
  EXPECT_FALSE(halted.filter.step()) << "or it hangs there, and the load is wrong";
  EXPECT_FALSE(halted.filter.lost());
  EXPECT_EQ(halted.filter.most_probable(), 3);
}

TEST(StepFilter, DoubtsAPostureThatNoTreadAllows)
{
  HandSetBlocks blocks = sweeping(3);
  blocks.hold({0.14, 0.0, 0.06}, {true, true, false});
  EXPECT_EQ(blocks.filter.step(), 3);
  blocks.stand({0.14, 0.0, 0.06});
  EXPECT_FALSE(blocks.filter.step()) << "block 3 has no such tread";
  EXPECT_EQ(blocks.hold({0.14, 0.18, 0.06}, {true, false, true}), StepEvent::kLost)
    << "and now it carries the robot there";
}

TEST(StepFilter, WaitsAtATouchDownWithoutLoadUntilAnotherBlockIsLifted)
{
  HandSetBlocks blocks = aloft_over(3);
  blocks.hold({0.14, 0.14, 0.0}, {true, false, true}, 30);
  EXPECT_FALSE(blocks.filter.step());
  EXPECT_EQ(blocks.filter.reasons(), kStepUncertain);
  EXPECT_EQ(blocks.hold({0.10, 0.10, 0.0}, {true, false, false}), StepEvent::kClimbed);
  EXPECT_EQ(blocks.filter.step(), 4);
  EXPECT_GT(blocks.filter.probability(), 0.9999);
}

TEST(StepFilter, ReportsALoadThatBlock2DownContradicts)
{
  HandSetBlocks blocks = aloft_over(3);
  blocks.evidence.block2_down_m = 0.15;
  blocks.hold({0.14, 0.14, 0.0}, {true, true, true}, 40);
  EXPECT_TRUE(blocks.filter.evidence_conflicts());
  EXPECT_EQ(blocks.filter.reasons(), kStepUncertain);
  blocks.evidence.block2_down_m = 0.035;
  blocks.hold({0.14, 0.14, 0.0}, {true, true, true});
  EXPECT_FALSE(blocks.filter.evidence_conflicts());
  EXPECT_EQ(blocks.filter.step(), 4);
}

TEST(StepFilter, DoubtsHeightsThatNeverSettle)
{
  HandSetBlocks blocks = sweeping(3);
  for (int i = 0; i < 400; ++i) {
    blocks.hold({i % 2 == 0 ? 0.14 : 0.146, 0.0, 0.0}, {true, true, true}, 1);
  }
  EXPECT_FALSE(blocks.filter.step()) << "a climb would not be seen in them";
  EXPECT_EQ(blocks.filter.reasons(), kStepUncertain);
  blocks.stand({0.14, 0.0, 0.0});
  EXPECT_EQ(blocks.filter.step(), 3);
}

TEST(StepFilter, CorrectsTheHeightsByThePitch)
{
  HandSetBlocks nodding = aloft_over(3);
  nodding.evidence.pitch_rad = 0.1;
  // every block 15 cm further ahead is 15 sin(0.1) cm lower, and the lifts say the rest
  const double lean_m = 0.15 * std::sin(0.1);
  const double c = std::cos(0.1);
  nodding.stand({(0.14 + 2 * lean_m) / c, (0.14 + lean_m) / c, 0.0});
  EXPECT_EQ(nodding.filter.step(), 4);
}

TEST(StepFilter, DoesNotCareInWhichOrderLateVotesCome)
{
  const auto landed = [] {
    HandSetBlocks blocks = sweeping(3);
    blocks.evidence.travel_m = 1.0;
    blocks.evidence.riser_left = blocks.evidence.riser_right = {true, false};
    blocks.stand({0.14, 0.0, 0.0});
    blocks.hold({0.14, 0.18, 0.0}, {true, false, true});
    blocks.evidence.travel_m = 1.16;
    blocks.hold({0.14, 0.18, 0.0}, {true, false, true});
    blocks.stand({0.14, 0.14, 0.0});
    blocks.stand({0.14, 0.14, 0.0});
    return blocks;
  };
  const auto press = [](HandSetBlocks & blocks) {
    blocks.evidence.travel_m = 1.33;
    blocks.evidence.riser_left.closed = true;
  };
  HandSetBlocks first = landed();
  press(first);
  first.stand({0.14, 0.14, 0.0});
  first.hold({0.0, 0.0, 0.04}, {true, true, false});
  HandSetBlocks second = landed();
  second.hold({0.0, 0.0, 0.04}, {true, true, false});
  press(second);
  second.hold({0.0, 0.0, 0.04}, {true, true, false});
  const double before = landed().filter.probability_of(3);
  EXPECT_LT(first.filter.probability_of(3), 0.01 * before) << "both votes counted";
  EXPECT_DOUBLE_EQ(first.filter.probability_of(3), second.filter.probability_of(3));
  EXPECT_DOUBLE_EQ(first.filter.probability_of(4), second.filter.probability_of(4));
}

TEST(StepFilter, IsRewoundByCopying)
{
  HandSetBlocks blocks = aloft_over(3);
  const StepFilter snapshot = blocks.filter;
  const Nanoseconds then = blocks.now;
  blocks.stand({0.14, 0.14, 0.0});
  const double first = blocks.filter.probability();
  blocks.filter = snapshot;
  blocks.now = then;
  EXPECT_EQ(blocks.filter.step(), 3);
  blocks.stand({0.14, 0.14, 0.0});
  EXPECT_EQ(blocks.filter.step(), 4);
  EXPECT_EQ(blocks.filter.probability(), first);
}

TEST(StepFilter, AllocatesNothing)
{
  HandSetBlocks blocks = sweeping(3);
  const BlockSample aloft = blocks.sample({0.14, 0.18, 0.0}, {true, false, true}, 0);
  const BlockSample landed = blocks.sample({0.14, 0.14, 0.0}, {true, true, true}, 0);
  const std::size_t before = allocations;
  for (int i = 0; i < 20; ++i) {
    BlockSample sample = i < 10 ? aloft : landed;
    sample.stamp += i * kPeriod;
    blocks.filter.add(sample, blocks.evidence);
  }
  EXPECT_EQ(allocations, before);
  EXPECT_EQ(blocks.filter.step(), 4);
}

TEST(StepFilter, GivesTheHeightsOfTheBlocksInTheFlight)
{
  HandSetBlocks blocks = sweeping(3);
  const auto heights = [&] { return *blocks.filter.heights_in_flight(); };
  EXPECT_NEAR(heights()[0], 0.56, 1e-12);
  EXPECT_NEAR(heights()[1], 0.42, 1e-12);
  blocks.hold({0.14, 0.18, 0.0}, {true, false, true});
  EXPECT_NEAR(heights()[1], 0.60, 1e-12);  // 0.42 + 0.18
  EXPECT_NEAR(heights()[2], 0.42, 1e-12);
  blocks.stand({0.14, 0.14, 0.0});
  blocks.hold({0.18, 0.0, 0.04}, {false, true, false});
  EXPECT_NEAR(heights()[0], 0.74, 1e-12);  // tread 4 + 0.18
  EXPECT_NEAR(heights()[2], 0.60, 1e-12);  // tread 4 + 0.04
}

TEST(StepFilter, UsesEachStepsOwnRiser)
{
  const StepModel stairs = model_of({{0.14, 0.32}, {0.10, 0.32}, {0.17, 0.32}});
  HandSetBlocks blocks(stairs);
  blocks.filter.tell(1);
  blocks.stand({0.10, 0.0, 0.0});
  blocks.hold({0.10, 0.18, 0.0}, {true, false, true});
  blocks.stand({0.10, 0.10, 0.0});
  ASSERT_EQ(blocks.filter.step(), 2);
  EXPECT_NEAR((*blocks.filter.heights_in_flight())[1], 0.24, 1e-12);
}

}  // namespace
}  // namespace stetro_localizer
