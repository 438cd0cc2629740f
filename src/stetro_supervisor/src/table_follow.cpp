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

#include "table_parts.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kLeastRealign_rad = 1.0 * kRadPerDeg;

double rolled_m(const Situation & s) { return s.memory.rolled_before_m + s.along_m(); }

MotionCommand roll_to_riser(const Situation & s)
{
  constexpr double kNearRiser_m = 0.12;  // of the 0.16 m that are rolled
  const bool near = any_switch(s) || rolled_m(s) > kNearRiser_m;
  return roll(near ? s.params.creep_speed_mps : s.params.roll_speed_mps);
}

bool both_on_riser(const Situation & s) { return !s.on_top() && both_switches(s); }

bool rolled_onto_top(const Situation & s)
{
  return s.on_top() && rolled_m(s) >= s.params.top_roll_m;
}

bool riser_above_top(const Situation & s) { return s.on_top() && any_switch(s); }

bool no_riser(const Situation & s) { return rolled_m(s) > s.params.max_roll_m; }

bool skewed(const Situation & s)
{
  return s.memory.skewed_since &&
         seconds_between(*s.memory.skewed_since, s.now) > s.params.second_switch_s;
}

bool skewed_for_good(const Situation & s)
{
  return skewed(s) && s.memory.realigns >= s.params.max_realigns;
}

/// The side that touched alone is ahead: left means turned clockwise, so turn back CCW. By the
/// heading if it agrees; half as far when the other side touched the time before.
void plan_realign(const Situation & s, Memory & memory)
{
  const int side = s.riser_left() ? +1 : -1;
  const double from_heading = std::max(0.0, -side * s.heading_rad());
  double size = std::max(kLeastRealign_rad, from_heading);
  if (memory.realigns > 0 && side != memory.skew_side) {
    size = std::abs(memory.realign_rad) / 2.0;
  }
  memory.skew_side = side;
  memory.realign_rad = side * size;
  ++memory.realigns;
}

bool backed_to_realign(const Situation & s) { return s.along_m() <= -s.params.realign_roll_m; }

MotionCommand turn_to_realign(const Situation & s)
{
  const double error = s.turned_rad() - s.memory.realign_rad;
  return traverse(0.0, HeadingCorrection::turn_rate_rps(s.params, error));
}

bool realigned(const Situation & s)
{
  return s.turned_rad() * s.memory.skew_side >= std::abs(s.memory.realign_rad);
}

bool block1_down(const Situation & s) { return touched_down(s, 1, Place::kBlock1Down); }

bool block1_down_from_floor(const Situation & s) { return s.step() == 0 && block1_down(s); }

bool block3_down(const Situation & s)
{
  const double above = s.height_m(3) - s.height_m(2);
  return s.stands(3) && std::abs(above) <= s.params.height_tolerance_m;
}

bool block3_down_on_top(const Situation & s) { return s.on_top() && block3_down(s); }

void keep_rolled(const Situation & s, Memory & memory)
{
  memory.rolled_before_m = s.memory.record.rolled_m;
}

void new_line(const Situation &, Memory & memory) { memory.offset_pending = true; }

std::vector<Row> lift_rows()
{
  std::vector<Row> rows;
  rows.push_back(
    {State::kLiftBlock3,
     "block 2 counted on k, block 1 beside it",
     [](const Situation &) { return lift(3); },
     &ClimbParams::lift_limit_s,
     Fault::kLiftTimeout,
     {{"block 3 locked up", [](const Situation & s) { return s.lifted(3); }, State::kLiftBlock1}}});
  rows.push_back(
    {State::kLiftBlock1,
     "riser ahead of block 1; block 3 up, or on the floor with k = 0",
     [](const Situation &) { return lift(1); },
     &ClimbParams::lift_limit_s,
     Fault::kLiftTimeout,
     {{"block 1 locked up", [](const Situation & s) { return s.lifted(1); },
       State::kSteerToRiser}}});
  rows.push_back(
    {State::kSteerToRiser,
     "block 1 up",
     steer_along,
     &ClimbParams::steer_limit_s,
     Fault::kSteerTimeout,
     {{"wheels along", is_along, State::kRollToRiser}}});
  return rows;
}

std::vector<Row> realign_rows()
{
  std::vector<Row> rows;
  rows.push_back(
    {State::kRealignBackOff,
     "one riser switch closed, the other not in time",
     [](const Situation & s) { return roll(-s.params.creep_speed_mps); },
     &ClimbParams::roll_limit_s,
     Fault::kRollTimeout,
     {{"clear of the riser", backed_to_realign, State::kRealignSteer}},
     true,
     true,
     false,
     keep_rolled});
  rows.push_back(
    {State::kRealignSteer,
     "clear of the riser",
     steer_across,
     &ClimbParams::steer_limit_s,
     Fault::kSteerTimeout,
     {{"wheels across", is_across, State::kRealignTurn}}});
  rows.push_back(
    {State::kRealignTurn,
     "wheels across",
     turn_to_realign,
     &ClimbParams::align_limit_s,
     Fault::kMisaligned,
     {{"turned", realigned, State::kSteerToRiser}}});
  return rows;
}

std::vector<Row> lower_rows()
{
  std::vector<Row> rows;
  Row lower1{
    State::kLowerBlock1,
    "block 2 at the riser, or far enough on N",
    [](const Situation &) { return lower(1); },
    &ClimbParams::lift_limit_s,
    Fault::kTouchDownUnconfirmed,
    {{"touched down, k = 0", block1_down_from_floor, State::kBackOff},
     {"touched down", block1_down, State::kLowerBlock3}}};
  lower1.gap_m = [](const Situation & s) { return s.gap_m(Place::kBlock1Down); };
  rows.push_back(lower1);
  rows.push_back(
    {State::kLowerBlock3,
     "block 1 stands on k + 1, or on the landing",
     [](const Situation &) { return lower(3); },
     &ClimbParams::lift_limit_s,
     Fault::kTouchDownUnconfirmed,
     {{"stands, on N", block3_down_on_top, State::kSteerAcross, Fault::kNone, new_line},
      {"stands level with block 2", block3_down, State::kBackOff}}});
  return rows;
}

}  // namespace

std::vector<Row> follow_rows()
{
  std::vector<Row> rows = lift_rows();
  rows.push_back(
    {State::kRollToRiser,
     "blocks up, wheels along",
     roll_to_riser,
     &ClimbParams::roll_limit_s,
     Fault::kRollTimeout,
     {{"a riser above the last tread", riser_above_top, State::kFault, Fault::kStepContradiction},
      {"both riser switches", both_on_riser, State::kLowerBlock1},
      {"rolled onto the last tread", rolled_onto_top, State::kLowerBlock1},
      {"skewed too often", skewed_for_good, State::kFault, Fault::kSkewed},
      {"skewed", skewed, State::kRealignBackOff, Fault::kNone, plan_realign},
      {"rolled too far", no_riser, State::kFault, Fault::kRiserMissing}},
     true,
     true,
     false,
     keep_rolled});
  for (const Row & row : realign_rows()) {
    rows.push_back(row);
  }
  for (const Row & row : lower_rows()) {
    rows.push_back(row);
  }
  return rows;
}

}  // namespace stetro_supervisor
