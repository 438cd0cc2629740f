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
#ifndef TABLE_PARTS_HPP_
#define TABLE_PARTS_HPP_

#include <algorithm>
#include <vector>

#include "stetro_supervisor/transition_table.hpp"

namespace stetro_supervisor
{

// The table in parts, joined and put in order by transition_table.cpp.
std::vector<Row> approach_rows();
std::vector<Row> follow_rows();
std::vector<Row> sweep_rows();
std::vector<Row> step_rows();
std::vector<Row> standing_rows();

// Commands and guards that several parts share.

inline MotionCommand stay(const Situation &) { return hold(); }

inline MotionCommand steer_along(const Situation &) { return steer(0.0); }

inline MotionCommand steer_across(const Situation &) { return steer(kQuarterTurn_rad); }

inline bool is_along(const Situation & s) { return s.steering_at(0.0); }

inline bool is_across(const Situation & s) { return s.steering_at(kQuarterTurn_rad); }

inline bool is_square(const Situation & s)
{
  return s.pose_usable() && std::abs(s.heading_rad()) <= s.params.square_rad;
}

inline MotionCommand turn_square(const Situation & s)
{
  return is_square(s) ? hold()
                      : traverse(0.0, HeadingCorrection::turn_rate_rps(s.params, s.heading_rad()));
}

/// Forward towards something `gap_m` ahead of a sensor: creeping over the last centimetres, from
/// where it may be met, for all that the sensor can tell.
inline MotionCommand roll_towards(const Situation & s, double gap_m, Place sensor)
{
  constexpr double kCreepZone_m = 0.03;
  const double zone_m = std::max(kCreepZone_m, s.geometry.contact_doubt_m(sensor, s.params));
  return roll(gap_m > zone_m ? s.params.roll_speed_mps : s.params.creep_speed_mps);
}

/// A lowered block has met its tread (D3-2, D3-3, D3-7).
/**
 * It bears load, where load is known, and the range below it says so; or, though told to go on, it
 * has been at rest close above the tread for long, which holds with a biased range. Close is
 * farther where load is known to be borne, for then the range alone disagrees, and by no more than
 * a sensor may that was never calibrated. A block known to bear nothing hangs, however long it has
 * been at rest: the others would carry the robot alone.
 */
inline bool touched_down(const Situation & s, int block, Place below)
{
  const auto gap = s.gap_m(below);
  const bool range_alone_disagrees = s.bears(block) && s.in_doubt_and_still(below);
  const bool near = gap && (*gap <= s.params.touch_down_gap_m || s.stalled());
  return gap && (near || range_alone_disagrees) && s.stands(block);
}

/// Every block bears load, where load is known: any one of them may be lifted.
inline bool all_stand(const Situation & s) { return s.stands(1) && s.stands(2) && s.stands(3); }

}  // namespace stetro_supervisor

#endif  // TABLE_PARTS_HPP_
