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

#include <optional>

#include "accuracy/step_watch.hpp"

namespace stetro_bringup
{
namespace
{

using std::chrono_literals::operator""ms;
using stetro_localizer::Integrity;
using stetro_supervisor::State;

/// A climb told tick by tick, 10 ms each.
class Told
{
public:
  /// \param step what the estimate says
  Told & now(int truly, std::optional<int> step, State state = State::kSweepLeft)
  {
    moment_.time += 10ms;
    moment_.truth.step = truly;
    moment_.estimate.step = step;
    moment_.estimate.integrity = integrity;
    moment_.state = state;
    watch.watch(moment_);
    return *this;
  }

  Told & lasting(int ticks, int truly, std::optional<int> step)
  {
    for (int i = 0; i < ticks; ++i) {
      now(truly, step);
    }
    return *this;
  }

  Told & lift(int truly, std::optional<int> step)
  {
    return now(truly, step).now(truly, step, State::kLiftBlock2).now(truly, step);
  }

  StepWatch watch;
  Integrity integrity = Integrity::kOk;

private:
  Moment moment_;
};

TEST(StepWatch, ChecksEachLiftOnce)
{
  Told climb;
  climb.lift(0, 0);
  EXPECT_TRUE(climb.watch.first_tread());
  climb.lift(1, 1);
  EXPECT_FALSE(climb.watch.first_tread());
  climb.now(2, 2, State::kLiftBlock2).now(2, 2, State::kLiftBlock2);  // goes on
  climb.now(2, 2, State::kPaused).now(2, 2, State::kRejoin).now(2, 2, State::kLiftBlock2);
  const StepTally tally = climb.watch.take();
  EXPECT_EQ(tally.checks, 3u) << "a lift that was interrupted is one lift";
  EXPECT_EQ(tally.on_stairs, 2u) << "the one from the floor ends no tread";
  EXPECT_EQ(tally.wrong, 0u);
  EXPECT_TRUE(tally.miscounts.empty());
}

TEST(StepWatch, TellsDetectedFromUndetectedAtTheLift)
{
  Told climb;
  climb.lift(2, 2).lift(3, 2);
  climb.integrity = Integrity::kDegraded;
  climb.lift(4, 2);
  climb.integrity = Integrity::kLost;
  climb.lift(5, std::nullopt);
  climb.integrity = Integrity::kOk;
  climb.lift(6, std::nullopt);
  const StepTally tally = climb.watch.take();
  EXPECT_EQ(tally.checks, 5u);
  EXPECT_EQ(tally.wrong, 4u);
  EXPECT_EQ(tally.undetected, 2u) << "on tread 3, and on tread 6 OK without any step";
}

TEST(StepWatch, ATouchDownThatIsCountedInTimeIsNoMiscount)
{
  Told climb;
  climb.lasting(100, 2, 2).lasting(50, 3, 2).lasting(100, 3, 3);
  EXPECT_TRUE(climb.watch.take().miscounts.empty()) << "0.49 s from the first to the last";
}

TEST(StepWatch, AMiscountIsNoticedByAnyIntegrityButOk)
{
  for (const Integrity integrity : {Integrity::kDegraded, Integrity::kLost}) {
    Told climb;
    climb.lasting(100, 2, 2).lasting(60, 3, 2);
    climb.integrity = integrity;
    climb.lasting(1, 3, 2);
    climb.integrity = Integrity::kOk;
    climb.lasting(60, 3, 3);
    const StepTally tally = climb.watch.take();
    ASSERT_EQ(tally.miscounts.size(), 1u);
    EXPECT_EQ(tally.miscounts[0].end, MiscountEnd::kNoticed);
    EXPECT_EQ(tally.miscounts[0].climbs, 0u) << "before the next climb";
    EXPECT_EQ(tally.undetected, 0u);
  }
}

// Wrong from tread 3 on; lifted there and on tread 4 with integrity OK, noticed on tread 5.
TEST(StepWatch, CountsTheClimbsBegunUntilAMiscountIsNoticed)
{
  Told climb;
  climb.lasting(100, 3, 2).lift(3, 2);
  climb.lasting(100, 4, 3).lift(4, 3);
  climb.integrity = Integrity::kDegraded;
  climb.lasting(100, 5, 4).lift(5, 4);
  const StepTally tally = climb.watch.take();
  ASSERT_EQ(tally.miscounts.size(), 1u);
  EXPECT_EQ(tally.miscounts[0].end, MiscountEnd::kNoticed);
  EXPECT_EQ(tally.miscounts[0].climbs, 2u);
  EXPECT_EQ(tally.wrong, 3u);
  EXPECT_EQ(tally.undetected, 2u);
}

// One ahead: at each touch-down the truth catches up until the estimate has counted it, too.
TEST(StepWatch, ACountThatRunsAheadIsOneMiscount)
{
  Told climb;
  climb.lasting(100, 3, 4).lift(3, 4);
  climb.lasting(20, 4, 4).lasting(100, 4, 5).lift(4, 5);
  const StepTally tally = climb.watch.take();
  ASSERT_EQ(tally.miscounts.size(), 1u);
  EXPECT_EQ(tally.miscounts[0].end, MiscountEnd::kUnnoticed);
  EXPECT_EQ(tally.miscounts[0].climbs, 2u);
}

TEST(StepWatch, AMiscountMayRightItselfUnnoticed)
{
  Told climb;
  climb.lasting(100, 3, 2).lasting(100, 3, 3).lasting(100, 4, 3).lasting(100, 4, 4);
  const StepTally tally = climb.watch.take();
  ASSERT_EQ(tally.miscounts.size(), 2u);
  EXPECT_EQ(tally.miscounts[0].end, MiscountEnd::kCorrected);
  EXPECT_EQ(tally.miscounts[1].end, MiscountEnd::kCorrected);
  EXPECT_EQ(tally.undetected, 0u);
}

TEST(StepWatch, ALiftDoesNotWaitForTheTouchDownToBeCounted)
{
  Told climb;
  climb.lasting(100, 2, 2).lift(3, 2).lasting(100, 3, 3);
  const StepTally tally = climb.watch.take();
  ASSERT_EQ(tally.miscounts.size(), 1u);
  EXPECT_EQ(tally.miscounts[0].climbs, 1u);
  EXPECT_EQ(tally.miscounts[0].end, MiscountEnd::kCorrected);
}

TEST(StepWatch, NoStepAtAllIsNoMiscountBeforeALift)
{
  Told climb;
  climb.integrity = Integrity::kLost;
  climb.lasting(300, 3, std::nullopt);
  EXPECT_TRUE(climb.watch.take().miscounts.empty());
}

}  // namespace
}  // namespace stetro_bringup
