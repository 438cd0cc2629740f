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
#ifndef STETRO_SUPERVISOR__TRANSITION_TABLE_HPP_
#define STETRO_SUPERVISOR__TRANSITION_TABLE_HPP_

#include <vector>

#include "stetro_supervisor/climb_state.hpp"
#include "stetro_supervisor/motion_command.hpp"
#include "stetro_supervisor/situation.hpp"

namespace stetro_supervisor
{

/// The autonomy of S-P (Pseudocode 2) with the corrections D3 and D1-15, as a table.
/**
 * k is the tread block 2 stands on, N the last one. Exits are tried from left to right; the first
 * whose guard holds is taken. Every state that moves has a time limit that ends in a fault.
 *
 *   Idle, Aborted, Finished --(start)--> Rejoin
 *   Held, Paused            --(resume)--> Rejoin      WaitPose --(pose sound again)--> Rejoin
 *   WaitPose                --(sound again, but lost too often on this step)--> Fault
 *   WaitPose                --(a person tells the pose)--> Held
 *   WaitPose                --(only a wall can put it right, from Square)--> SteerAcross
 *   Rejoin --(posture, step and mission agree)--> the state to go on from, see `rejoin.hpp`
 *
 *   to the first riser (D3-9)
 *   SteerToFind     wheels across          --> FindStairs
 *   FindStairs      turn CCW               --(front sees stairs)--> AlignToStairs
 *   AlignToStairs   turn                   --(square)--> SteerToApproach
 *   SteerToApproach wheels along           --> Approach
 *   Approach        forward                --(riser at block 1)--> LiftBlock1
 *                                          --(the same, pose not sound)--> WaitPose
 *                                          --(heading lost)--> SteerToFind
 *   block 2 stands on k: blocks 3 and 1 follow; from the floor (k = 0) block 1 only
 *   LiftBlock3      --> LiftBlock1 --> SteerToRiser   wheels along  --> RollToRiser
 *   RollToRiser     forward   --(both switches; on N: 0.17 m)--> LowerBlock1
 *                             --(one switch, the other not in time, D3-4)--> RealignBackOff
 *   RealignBackOff  back      --> RealignSteer  wheels across --> RealignTurn --> SteerToRiser
 *   LowerBlock1     lower     --(touched down, k > 0)--> LowerBlock3   --(k = 0)--> BackOff
 *   LowerBlock3     lower     --(stands level with block 2, D3-5)--> BackOff, on N SteerAcross
 *   sweep
 *   BackOff         back 1 cm --> SteerAcross   wheels across --> the next leg; done: Square
 *   SweepLeft       --(left bumper)--> the next leg     (SweepRight likewise)
 *   SweepToMiddle   --(y in the middle, D3-12)--> Square, on N CheckTop
 *   any leg         --(off its line, or a riser switch)--> SteerToTrim
 *   SteerToTrim     wheels along --> TrimAlong; with a riser switch closed BackOff
 *   TrimAlong       roll         --> SteerAcross; a riser switch closes: BackOff
 *   CheckTop        --(k = N and stair_front healthy and free, D3-8)--> Finished
 *   block 2 climbs
 *   Square          turn            --(square, pose sound)--> SteerAlong
 *   SteerAlong      wheels along    --(every block bears)--> LiftBlock2
 *   LiftBlock2      --(upper lock)--> RollBlock3ToRiser --(block 3 at the riser)--> LowerBlock2
 *   LowerBlock2     --(level with block 1)--> ConfirmStep   --(on the old tread)--> LiftBlock2
 *   ConfirmStep     --(localizer counts k + 1)--> LiftBlock3   --(not yet: again)--> LiftBlock2
 *
 *   every state     --(emergency stop)--> Fault         Fault --(clear)--> Held, Idle
 *   at work         --(a block or switch broken, commands refused)--> Fault
 *   at work         --(driver silent or restarted, clock jumped back)--> Held
 *   at work         --(localizer silent, lost or its step in doubt)--> WaitPose
 *   Square          --(integrity not OK: no climb starts)--> WaitPose
 *   at work         --(localizer's step is not k)--> Fault
 *   with a mission  --(pause)--> Paused   --(abort)--> Aborted
 */

using Guard = bool (*)(const Situation &);
using Effect = void (*)(const Situation &, Memory &);

/// One way out of a state.
struct Exit
{
  const char * when;  ///< the guard in words
  Guard guard;
  State to;
  Fault fault = Fault::kNone;  ///< with State::kFault only
  Effect effect = nullptr;     ///< what is remembered on the way
};

/// One state.
struct Row
{
  State state;
  const char * entry;  ///< what holds on entering
  MotionCommand (*command)(const Situation &);
  double ClimbParams::*limit_s;  ///< longest stay; none where nothing moves or is awaited
  Fault on_limit;                ///< the fault exit of the limit
  std::vector<Exit> exits;
  bool works = true;       ///< the mission is under way: silence of the driver holds
  bool needs_pose = true;  ///< waits when the pose is not usable: silent, lost, step in doubt
  bool may_count = false;  ///< the localizer may already count the next step
  Effect enter = nullptr;
  std::optional<double> (*gap_m)(const Situation &) = nullptr;  ///< watched for a stall
  bool needs_ok = false;  ///< waits when its integrity is not OK: no climb starts then
};

/// A row for every state, in the order of State.
const std::vector<Row> & transition_table();

/// The exits of every state, tried before its own.
const std::vector<Exit> & common_exits();

inline const Row & row_of(State state)
{
  return transition_table()[static_cast<std::size_t>(state)];
}

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__TRANSITION_TABLE_HPP_
