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

#ifndef STETRO_DDS__LIFECYCLE_HPP_
#define STETRO_DDS__LIFECYCLE_HPP_

#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "stetro_dds/refusal.hpp"

namespace stetro_dds
{

/// What a component may physically do.
enum class LifecycleState {
  kUnconfigured,  ///< holds no hardware and no configuration; publishes nothing but diagnostics
  kInactive,      ///< configured, listens and measures; power circuits off, nothing moves
  kActive,        ///< does its work; power circuits on: from here on the robot may move
  kFinalized      ///< let go of everything, the robot stands and holds; only destruction is left
};

enum class LifecycleTransition { kConfigure, kActivate, kDeactivate, kCleanup, kShutdown };

std::string_view to_string(LifecycleState state);  ///< "unconfigured", as ROS 2 labels it
std::string_view to_string(LifecycleTransition transition);

/// The life of a component, as a table.
/**
 *   unconfigured --(configure)---> inactive
 *   inactive     --(activate)----> active
 *   active       --(deactivate)--> inactive
 *   inactive     --(cleanup)-----> unconfigured
 *   unconfigured, inactive, active --(shutdown)--> finalized
 *
 * Everything else is refused and changes nothing.
 */
class Lifecycle
{
public:
  struct Row
  {
    LifecycleState from;
    LifecycleTransition transition;
    LifecycleState to;
  };
  static const std::array<Row, 7> & table();

  /// What has to succeed for a transition to happen; a refusal leaves the state as it was.
  using Action = std::function<std::optional<Refusal>()>;
  /// Told after each change.
  using Observer = std::function<void(LifecycleState from, LifecycleState to)>;

  [[nodiscard]] LifecycleState state() const { return state_; }
  [[nodiscard]] bool active() const { return state_ == LifecycleState::kActive; }

  /// Sets the action of a transition, in whatever state it starts.
  void on(LifecycleTransition transition, Action action);
  void observe(Observer observer);

  /// Takes a transition. \return why not, or nothing if it was taken
  std::optional<Refusal> request(LifecycleTransition transition);

private:
  LifecycleState state_ = LifecycleState::kUnconfigured;
  std::array<Action, 5> actions_{};
  std::vector<Observer> observers_;
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__LIFECYCLE_HPP_
