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
#include <string>
#include <vector>

#include "stetro_dds/lifecycle.hpp"

namespace stetro_dds
{
namespace
{

using S = LifecycleState;
using T = LifecycleTransition;

constexpr std::array<S, 4> kStates{S::kUnconfigured, S::kInactive, S::kActive, S::kFinalized};
constexpr std::array<T, 5> kTransitions{
  T::kConfigure, T::kActivate, T::kDeactivate, T::kCleanup, T::kShutdown};

/// A lifecycle brought to a state by the shortest way.
Lifecycle in_state(S state)
{
  Lifecycle lifecycle;
  if (state == S::kInactive || state == S::kActive) {
    lifecycle.request(T::kConfigure);
  }
  if (state == S::kActive) {
    lifecycle.request(T::kActivate);
  }
  if (state == S::kFinalized) {
    lifecycle.request(T::kShutdown);
  }
  return lifecycle;
}

TEST(Lifecycle, TakesEveryRowOfItsTableAndRefusesEverythingElse)
{
  for (const S from : kStates) {
    for (const T transition : kTransitions) {
      std::optional<S> expected;
      for (const auto & row : Lifecycle::table()) {
        if (row.from == from && row.transition == transition) {
          expected = row.to;
        }
      }
      auto lifecycle = in_state(from);
      ASSERT_EQ(lifecycle.state(), from);
      const auto refusal = lifecycle.request(transition);
      EXPECT_EQ(refusal.has_value(), !expected.has_value())
        << to_string(from) << ", " << to_string(transition);
      EXPECT_EQ(lifecycle.state(), expected.value_or(from));
    }
  }
}

TEST(Lifecycle, CanAlwaysBeShutDownAndThenIsOver)
{
  for (const S from : kStates) {
    auto lifecycle = in_state(from);
    lifecycle.request(T::kShutdown);
    EXPECT_EQ(lifecycle.state(), S::kFinalized);
    for (const T transition : kTransitions) {
      EXPECT_TRUE(lifecycle.request(transition));
    }
  }
}

TEST(Lifecycle, StaysWhereItWasWhenTheActionRefuses)
{
  auto lifecycle = in_state(S::kInactive);
  lifecycle.on(T::kActivate, [] { return Refusal{"no power", "0.2 V, accepted is 11 V"}; });
  const auto refusal = lifecycle.request(T::kActivate);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->reason, "no power");
  EXPECT_EQ(lifecycle.state(), S::kInactive);
}

TEST(Lifecycle, TellsItsObserversAfterEachChange)
{
  Lifecycle lifecycle;
  std::vector<std::string> seen;
  lifecycle.observe([&](S from, S to) {
    seen.push_back(std::string(to_string(from)) + ">" + std::string(to_string(to)));
  });
  lifecycle.request(T::kActivate);  // refused, so nobody is told
  lifecycle.request(T::kConfigure);
  lifecycle.request(T::kActivate);
  EXPECT_EQ(seen, (std::vector<std::string>{"unconfigured>inactive", "inactive>active"}));
}

}  // namespace
}  // namespace stetro_dds
