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
#include <stdexcept>
#include <vector>

#include "stetro_localizer/step_counter.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kRiser = 0.14;
constexpr double kContact = 0.035;
constexpr int kSteps = 16;
constexpr Nanoseconds kPeriod{33'333'333};

/// A robot whose blocks are set by hand: absolute heights, load and motion, sent at 30 Hz.
class Blocks
{
public:
  Blocks() : counter(std::vector<double>(kSteps, kRiser), kContact, StepCounterParams{}) {}

  /// Five samples of one posture; the last event that was not none.
  StepEvent hold(
    std::array<double, 3> heights_m, std::array<bool, 3> bearing, std::optional<double> down_m = {},
    int samples = 5)
  {
    StepEvent last = StepEvent::kNone;
    for (int i = 0; i < samples; ++i) {
      now_ += kPeriod;
      const StepEvent event = counter.add(sample(heights_m, bearing), down_m);
      last = event == StepEvent::kNone ? last : event;
    }
    return last;
  }

  StepEvent stand(std::array<double, 3> heights_m) { return hold(heights_m, {true, true, true}); }

  /// The climb of house from a sweep of tread i; heights relative to the lowest block.
  void climb()
  {
    hold({0.14, 0.18, 0.0}, {true, false, true});
    hold({0.14, 0.14, 0.0}, {true, true, true});
    hold({0.10, 0.10, 0.0}, {true, true, false});  // block 3 lifted above the tread
    hold({0.18, 0.0, 0.04}, {false, true, false});
    hold({0.14, 0.0, 0.04}, {true, true, false});
    hold({0.14, 0.0, 0.0}, {true, true, true});
  }

  StepCounter counter;

private:
  BlockSample sample(std::array<double, 3> heights_m, std::array<bool, 3> bearing) const
  {
    BlockSample out;
    out.stamp = now_;
    const double share = 1.0 / (bearing[0] + bearing[1] + bearing[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      out.blocks[i] = {heights_m[i], bearing[i] ? share : 0.0, true, false, false};
    }
    return out;
  }

  Nanoseconds now_ = std::chrono::seconds(1000);
};

Blocks sweeping(int step)
{
  Blocks blocks;
  blocks.counter.tell(step);
  blocks.stand({0.14, 0.0, 0.0});
  return blocks;
}

TEST(StepCounter, CountsAWholeFlight)
{
  Blocks blocks;
  blocks.counter.assume_foot();
  EXPECT_FALSE(blocks.counter.step());
  blocks.stand({0.0, 0.0, 0.0});
  EXPECT_EQ(blocks.counter.step(), 0);
  blocks.hold({0.18, 0.0, 0.0}, {false, true, true});
  blocks.stand({0.14, 0.0, 0.0});  // block 1 on tread 1: still on the floor (D1-12)
  EXPECT_EQ(blocks.counter.step(), 0);
  for (int step = 1; step < kSteps; ++step) {
    blocks.climb();
    ASSERT_EQ(blocks.counter.step(), step);
  }
  blocks.hold({0.14, 0.18, 0.0}, {true, false, true});
  blocks.stand({0.14, 0.14, 0.0});
  blocks.hold({0.0, 0.0, 0.04}, {true, true, false});
  blocks.stand({0.0, 0.0, 0.0});  // tread 16 is flush with the landing
  EXPECT_EQ(blocks.counter.step(), kSteps);
}

TEST(StepCounter, CountsAtTheConfirmedTouchDownOnly)
{
  Blocks blocks = sweeping(3);
  EXPECT_EQ(blocks.hold({0.14, 0.18, 0.0}, {true, false, true}), StepEvent::kSettled);
  EXPECT_EQ(blocks.counter.step(), 3) << "aloft";
  EXPECT_EQ(blocks.hold({0.14, 0.14, 0.0}, {true, true, true}, {}, 2), StepEvent::kNone);
  EXPECT_EQ(blocks.counter.step(), 3) << "two samples are not settled";
  EXPECT_EQ(blocks.stand({0.14, 0.14, 0.0}), StepEvent::kClimbed);
  EXPECT_EQ(blocks.counter.step(), 4);
  EXPECT_EQ(blocks.stand({0.14, 0.14, 0.0}), StepEvent::kNone) << "no double count";
}

TEST(StepCounter, KnowsTheOldTread)
{
  Blocks blocks = sweeping(3);
  blocks.hold({0.14, 0.18, 0.0}, {true, false, true});
  EXPECT_EQ(blocks.stand({0.14, 0.002, 0.0}), StepEvent::kOldTread);
  EXPECT_EQ(blocks.counter.step(), 3);
}

TEST(StepCounter, DoesNotCountASecondTouchDownOnTheSameTread)
{
  Blocks blocks = sweeping(3);
  blocks.hold({0.14, 0.18, 0.0}, {true, false, true});
  blocks.stand({0.14, 0.14, 0.0});
  blocks.hold({0.14, 0.16, 0.0}, {true, false, true});  // lifted once more, and set down again
  EXPECT_EQ(blocks.stand({0.14, 0.14, 0.0}), StepEvent::kOldTread);
  EXPECT_EQ(blocks.counter.step(), 4);
}

TEST(StepCounter, UndoesAStepThatSlippedBack)
{
  Blocks lifted = sweeping(3);
  lifted.hold({0.14, 0.18, 0.0}, {true, false, true});
  lifted.stand({0.14, 0.14, 0.0});
  lifted.hold({0.14, 0.16, 0.0}, {true, false, true});
  EXPECT_EQ(lifted.stand({0.14, 0.0, 0.0}), StepEvent::kUndone);
  EXPECT_EQ(lifted.counter.step(), 3);

  Blocks dropped = sweeping(3);
  dropped.hold({0.14, 0.18, 0.0}, {true, false, true});
  dropped.stand({0.14, 0.14, 0.0});
  EXPECT_EQ(dropped.stand({0.14, 0.0, 0.0}), StepEvent::kUndone) << "fell off the nosing";
  EXPECT_EQ(dropped.counter.step(), 3);
}

TEST(StepCounter, IsLostWhenTheHeightsMakeNoSense)
{
  Blocks half = sweeping(3);
  half.hold({0.14, 0.18, 0.0}, {true, false, true});
  EXPECT_EQ(half.stand({0.14, 0.07, 0.0}), StepEvent::kLost) << "half a riser";
  EXPECT_FALSE(half.counter.step());
  EXPECT_EQ(half.stand({0.14, 0.0, 0.0}), StepEvent::kNone) << "until told";
  half.counter.tell(3);
  half.stand({0.14, 0.0, 0.0});
  EXPECT_EQ(half.counter.step(), 3);

  Blocks reference = sweeping(3);
  reference.hold({0.14, 0.18, 0.0}, {true, false, true});
  EXPECT_EQ(reference.stand({0.28, 0.14, 0.0}), StepEvent::kLost) << "block 1 moved against 3";

  Blocks jumped = sweeping(3);
  EXPECT_EQ(jumped.stand({0.14, 0.14, 0.0}), StepEvent::kLost) << "nothing was lifted";
}

TEST(StepCounter, ConcludesNothingWithoutLoadEvidence)
{
  Blocks blocks = sweeping(3);
  BlockSample sample;
  for (int i = 1; i <= 10; ++i) {
    sample.stamp = std::chrono::seconds(1001) + i * kPeriod;
    sample.blocks[0] = {0.14, 0.5, true, false, false};
    sample.blocks[1] = {0.18, 0.0, false, false, false};  // the load of block 2 is not known
    sample.blocks[2] = {0.0, 0.5, true, false, false};
    EXPECT_EQ(blocks.counter.add(sample, {}), StepEvent::kNone);
  }
  EXPECT_EQ(blocks.counter.step(), 3);
  EXPECT_FALSE(blocks.counter.block2_aloft());
}

TEST(StepCounter, WaitsWhenTheDownwardRangeDoubtsTheTouchDown)
{
  Blocks blocks = sweeping(3);
  blocks.hold({0.14, 0.18, 0.0}, {true, false, true}, 0.18);
  EXPECT_EQ(blocks.hold({0.14, 0.14, 0.0}, {true, true, true}, 0.10, 20), StepEvent::kNone)
    << "6.5 cm above contact";
  EXPECT_FALSE(blocks.counter.evidence_conflicts());
  EXPECT_EQ(blocks.hold({0.14, 0.14, 0.0}, {true, true, true}, 0.10, 20), StepEvent::kClimbed)
    << "after a second load and heights decide";
  EXPECT_TRUE(blocks.counter.evidence_conflicts()) << "and it is reported";
  blocks.hold({0.14, 0.14, 0.0}, {true, true, true}, kContact);
  EXPECT_FALSE(blocks.counter.evidence_conflicts());
}

TEST(StepCounter, GivesTheHeightsOfTheBlocksInTheFlight)
{
  Blocks blocks = sweeping(3);
  const auto heights = [&] { return *blocks.counter.heights_in_flight(); };
  EXPECT_NEAR(heights()[0], 0.56, 1e-12);  // tread 4
  EXPECT_NEAR(heights()[1], 0.42, 1e-12);  // tread 3
  blocks.hold({0.14, 0.18, 0.0}, {true, false, true});
  EXPECT_NEAR(heights()[1], 0.60, 1e-12);  // 0.42 + 0.18
  EXPECT_NEAR(heights()[2], 0.42, 1e-12);
  blocks.stand({0.14, 0.14, 0.0});
  blocks.hold({0.18, 0.0, 0.04}, {false, true, false});
  EXPECT_NEAR(heights()[0], 0.74, 1e-12);  // tread 4 + 0.18
  EXPECT_NEAR(heights()[2], 0.60, 1e-12);  // tread 4 + 0.04
}

// The body is longer than a tread: level, it is at the foot or on the landing.
TEST(StepCounter, RefusesWhatItIsToldIfTheBlocksCannotStandSo)
{
  Blocks level;
  level.counter.tell(5);
  EXPECT_EQ(level.stand({0.0, 0.0, 0.0}), StepEvent::kLost);
  Blocks foot;
  foot.counter.assume_foot();
  EXPECT_EQ(foot.stand({0.14, 0.0, 0.0}), StepEvent::kLost) << "may be any tread";
  Blocks told;
  told.counter.tell(0);
  told.stand({0.14, 0.0, 0.0});
  EXPECT_EQ(told.counter.step(), 0) << "block 1 is on tread 1";
}

struct Restart
{
  const char * what;
  std::array<double, 3> heights_m;
  std::array<bool, 3> bearing;
  std::optional<int> step;
};

TEST(StepCounter, ResolvesARestartWithTheBlockAloft)
{
  const std::vector<Restart> cases{
    {"still aloft", {0.14, 0.18, 0.0}, {true, false, true}, 3},
    {"still aloft, half way down", {0.14, 0.16, 0.0}, {true, false, true}, 3},
    {"touched down one higher", {0.14, 0.14, 0.0}, {true, true, true}, 4},
    {"touched down on the old tread", {0.14, 0.0, 0.0}, {true, true, true}, 3},
    {"block 1 moved too", {0.28, 0.14, 0.0}, {true, true, true}, {}},
    {"half a riser", {0.14, 0.07, 0.0}, {true, true, true}, {}},
  };
  for (const Restart & restart : cases) {
    Blocks before = sweeping(3);
    before.hold({0.14, 0.18, 0.0}, {true, false, true});
    Blocks after;
    after.counter.restore(before.counter.state_to_store().value());
    EXPECT_FALSE(after.counter.step()) << "not before the blocks were seen";
    after.hold(restart.heights_m, restart.bearing);
    EXPECT_EQ(after.counter.step(), restart.step) << restart.what;
  }
}

TEST(StepCounter, ResolvesARestartOfAStandingRobot)
{
  const std::vector<Restart> cases{
    {"as it was", {0.14, 0.0, 0.0}, {true, true, true}, 3},
    {"block 2 lifted meanwhile", {0.14, 0.05, 0.0}, {true, false, true}, 3},
    {"block 3 lifted meanwhile", {0.14, 0.0, 0.04}, {true, true, false}, 3},
    {"all stand, otherwise", {0.14, 0.14, 0.0}, {true, true, true}, {}},
    {"level", {0.0, 0.0, 0.0}, {true, true, true}, {}},
  };
  for (const Restart & restart : cases) {
    Blocks after;
    after.counter.restore(sweeping(3).counter.state_to_store().value());
    after.hold(restart.heights_m, restart.bearing);
    EXPECT_EQ(after.counter.step(), restart.step) << restart.what;
  }
  Blocks on;
  on.counter.restore(sweeping(3).counter.state_to_store().value());
  on.hold({0.14, 0.05, 0.0}, {true, false, true});
  on.hold({0.14, 0.18, 0.0}, {true, false, true});
  on.stand({0.14, 0.14, 0.0});
  EXPECT_EQ(on.counter.step(), 4) << "the lift-off is what was stored";
}

TEST(StepCounter, UsesEachStepsOwnRiser)
{
  StepCounter counter({0.14, 0.10, 0.17}, kContact, StepCounterParams{});
  counter.tell(1);
  const auto hold = [&counter](double h1, double h2, double h3, bool aloft) {
    static Nanoseconds now = std::chrono::seconds(1000);
    BlockSample sample;
    for (int i = 0; i < 4; ++i) {
      now += kPeriod;
      sample.stamp = now;
      sample.blocks[0] = {h1, 0.4, true, false, false};
      sample.blocks[1] = {h2, aloft ? 0.0 : 0.2, true, false, false};
      sample.blocks[2] = {h3, 0.4, true, false, false};
      counter.add(sample, {});
    }
  };
  hold(0.10, 0.0, 0.0, false);
  hold(0.10, 0.18, 0.0, true);
  hold(0.10, 0.10, 0.0, false);
  ASSERT_EQ(counter.step(), 2);
  EXPECT_NEAR((*counter.heights_in_flight())[1], 0.24, 1e-12);
}

TEST(StepCounter, RefusesImpossibleStairs)
{
  EXPECT_THROW(StepCounter({}, kContact, StepCounterParams{}), std::invalid_argument);
  EXPECT_THROW(StepCounter({0.14, 0.0}, kContact, StepCounterParams{}), std::invalid_argument);
}

TEST(StepCounter, RefusesAStepThatTheFlightDoesNotHave)
{
  Blocks blocks;
  for (const int step : {-1, 17, 200}) {
    EXPECT_FALSE(blocks.counter.has(step));
    EXPECT_THROW(blocks.counter.tell(step), std::invalid_argument) << step;
    StepState stored;
    stored.step = step;
    EXPECT_THROW(blocks.counter.restore(stored), std::invalid_argument) << step;
  }
  blocks.counter.tell(16);
  EXPECT_TRUE(blocks.counter.awaiting_blocks()) << "and takes one that it has";
}

}  // namespace
}  // namespace stetro_localizer
