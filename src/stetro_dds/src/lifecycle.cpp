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

#include "stetro_dds/lifecycle.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace stetro_dds
{

std::string_view to_string(LifecycleState state)
{
  constexpr std::array<std::string_view, 4> kNames{
    "unconfigured", "inactive", "active", "finalized"};
  return kNames.at(static_cast<std::size_t>(state));
}

std::string_view to_string(LifecycleTransition transition)
{
  constexpr std::array<std::string_view, 5> kNames{
    "configure", "activate", "deactivate", "cleanup", "shutdown"};
  return kNames.at(static_cast<std::size_t>(transition));
}

const std::array<Lifecycle::Row, 7> & Lifecycle::table()
{
  using S = LifecycleState;
  using T = LifecycleTransition;
  static constexpr std::array<Row, 7> kTable{{
    {S::kUnconfigured, T::kConfigure, S::kInactive},
    {S::kInactive, T::kActivate, S::kActive},
    {S::kActive, T::kDeactivate, S::kInactive},
    {S::kInactive, T::kCleanup, S::kUnconfigured},
    {S::kUnconfigured, T::kShutdown, S::kFinalized},
    {S::kInactive, T::kShutdown, S::kFinalized},
    {S::kActive, T::kShutdown, S::kFinalized},
  }};
  return kTable;
}

void Lifecycle::on(LifecycleTransition transition, Action action)
{
  actions_.at(static_cast<std::size_t>(transition)) = std::move(action);
}

void Lifecycle::observe(Observer observer) { observers_.push_back(std::move(observer)); }

std::optional<Refusal> Lifecycle::request(LifecycleTransition transition)
{
  const auto row = std::find_if(table().begin(), table().end(), [&](const Row & candidate) {
    return candidate.from == state_ && candidate.transition == transition;
  });
  if (row == table().end()) {
    return Refusal{
      "no such transition",
      std::string(to_string(transition)) + " in state " + std::string(to_string(state_))};
  }
  if (const auto & action = actions_.at(static_cast<std::size_t>(transition))) {
    if (auto refusal = action()) {
      return refusal;
    }
  }
  state_ = row->to;
  for (const auto & observer : observers_) {
    observer(row->from, row->to);
  }
  return std::nullopt;
}

}  // namespace stetro_dds
