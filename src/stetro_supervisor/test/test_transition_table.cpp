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

#include <set>
#include <string>

#include "stetro_supervisor/transition_table.hpp"
#include "support/toy_robot.hpp"

namespace stetro_supervisor
{
namespace
{

const std::set<State> kResting{State::kIdle, State::kFault, State::kAborted, State::kFinished};

/// By the row alone, and by its limit: what all states share would reach everything from anywhere.
std::set<State> next_of(const Row & row)
{
  std::set<State> next;
  for (const Exit & exit : row.exits) {
    next.insert(exit.to);
  }
  if (row.limit_s != nullptr) {
    next.insert(State::kFault);
  }
  return next;
}

std::set<State> reachable_from(State start)
{
  std::set<State> seen{start};
  std::set<State> open{start};
  while (!open.empty()) {
    const State state = *open.begin();
    open.erase(open.begin());
    for (const State next : next_of(row_of(state))) {
      if (seen.insert(next).second) {
        open.insert(next);
      }
    }
  }
  return seen;
}

}  // namespace

TEST(TransitionTable, HasOneRowForEveryStateInOrder)
{
  ASSERT_EQ(transition_table().size(), static_cast<std::size_t>(kStateCount));
  for (int i = 0; i < kStateCount; ++i) {
    EXPECT_EQ(row_of(static_cast<State>(i)).state, static_cast<State>(i));
  }
}

TEST(TransitionTable, EveryStateHasATimeLimitAndAFaultExit)  // D3-10
{
  const ClimbParams params;
  for (const Row & row : transition_table()) {
    if (kResting.count(row.state) == 1) {
      EXPECT_FALSE(row.works) << to_string(row.state) << " rests, nothing may move";
      continue;
    }
    ASSERT_NE(row.limit_s, nullptr) << to_string(row.state);
    EXPECT_GT(params.*row.limit_s, 0.0) << to_string(row.state);
    EXPECT_NE(row.on_limit, Fault::kNone) << to_string(row.state);
  }
}

class CommonExits : public testing::TestWithParam<int>
{
protected:
  CommonExits()
  {
    memory.record.active = true;
    memory.record.step = 1;
    seen = robot.look();
    seen.pose->step = 1;
  }

  /// Where the exits that all states share lead from this one; itself if none is open.
  State leads_to() const
  {
    const Situation s{params, geometry, seen, memory, state, robot.now, robot.now};
    for (const Exit & exit : common_exits()) {
      if (exit.guard(s)) {
        return exit.to;
      }
    }
    return state;
  }

  const State state = static_cast<State>(GetParam());
  const bool works = row_of(state).works;
  const bool waits = row_of(state).needs_pose && works && state != State::kRejoin;
  const ClimbParams params;
  const ClimbGeometry geometry = stairs(3);
  const ToyRobot robot{geometry};
  Memory memory;
  Observation seen;
};

TEST_P(CommonExits, AreShutWhenNothingIsWrong) { EXPECT_EQ(leads_to(), state); }

TEST_P(CommonExits, EmergencyStopIsAFaultEverywhere)
{
  seen.contacts->emergency_stop.state = ContactState::kClosed;
  EXPECT_EQ(leads_to(), State::kFault);
}

TEST_P(CommonExits, ASilentOrRestartedDriverHoldsWhatWorks)
{
  const State held = works ? State::kHeld : state;
  seen.odometry.reset();
  EXPECT_EQ(leads_to(), held);
  seen.odometry = robot.look().odometry;
  memory.driver_changed = true;
  EXPECT_EQ(leads_to(), state == State::kPaused ? State::kHeld : held);
}

TEST_P(CommonExits, ABrokenBlockOrSwitchIsAFaultOfWhatWorks)
{
  seen.blocks->block[2].fault = true;
  EXPECT_EQ(leads_to(), works ? State::kFault : state);
  seen.blocks->block[2].fault = false;
  seen.contacts->riser_left.state = ContactState::kUnknown;
  EXPECT_EQ(leads_to(), works ? State::kFault : state);
}

TEST_P(CommonExits, ALostPoseMakesWhatNeedsItWait)
{
  seen.pose->integrity = Integrity::kLost;
  EXPECT_EQ(leads_to(), waits ? State::kWaitPose : state);
}

TEST_P(CommonExits, AnotherStepThanTheFeltOneIsAFault)
{
  seen.pose->step = 3;
  EXPECT_EQ(leads_to(), waits ? State::kFault : state);
}

TEST_P(CommonExits, APauseOrAnAbortIsTaken)
{
  memory.asked = Asked::kPause;
  EXPECT_EQ(leads_to(), works ? State::kPaused : state);
  memory.asked = Asked::kAbort;
  EXPECT_EQ(leads_to(), state == State::kFault ? state : State::kAborted);
}

INSTANTIATE_TEST_SUITE_P(
  State, CommonExits, testing::Range(0, kStateCount), [](const testing::TestParamInfo<int> & i) {
    return std::string(to_string(static_cast<State>(i.param)));
  });

TEST(TransitionTable, HasNoDeadEndAndNoStateThatCannotBeReached)
{
  // These two are entered by what all states share; CommonExits looks at that.
  const std::set<State> asides{State::kPaused, State::kAborted};
  const auto from_idle = reachable_from(State::kIdle);
  for (const Row & row : transition_table()) {
    EXPECT_NE(from_idle.count(row.state), asides.count(row.state)) << to_string(row.state);
  }
  for (const Row & row : transition_table()) {
    EXPECT_FALSE(row.exits.empty()) << to_string(row.state);
    EXPECT_EQ(reachable_from(row.state).count(State::kFinished), 1u) << to_string(row.state);
  }
}

TEST(TransitionTable, EveryExitIsToldInWordsAndNamesAFaultOnlyWhenItIsOne)
{
  for (const Row & row : transition_table()) {
    EXPECT_FALSE(std::string(row.entry).empty());
    for (const Exit & exit : row.exits) {
      EXPECT_NE(exit.guard, nullptr) << to_string(row.state);
      EXPECT_FALSE(std::string(exit.when).empty()) << to_string(row.state);
      EXPECT_EQ(exit.to == State::kFault, exit.fault != Fault::kNone) << exit.when;
    }
  }
}

TEST(TransitionTable, NamesOfStatesReadBack)
{
  for (int i = 0; i < kStateCount; ++i) {
    const auto state = static_cast<State>(i);
    EXPECT_EQ(state_named(to_string(state)), state);
  }
  EXPECT_FALSE(state_named("sideways").has_value());
}

}  // namespace stetro_supervisor
