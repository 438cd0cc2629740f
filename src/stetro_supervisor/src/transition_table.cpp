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
#include "stetro_supervisor/transition_table.hpp"

#include <algorithm>

#include "stetro_supervisor/robot_health.hpp"
#include "table_parts.hpp"

namespace stetro_supervisor
{
namespace
{

bool works(const Situation & s) { return row_of(s.state).works; }

bool needs_pose(const Situation & s) { return row_of(s.state).needs_pose && works(s); }

bool emergency_stop(const Situation & s)
{
  return s.state != State::kFault && is_emergency_stop_closed(s.seen);
}

bool block_broken(const Situation & s) { return works(s) && is_block_broken(s.seen); }

bool switch_broken(const Situation & s) { return works(s) && is_switch_broken(s.seen); }

bool refused_too_long(const Situation & s)
{
  return works(s) && s.memory.refused_since &&
         seconds_between(*s.memory.refused_since, s.now) > s.params.refusal_s;
}

bool abort_asked(const Situation & s)
{
  return s.memory.asked == Asked::kAbort && s.memory.record.active && s.state != State::kFault;
}

bool pause_asked(const Situation & s) { return works(s) && s.memory.asked == Asked::kPause; }

bool driver_lost(const Situation & s)
{
  const bool gone = s.memory.driver_changed || s.memory.clock_went_back;
  return (works(s) && (gone || s.driver_silent())) || (s.state == State::kPaused && gone);
}

bool pose_unsound(const Situation & s)
{
  const bool fit = row_of(s.state).needs_ok ? s.pose_sound() : s.pose_usable();
  return needs_pose(s) && s.state != State::kRejoin && !fit;
}

/// What was felt and what the localizer counts must agree, or nothing moves (D3-14).
bool step_contradicts(const Situation & s)
{
  if (!needs_pose(s) || s.state == State::kRejoin || !s.pose_usable()) {
    return false;
  }
  const int ahead = s.seen.pose->step - s.step();
  return ahead != 0 && !(ahead == 1 && row_of(s.state).may_count);
}

std::vector<Row> ordered_rows()
{
  std::vector<Row> rows;
  for (const auto & part :
       {approach_rows(), follow_rows(), sweep_rows(), step_rows(), standing_rows()}) {
    rows.insert(rows.end(), part.begin(), part.end());
  }
  std::sort(
    rows.begin(), rows.end(), [](const Row & a, const Row & b) { return a.state < b.state; });
  return rows;
}

}  // namespace

const std::vector<Row> & transition_table()
{
  static const std::vector<Row> kTable = ordered_rows();
  return kTable;
}

const std::vector<Exit> & common_exits()
{
  static const std::vector<Exit> kExits{
    {"emergency stop", emergency_stop, State::kFault, Fault::kEmergencyStop},
    {"a block is broken", block_broken, State::kFault, Fault::kBlockFault},
    {"abort asked", abort_asked, State::kAborted},
    {"driver silent or restarted, or the clock went back", driver_lost, State::kHeld},
    {"a switch is broken", switch_broken, State::kFault, Fault::kContactFault},
    {"pause asked", pause_asked, State::kPaused},
    {"commands refused", refused_too_long, State::kFault, Fault::kCommandRefused},
    {"the pose is not sound", pose_unsound, State::kWaitPose},
    {"the localizer's step is not k", step_contradicts, State::kFault, Fault::kStepContradiction},
  };
  return kExits;
}

}  // namespace stetro_supervisor
