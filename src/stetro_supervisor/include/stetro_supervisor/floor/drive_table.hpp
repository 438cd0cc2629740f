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

#ifndef STETRO_SUPERVISOR__FLOOR__DRIVE_TABLE_HPP_
#define STETRO_SUPERVISOR__FLOOR__DRIVE_TABLE_HPP_

#include <optional>
#include <string>
#include <vector>

#include "stetro_supervisor/floor/drive_situation.hpp"
#include "stetro_supervisor/motion_command.hpp"

namespace stetro_supervisor
{

/// Driving over a floor, as a table. Exits are tried from left to right.
/**
 * The robot rolls along x with its wheels at 0 and turns in place with them at a quarter turn, so
 * it goes in straight legs and stands at their corners.
 *
 *   Idle, Arrived, Aborted --(an errand)--> Plan
 *   Plan         --(a way)--> Aim      --(no way about an obstacle)--> Blocked  --(none)--> Fault
 *   Aim          --(leg ahead)--> SteerAlong   --(leg aside, or to face as asked)--> SteerAcross
 *                --(at the goal, facing as asked)--> HandOver
 *   SteerAcross  wheels across --> Turn        Turn  --(faces the leg)--> SteerAlong
 *                                                    --(faces as asked)--> HandOver
 *   SteerAlong   wheels along  --> Roll
 *   Roll         --(something in the way, or touched)--> Blocked
 *                --(end of the leg)--> Aim     --(off its line or heading)--> Plan
 *   Blocked      --(the way is free)--> Plan   --(not in time)--> Plan, around what is seen
 *   HandOver     --(the localizer tells the segment that is asked for)--> Arrived
 *   WaitPose     --(the pose is usable again)--> Plan
 *   Held, Paused --(resume)--> Plan
 *
 *   every state  --(emergency stop)--> Fault         Fault --(clear)--> Held
 *   at work      --(a block or switch broken, commands refused)--> Fault
 *   at work      --(driver silent or restarted, clock jumped back)--> Held
 *   at work      --(pose not usable)--> WaitPose
 *   with errand  --(pause)--> Paused   --(abort)--> Aborted
 */

using DriveGuard = bool (*)(const DriveSituation &);
using DriveEffect = void (*)(const DriveSituation &, DriveMemory &);

/// One way out of a state.
struct DriveExit
{
  const char * when;
  DriveGuard guard;
  DriveState to;
  Fault fault = Fault::kNone;
  DriveEffect effect = nullptr;
};

/// One state.
struct DriveRow
{
  DriveState state;
  MotionCommand (*command)(const DriveSituation &);
  double (*limit_s)(const DriveSituation &);  ///< longest stay; none where nothing is awaited
  Fault on_limit;
  std::vector<DriveExit> exits;
  bool works = true;       ///< silence of the driver holds, a pause is possible
  bool needs_pose = true;  ///< waits when the pose is not usable
};

/// A row for every state, in the order of DriveState.
const std::vector<DriveRow> & drive_table();

/// The exits of every state, tried before its own.
const std::vector<DriveExit> & common_drive_exits();

inline const DriveRow & row_of(DriveState state)
{
  return drive_table()[static_cast<std::size_t>(state)];
}

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__DRIVE_TABLE_HPP_
