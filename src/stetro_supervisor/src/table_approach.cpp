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

constexpr double kFacing_rad = 0.8;  // beyond this the front may see a side wall

/// Stairs are ahead: the pair and the middle see something near, and the pose does not say that
/// it is a side wall (the loop of S-P's initialisation, D3-10).
bool stairs_seen(const Situation & s)
{
  const auto middle = s.range_m(Place::kStairFront);
  const auto pair = s.front_pair_m();
  const bool near =
    middle && pair && *middle <= s.params.stair_seen_m && *pair <= s.params.stair_seen_m;
  return near && std::abs(s.heading_rad()) < kFacing_rad;
}

/// Farther away than the sensors reach, but the localizer knows the stairs to be ahead (D3-9).
bool stairs_known(const Situation & s)
{
  return s.pose_sound() && std::abs(s.heading_rad()) <= s.params.alignment_limit_rad;
}

MotionCommand turn_left(const Situation & s) { return traverse(0.0, s.params.yaw_rate_rps); }

MotionCommand approach(const Situation & s)
{
  const auto gap = s.front_gap_m();
  return gap ? roll_towards(s, *gap, Place::kStairFront) : hold();
}

bool riser_at_block1(const Situation & s)
{
  const auto gap = s.front_gap_m();
  return gap && (*gap <= s.params.approach_gap_m || s.stalled() || s.pushes(Place::kStairFront));
}

/// No climb starts on a pose that is not sound, and here it should have become so.
bool not_sound_at_block1(const Situation & s) { return riser_at_block1(s) && !s.pose_sound(); }

bool heading_lost(const Situation & s)
{
  return std::abs(s.heading_rad()) > s.params.alignment_limit_rad;
}

void forget_roll(const Situation &, Memory & memory) { memory.record.rolled_m = 0.0; }

}  // namespace

std::vector<Row> approach_rows()
{
  std::vector<Row> rows;
  rows.push_back(
    {State::kSteerToFind,
     "on the floor, all blocks down",
     steer_across,
     &ClimbParams::steer_limit_s,
     Fault::kSteerTimeout,
     {{"wheels across", is_across, State::kFindStairs}},
     true,
     false});
  rows.push_back(
    {State::kFindStairs,
     "wheels across",
     turn_left,
     &ClimbParams::find_limit_s,
     Fault::kStairNotFound,
     {{"front sees stairs", stairs_seen, State::kAlignToStairs},
      {"the pose faces the stairs", stairs_known, State::kAlignToStairs}},
     true,
     false});
  rows.push_back(
    {State::kAlignToStairs,
     "stairs ahead, wheels across",
     turn_square,
     &ClimbParams::align_limit_s,
     Fault::kMisaligned,
     {{"square", is_square, State::kSteerToApproach}}});
  rows.push_back(
    {State::kSteerToApproach,
     "square to the stairs",
     steer_along,
     &ClimbParams::steer_limit_s,
     Fault::kSteerTimeout,
     {{"wheels along", is_along, State::kApproach}}});
  Row row{
    State::kApproach,
    "square, wheels along",
    approach,
    &ClimbParams::approach_limit_s,
    Fault::kApproachTimeout,
    {{"riser at block 1, the pose not sound", not_sound_at_block1, State::kWaitPose},
     {"riser at block 1", riser_at_block1, State::kLiftBlock1, Fault::kNone, forget_roll},
     {"heading lost", heading_lost, State::kSteerToFind}}};
  row.gap_m = [](const Situation & s) { return s.front_gap_m(); };
  rows.push_back(row);
  return rows;
}

}  // namespace stetro_supervisor
