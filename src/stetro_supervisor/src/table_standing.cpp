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
#include "stetro_supervisor/rejoin.hpp"
#include "table_parts.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kLookFirst_s = 2.0;  // before a tread is swept again: a flicker may pass

template <Asked what>
bool asked(const Situation & s)
{
  return s.memory.asked == what;
}

bool cleared_with_mission(const Situation & s)
{
  return asked<Asked::kClearFault>(s) && s.memory.record.active;
}

template <State state>
bool rejoins_at(const Situation & s)
{
  const auto choice = choose_entry(s);
  return choice.entry && *choice.entry == state;
}

template <State state>
Exit rejoin_exit(const char * when)
{
  return {when, rejoins_at<state>, state, Fault::kNone, [](const Situation &, Memory & memory) {
            memory.leg_mark = memory.path;
          }};
}

/// An operator has looked: what was tried before counts no more. A pose that comes back by itself
/// is no such look, or a flickering one would evade every limit on retries.
void forget_tries(const Situation &, Memory & memory)
{
  memory.realigns = 0;
  memory.relifts = 0;
  memory.rejoins = 0;
}

bool pose_is_back(const Situation & s) { return s.pose_settled(); }

bool pose_flickers(const Situation & s)
{
  return pose_is_back(s) && s.memory.rejoins >= s.params.max_rejoins;
}

/// What a wall would put right stays wrong while standing: the tread is swept again.
bool walls_may_tell(const Situation & s)
{
  return s.pose_usable() && !s.pose_sound() && s.step() > 0 && s.seen.pose->step == s.step() &&
         s.memory.record.state == State::kSquare && posture_of(s) == Posture::kStride &&
         s.in_state_s() >= kLookFirst_s && s.memory.resweeps < s.params.max_resweeps;
}

void sweep_again(const Situation &, Memory & memory)
{
  ++memory.resweeps;
  memory.record.leg = Leg::kFirst;
  memory.leg_mark = memory.path;
}

void count_rejoin(const Situation &, Memory & memory) { ++memory.rejoins; }

/// Where the robot stands still and nothing is under way.
Row resting(State state, const char * entry, std::vector<Exit> exits)
{
  return {state,   entry,        [](const Situation &) { return nothing(); },
          nullptr, Fault::kNone, std::move(exits),
          false,   false};
}

/// Where the mission waits for an operator.
Row waiting(State state, const char * entry, std::vector<Exit> exits)
{
  return {state, entry, stay, &ClimbParams::held_limit_s, Fault::kHeldTooLong, std::move(exits),
          false, false};
}

Row rejoin_row()
{
  return {
    State::kRejoin,
    "started or resumed",
    stay,
    &ClimbParams::confirm_limit_s,
    Fault::kEvidenceContradicts,
    {rejoin_exit<State::kSteerToFind>("level on the floor"),
     rejoin_exit<State::kLiftBlock1>("block 1 up, on the floor"),
     rejoin_exit<State::kLowerBlock1>("block 1 over tread 1"),
     rejoin_exit<State::kSteerToTrim>("on a tread, at its riser"),
     rejoin_exit<State::kSteerAcross>("on a tread"), rejoin_exit<State::kLiftBlock2>("block 2 up"),
     rejoin_exit<State::kConfirmStep>("block 2 just down"),
     rejoin_exit<State::kLiftBlock3>("block 2 on k, others to follow"),
     rejoin_exit<State::kLowerBlock3>("block 3 on its way down")}};
}

}  // namespace

std::vector<Row> standing_rows()
{
  const Exit start{"start asked", asked<Asked::kStart>, State::kRejoin, Fault::kNone, forget_tries};
  const Exit resume{
    "resume asked", asked<Asked::kResume>, State::kRejoin, Fault::kNone, forget_tries};
  std::vector<Row> rows;
  rows.push_back(resting(State::kIdle, "no mission", {start}));
  rows.push_back(rejoin_row());
  rows.push_back(
    waiting(State::kHeld, "the driver fell silent or restarted, or this process did", {resume}));
  rows.push_back(
    {State::kWaitPose,
     "the pose is not sound",
     stay,
     &ClimbParams::pose_limit_s,
     Fault::kPoseLost,
     {{"a person told the pose: goes on when asked to resume", asked<Asked::kRelocalise>,
       State::kHeld},
      {"the pose was lost too often on this step", pose_flickers, State::kFault, Fault::kPoseLost},
      {"the pose is sound again", pose_is_back, State::kRejoin, Fault::kNone, count_rejoin},
      {"only a wall can put it right", walls_may_tell, State::kSteerAcross, Fault::kNone,
       sweep_again}},
     true,
     false});
  rows.push_back(waiting(State::kPaused, "pause asked", {resume}));
  Row fault = resting(
    State::kFault, "something is wrong",
    {{"clear asked, a mission is under way", cleared_with_mission, State::kHeld},
     {"clear asked", asked<Asked::kClearFault>, State::kIdle}});
  fault.command = [](const Situation &) { return stop(); };
  rows.push_back(fault);
  rows.push_back(resting(State::kAborted, "abort asked", {start}));
  rows.push_back(resting(State::kFinished, "on N with the front free", {start}));
  return rows;
}

}  // namespace stetro_supervisor
