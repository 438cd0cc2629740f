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
#include <cmath>
#include <optional>

#include "table_parts.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kSettle_s = 0.5;     // a block that was just told to move may still be at rest
constexpr double kRecount = 0.5;      // share of a state's limit before it gives up waiting
constexpr double kSupport_m = 0.045;  // of block 2 on either side of its middle, to stand
constexpr double kFreeFactor = 2.0;   // a riser is believed missing later than a landing free

/// Where a riser must be ahead, a healthy stair_front sees nothing: the step count is wrong (D3-8).
bool riser_missing(const Situation & s)
{
  return s.riser_ahead() && s.memory.front_free_since &&
         seconds_between(*s.memory.front_free_since, s.now) > kFreeFactor * s.params.front_free_s;
}

bool ready_to_climb(const Situation & s) { return is_square(s) && s.pose_settled(); }

MotionCommand roll_block3(const Situation & s)
{
  const auto gap = s.gap_m(Place::kBlock3Front);
  return gap ? roll_towards(s, *gap, Place::kBlock3Front) : hold();
}

/// The range has been seen to shrink, or block 3 may have stood at the riser from the beginning. A
/// sensor that is stuck at what it read behind block 2 is no witness of a push.
bool block3_came_nearer(const Situation & s)
{
  const Memory & memory = s.memory;
  const bool from_afar = memory.farthest_m - memory.nearest_m >= s.params.stall_roll_m;
  return from_afar || memory.relifts > 0 || memory.rejoins > 0;
}

bool block3_at_riser(const Situation & s)
{
  const auto gap = s.gap_m(Place::kBlock3Front);
  const bool pushes = s.pushes(Place::kBlock3Front) && block3_came_nearer(s);
  return gap && (*gap <= s.params.block3_gap_m || s.stalled() || pushes);
}

/// How far the pose has block 2's middle beyond the edge of the tread below it, as the site has it.
std::optional<double> beyond_edge_m(const Situation & s)
{
  if (!s.pose_sound() || s.seen.pose->step != s.step()) {
    return std::nullopt;
  }
  const int step = s.step();
  const double beyond_m =
    step > 0 ? s.seen.pose->tread_x_m - s.geometry.tread(step) : s.seen.pose->x_m;
  return std::isfinite(beyond_m) ? std::optional<double>{beyond_m} : std::nullopt;
}

/// Block 3's sensor has it at the riser, and by the pose block 2 would tip off the edge.
/** Wheels that slip in the middle of the roll do that. From further back block 2 comes to stand on
 *  the old tread, which is noticed. */
bool over_the_edge(const Situation & s)
{
  const auto beyond = beyond_edge_m(s);
  if (!beyond || !block3_at_riser(s)) {
    return false;
  }
  const double at_most_m = *beyond + s.seen.pose->protection_along_m;
  return -kSupport_m <= at_most_m && at_most_m < kSupport_m;
}

bool rolled_too_far(const Situation & s) { return s.along_m() > s.params.max_roll_m; }

bool level_with_block1(const Situation & s)
{
  const bool level = std::abs(s.height_m(2) - s.height_m(1)) <= s.params.height_tolerance_m;
  return level && touched_down(s, 2, Place::kBlock2Down);
}

bool on_old_tread(const Situation & s)
{
  const bool low = s.height_m(2) - s.height_m(3) <= s.params.height_tolerance_m;
  return s.in_state_s() > kSettle_s && low && all_stand(s);
}

bool may_lift_again(const Situation & s) { return s.memory.relifts < s.params.max_relifts; }

bool on_old_tread_again(const Situation & s) { return on_old_tread(s) && !may_lift_again(s); }

bool counted(const Situation & s) { return s.pose_usable() && s.seen.pose->step == s.step() + 1; }

bool not_counted(const Situation & s)
{
  return may_lift_again(s) && s.stands(1) && s.stands(3) &&
         s.in_state_s() > kRecount * s.params.confirm_limit_s;
}

bool ready_to_lift(const Situation & s) { return is_along(s) && all_stand(s); }

bool block_hangs(const Situation & s)
{
  return is_along(s) && !all_stand(s) && s.in_state_s() > kRecount * s.params.steer_limit_s;
}

void count_relift(const Situation &, Memory & memory) { ++memory.relifts; }

/// The step index changes here and nowhere else (D3-14).
void take_step(const Situation &, Memory & memory)
{
  ++memory.record.step;
  memory.record.leg = Leg::kFirst;
  memory.record.rolled_m = 0.0;
  memory.leg_mark = memory.path;
  memory.trims = 0;
  memory.realigns = 0;
  memory.relifts = 0;
  memory.rejoins = 0;
  memory.resweeps = 0;
}

Row lower_block2()
{
  Row row{
    State::kLowerBlock2,
    "block 3 at the riser, block 2 over k + 1",
    [](const Situation &) { return lower(2); },
    &ClimbParams::lift_limit_s,
    Fault::kTouchDownUnconfirmed,
    {{"touched down level with block 1", level_with_block1, State::kConfirmStep},
     {"on the old tread again", on_old_tread_again, State::kFault, Fault::kTouchDownUnconfirmed},
     {"on the old tread", on_old_tread, State::kLiftBlock2, Fault::kNone, count_relift}}};
  row.may_count = true;
  row.gap_m = [](const Situation & s) { return s.gap_m(Place::kBlock2Down); };
  return row;
}

Row confirm_step()
{
  Row row{
    State::kConfirmStep,
    "block 2 felt k + 1",
    stay,
    &ClimbParams::confirm_limit_s,
    Fault::kStepContradiction,
    {{"the localizer counts k + 1", counted, State::kLiftBlock3, Fault::kNone, take_step},
     {"not counted: show it again", not_counted, State::kLiftBlock2, Fault::kNone, count_relift}}};
  row.may_count = true;
  return row;
}

}  // namespace

std::vector<Row> step_rows()
{
  std::vector<Row> rows;
  Row square{
    State::kSquare,
    "swept, in the middle, wheels across",
    turn_square,
    &ClimbParams::align_limit_s,
    Fault::kMisaligned,
    {{"no riser where one must be", riser_missing, State::kFault, Fault::kRiserMissing},
     {"square and the pose is sound", ready_to_climb, State::kSteerAlong}}};
  square.needs_ok = true;
  rows.push_back(square);
  rows.push_back(
    {State::kSteerAlong,
     "square",
     steer_along,
     &ClimbParams::steer_limit_s,
     Fault::kSteerTimeout,
     {{"wheels along, every block bears", ready_to_lift, State::kLiftBlock2},
      {"a block bears nothing", block_hangs, State::kFault, Fault::kTouchDownUnconfirmed}}});
  rows.push_back(
    {State::kLiftBlock2,
     "square, wheels along",
     [](const Situation &) { return lift(2); },
     &ClimbParams::lift_limit_s,
     Fault::kLiftTimeout,
     {{"block 2 locked up", [](const Situation & s) { return s.lifted(2); },
       State::kRollBlock3ToRiser}}});
  Row roll_row{
    State::kRollBlock3ToRiser,
    "block 2 up",
    roll_block3,
    &ClimbParams::roll_limit_s,
    Fault::kRollTimeout,
    {{"block 2 would tip off the edge", over_the_edge, State::kFault, Fault::kStepContradiction},
     {"block 3 at the riser", block3_at_riser, State::kLowerBlock2},
     {"rolled too far", rolled_too_far, State::kFault, Fault::kRiserMissing}}};
  roll_row.gap_m = [](const Situation & s) { return s.gap_m(Place::kBlock3Front); };
  rows.push_back(roll_row);
  rows.push_back(lower_block2());
  rows.push_back(confirm_step());
  return rows;
}

}  // namespace stetro_supervisor
