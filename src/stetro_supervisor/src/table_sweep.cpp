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

#include "stetro_supervisor/sweep.hpp"
#include "table_parts.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kStuckBackOff = 3.0;  // of the back-off

// ---- back to the sweep line

MotionCommand creep_back(const Situation & s) { return roll(-s.params.creep_speed_mps); }

bool backed_off(const Situation & s)
{
  return !any_switch(s) && s.along_m() <= -s.params.back_off_m;
}

bool switch_stuck(const Situation & s)
{
  return any_switch(s) && s.along_m() <= -kStuckBackOff * s.params.back_off_m;
}

void new_line(const Situation &, Memory & memory) { memory.offset_pending = true; }

void start_line(const Situation &, Memory & memory)
{
  if (memory.offset_pending) {
    memory.offset.zero();
    memory.offset_pending = false;
  }
}

// ---- which leg is next

template <Leg leg>
bool next_is(const Situation & s)
{
  return is_across(s) && s.step() > 0 && s.memory.record.leg == leg;
}

template <State state>
bool next_sweeps(const Situation & s)
{
  const Leg leg = s.memory.record.leg;
  return is_across(s) && s.step() > 0 && state_of(leg, s.params) == state;
}

bool top_is_swept(const Situation & s) { return s.on_top() && next_is<Leg::kDone>(s); }

bool nothing_to_sweep(const Situation & s)
{
  return is_across(s) && (s.step() == 0 || s.memory.record.leg == Leg::kDone);
}

void next_leg(const Situation & s, Memory & memory)
{
  memory.record.leg = static_cast<Leg>(static_cast<int>(s.memory.record.leg) + 1);
  memory.leg_mark = memory.path;
}

// ---- walls (D3-13)

bool bumper_away_from_wall(const Situation & s)
{
  const double limit = s.params.contact_gap_limit_m;
  return (s.left_contact() && wall_gap_m(s, +1) > limit) ||
         (s.right_contact() && wall_gap_m(s, -1) > limit);
}

template <Leg leg>
bool wall_met(const Situation & s)
{
  const bool contact = sweep_direction(s) > 0 ? s.left_contact() : s.right_contact();
  return contact && s.memory.record.leg == leg;
}

bool no_wall(const Situation & s)
{
  const double travelled = std::abs(s.memory.path.across_m - s.memory.leg_mark.across_m);
  return travelled > s.geometry.width_at_m(s.step()) + s.params.sweep_margin_m;
}

bool in_the_middle(const Situation & s)
{
  return s.pose_usable() && std::abs(s.seen.pose->y_m - s.geometry.middle_y_m(s.step())) <=
                              s.params.middle_tolerance_m;
}

bool top_in_the_middle(const Situation & s) { return s.on_top() && in_the_middle(s); }

// ---- off the sweep line

bool off_line(const Situation & s)
{
  return any_switch(s) || std::abs(s.memory.offset.value_m()) > s.params.trim_window_m;
}

bool off_line_too_often(const Situation & s)
{
  return off_line(s) && s.memory.trims >= s.params.max_trims;
}

MotionCommand trim(const Situation & s)
{
  return roll(std::copysign(s.params.creep_speed_mps, s.memory.trim_target_m));
}

bool along_at_riser(const Situation & s) { return is_along(s) && any_switch(s); }

bool trim_met_riser(const Situation & s) { return s.memory.trim_target_m > 0.0 && any_switch(s); }

bool trimmed(const Situation & s)
{
  return std::abs(s.along_m()) >= std::abs(s.memory.trim_target_m);
}

void plan_trim(const Situation &, Memory & memory)
{
  memory.trim_target_m = -memory.offset.value_m();
}

void count_trim(const Situation &, Memory & memory) { ++memory.trims; }

Row sweeping(State state, const char * entry, std::vector<Exit> ends)
{
  std::vector<Exit> exits{
    {"a bumper away from its wall", bumper_away_from_wall, State::kFault, Fault::kBumperStuck}};
  exits.insert(exits.end(), ends.begin(), ends.end());
  exits.push_back({"travelled beyond the width", no_wall, State::kFault, Fault::kNoWallContact});
  exits.push_back(
    {"off its line too often", off_line_too_often, State::kFault, Fault::kTooManyTrims});
  exits.push_back({"off its line", off_line, State::kSteerToTrim, Fault::kNone, count_trim});
  return {state, entry, sweep_command, &ClimbParams::sweep_limit_s, Fault::kSweepTimeout, exits};
}

std::vector<Row> leg_rows()
{
  const auto after = [](State other) {
    return std::vector<Exit>{
      {"wall met, first leg", wall_met<Leg::kFirst>, other, Fault::kNone, next_leg},
      {"wall met, second leg", wall_met<Leg::kSecond>, State::kSweepToMiddle, Fault::kNone,
       next_leg}};
  };
  return {
    sweeping(State::kSweepLeft, "wheels across, on the sweep line", after(State::kSweepRight)),
    sweeping(State::kSweepRight, "wheels across, on the sweep line", after(State::kSweepLeft)),
    sweeping(
      State::kSweepToMiddle, "both walls were met",
      {{"in the middle, on N", top_in_the_middle, State::kCheckTop, Fault::kNone, next_leg},
       {"in the middle", in_the_middle, State::kSquare, Fault::kNone, next_leg}})};
}

std::vector<Row> trim_rows()
{
  std::vector<Row> rows;
  rows.push_back(
    {State::kSteerToTrim,
     "off the sweep line",
     steer_along,
     &ClimbParams::steer_limit_s,
     Fault::kSteerTimeout,
     {{"wheels along, at the riser", along_at_riser, State::kBackOff},
      {"wheels along", is_along, State::kTrimAlong, Fault::kNone, plan_trim}}});
  rows.push_back(
    {State::kTrimAlong,
     "wheels along",
     trim,
     &ClimbParams::roll_limit_s,
     Fault::kRollTimeout,
     {{"met the riser", trim_met_riser, State::kBackOff},
      {"back on the line", trimmed, State::kSteerAcross}}});
  return rows;
}

std::vector<Row> top_rows()
{
  std::vector<Row> rows;
  rows.push_back(
    {State::kCheckTop,
     "on N, swept",
     stay,
     &ClimbParams::top_limit_s,
     Fault::kTopBlocked,
     {{"on N and the front is free",
       [](const Situation & s) {
         return s.on_top() && s.memory.front_free_since &&
                seconds_between(*s.memory.front_free_since, s.now) >= s.params.front_free_s;
       },
       State::kFinished}}});
  return rows;
}

}  // namespace

std::vector<Row> sweep_rows()
{
  std::vector<Row> rows;
  rows.push_back(
    {State::kBackOff,
     "block 2 at the riser, wheels along",
     creep_back,
     &ClimbParams::roll_limit_s,
     Fault::kRollTimeout,
     {{"a gap to the riser", backed_off, State::kSteerAcross},
      {"a switch stays closed", switch_stuck, State::kFault, Fault::kSwitchStuck}},
     true,
     true,
     false,
     new_line});
  rows.push_back(
    {State::kSteerAcross,
     "blocks down, on the sweep line",
     steer_across,
     &ClimbParams::steer_limit_s,
     Fault::kSteerTimeout,
     {{"wheels across, N is swept", top_is_swept, State::kCheckTop},
      {"wheels across, nothing to sweep", nothing_to_sweep, State::kSquare},
      {"wheels across, left is next", next_sweeps<State::kSweepLeft>, State::kSweepLeft},
      {"wheels across, right is next", next_sweeps<State::kSweepRight>, State::kSweepRight},
      {"wheels across, middle is next", next_sweeps<State::kSweepToMiddle>, State::kSweepToMiddle}},
     true,
     true,
     false,
     start_line});
  for (const auto & part : {leg_rows(), trim_rows(), top_rows()}) {
    rows.insert(rows.end(), part.begin(), part.end());
  }
  return rows;
}

}  // namespace stetro_supervisor
