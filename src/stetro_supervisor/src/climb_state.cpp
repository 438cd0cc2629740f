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

#include "stetro_supervisor/climb_state.hpp"

#include <array>
#include <cstddef>

namespace stetro_supervisor
{
namespace
{

struct StateName
{
  const char * name;
  Phase phase;
};

// in the order of State
constexpr std::array<StateName, kStateCount> kStates{{
  {"idle", Phase::kNone},
  {"rejoin", Phase::kStanding},
  {"steer_to_find", Phase::kFloor},
  {"find_stairs", Phase::kFloor},
  {"align_to_stairs", Phase::kFloor},
  {"steer_to_approach", Phase::kFloor},
  {"approach", Phase::kFloor},
  {"lift_block3", Phase::kFollowing},
  {"lift_block1", Phase::kFollowing},
  {"steer_to_riser", Phase::kFollowing},
  {"roll_to_riser", Phase::kFollowing},
  {"realign_back_off", Phase::kFollowing},
  {"realign_steer", Phase::kFollowing},
  {"realign_turn", Phase::kFollowing},
  {"lower_block1", Phase::kFollowing},
  {"lower_block3", Phase::kFollowing},
  {"back_off", Phase::kSweeping},
  {"steer_across", Phase::kSweeping},
  {"sweep_left", Phase::kSweeping},
  {"sweep_right", Phase::kSweeping},
  {"sweep_to_middle", Phase::kSweeping},
  {"steer_to_trim", Phase::kSweeping},
  {"trim_along", Phase::kSweeping},
  {"check_top", Phase::kSweeping},
  {"square", Phase::kSweeping},
  {"steer_along", Phase::kSweeping},
  {"lift_block2", Phase::kStepping},
  {"roll_block3_to_riser", Phase::kStepping},
  {"lower_block2", Phase::kStepping},
  {"confirm_step", Phase::kStepping},
  {"held", Phase::kStanding},
  {"wait_pose", Phase::kStanding},
  {"paused", Phase::kStanding},
  {"fault", Phase::kStanding},
  {"aborted", Phase::kNone},
  {"finished", Phase::kNone},
}};

// in the order of Fault
constexpr std::array<const char *, kFaultCount> kFaults{{
  "none",
  "emergency_stop",
  "block_fault",
  "contact_fault",
  "command_refused",
  "steer_timeout",
  "stair_not_found",
  "misaligned",
  "approach_timeout",
  "lift_timeout",
  "roll_timeout",
  "riser_missing",
  "skewed",
  "touch_down_unconfirmed",
  "switch_stuck",
  "bumper_stuck",
  "no_wall_contact",
  "sweep_timeout",
  "too_many_trims",
  "top_blocked",
  "step_contradiction",
  "evidence_contradicts",
  "pose_lost",
  "held_too_long",
  "no_way",
  "way_blocked",
  "leg_timeout",
  "not_handed_over",
}};

constexpr std::array<const char *, 4> kLegs{{"first", "second", "middle", "done"}};

}  // namespace

const char * to_string(State state) { return kStates[static_cast<std::size_t>(state)].name; }

const char * to_string(Fault fault) { return kFaults[static_cast<std::size_t>(fault)]; }

const char * to_string(Leg leg) { return kLegs[static_cast<std::size_t>(leg)]; }

Phase phase_of(State state) { return kStates[static_cast<std::size_t>(state)].phase; }

std::optional<State> state_named(const std::string & name)
{
  for (std::size_t i = 0; i < kStates.size(); ++i) {
    if (name == kStates[i].name) {
      return static_cast<State>(i);
    }
  }
  return std::nullopt;
}

std::optional<Leg> leg_named(const std::string & name)
{
  for (std::size_t i = 0; i < kLegs.size(); ++i) {
    if (name == kLegs[i]) {
      return static_cast<Leg>(i);
    }
  }
  return std::nullopt;
}

}  // namespace stetro_supervisor
