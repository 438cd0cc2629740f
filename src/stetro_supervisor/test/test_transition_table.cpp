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
#include <set>
#include <string>

#include "stetro_supervisor/transition_table.hpp"

namespace stetro_supervisor
{
namespace
{

const std::set<State> kResting{State::kIdle, State::kFault, State::kAborted, State::kFinished};

std::set<State> next_of(const Row & row)
{
  std::set<State> next;
  for (const auto * exits : {&common_exits(), &row.exits}) {
    for (const Exit & exit : *exits) {
      next.insert(exit.to);
    }
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

TEST(TransitionTable, EveryStateLeadsToFaultAndEveryWorkingOneToHeld)
{
  const auto leads = [](State to) {
    return std::any_of(
      common_exits().begin(), common_exits().end(), [to](const Exit & e) { return e.to == to; });
  };
  EXPECT_TRUE(leads(State::kFault));
  EXPECT_TRUE(leads(State::kHeld));
  EXPECT_TRUE(leads(State::kWaitPose));
  EXPECT_TRUE(leads(State::kPaused));
  EXPECT_TRUE(leads(State::kAborted));
}

TEST(TransitionTable, HasNoDeadEndAndNoStateThatCannotBeReached)
{
  const auto from_idle = reachable_from(State::kIdle);
  EXPECT_EQ(from_idle.size(), static_cast<std::size_t>(kStateCount));
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
