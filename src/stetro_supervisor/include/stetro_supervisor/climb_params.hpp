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

#ifndef STETRO_SUPERVISOR__CLIMB_PARAMS_HPP_
#define STETRO_SUPERVISOR__CLIMB_PARAMS_HPP_

#include <cstdint>
#include <string>

#include "stetro_config/fault.hpp"
#include "stetro_config/rule.hpp"

namespace stetro_supervisor
{

constexpr double kRadPerDeg = 0.017453292519943295;

/// Speeds, thresholds and limits of the climb. The defaults climb the stairs of the papers.
/// S-P mixes mm, cm and bare numbers (D3-6); here every name carries its SI unit.
struct ClimbParams
{
  // speeds, from the robot file
  double sweep_speed_mps = 0.15;
  double roll_speed_mps = 0.05;
  double creep_speed_mps = 0.02;
  double yaw_rate_rps = 0.10;
  double slow_zone_m = 0.10;
  // heading
  double dead_band_rad = 3.0 * kRadPerDeg;
  double hysteresis_rad = 1.0 * kRadPerDeg;
  double alignment_limit_rad = 8.0 * kRadPerDeg;
  double square_rad = 1.0 * kRadPerDeg;
  // distance from the riser while sweeping
  double drift_window_m = 0.003;
  double drift_heading_rad = 1.5 * kRadPerDeg;
  double trim_window_m = 0.008;
  std::int64_t max_trims = 20;
  // sweep
  std::string sweep_order = "left_first";
  double wall_clearance_m = 0.05;
  double middle_tolerance_m = 0.01;
  double contact_gap_limit_m = 0.15;
  double sweep_margin_m = 0.10;
  // contact of a block
  double approach_gap_m = 0.010;
  double block3_gap_m = 0.005;
  double touch_down_gap_m = 0.010;
  double touch_down_load = 0.02;
  double stall_zone_m = 0.020;
  double stall_s = 1.0;
  double stall_roll_m = 0.03;
  double offset_sigma_m = 0.010;
  double gain_sigma = 0.03;
  double doubt_sigmas = 3.5;
  double height_tolerance_m = 0.020;
  // rolling
  double back_off_m = 0.010;
  double top_roll_m = 0.17;
  double max_roll_m = 0.30;
  double second_switch_s = 1.5;
  double realign_roll_m = 0.015;
  std::int64_t max_realigns = 6;
  std::int64_t max_relifts = 2;
  double steering_tolerance_rad = 0.02;
  // what is ahead
  double stair_seen_m = 1.2;
  double front_free_m = 0.60;
  double front_free_s = 0.5;
  // silence
  double driver_silence_s = 0.5;
  double pose_silence_s = 0.5;
  double pose_settle_s = 0.3;
  std::int64_t max_rejoins = 10;
  std::int64_t max_resweeps = 1;
  double refusal_s = 0.5;
  // time limits of the states
  double steer_limit_s = 5.0;
  double find_limit_s = 90.0;
  double align_limit_s = 30.0;
  double approach_limit_s = 90.0;
  double lift_limit_s = 10.0;
  double roll_limit_s = 25.0;
  double sweep_limit_s = 150.0;
  double confirm_limit_s = 5.0;
  double top_limit_s = 20.0;
  double pose_limit_s = 120.0;
  double held_limit_s = 3600.0;
  double relocalise_limit_s = 2.0;
};

/// The one list of the parameters: loading, bounds, printing and the reference table.
template <class Visitor>
void visit(ClimbParams & p, Visitor && each)
{
  using stetro_config::OneOf;
  using stetro_config::Within;
  const Within limit_s{1.0, 600.0};
  each(
    "slow_zone_m", p.slow_zone_m, Within{0.0, 0.5},
    "distance from a wall or riser over which speed falls to creep [m]");
  each(
    "heading.dead_band_rad", p.dead_band_rad, Within{0.005, 0.35},
    "heading beyond which a misalignment is corrected [rad]");
  each(
    "heading.hysteresis_rad", p.hysteresis_rad, Within{0.0, 0.2},
    "a correction ends this far inside the dead band [rad]");
  each(
    "heading.alignment_limit_rad", p.alignment_limit_rad, Within{0.01, 0.5},
    "heading beyond which a sweep only turns, and an approach starts again [rad]");
  each(
    "heading.square_rad", p.square_rad, Within{0.002, 0.1},
    "heading within which the robot may climb [rad]");
  each(
    "drift.window_m", p.drift_window_m, Within{0.0, 0.05},
    "offset from the sweep line beyond which the heading leans to bring it back [m]");
  each(
    "drift.heading_rad", p.drift_heading_rad, Within{0.0, 0.2},
    "how far the heading leans; 0 does not lean [rad]");
  each(
    "drift.trim_window_m", p.trim_window_m, Within{0.002, 0.05},
    "offset from the sweep line beyond which the sweep stops and rolls back to it [m]");
  each("drift.max_trims", p.max_trims, Within{1, 1000}, "trims allowed on one tread");
  each(
    "sweep.order", p.sweep_order, OneOf{"left_first", "right_first"},
    "wall that is touched first (D1-15)");
  each(
    "sweep.wall_clearance_m", p.wall_clearance_m, Within{0.0, 0.5},
    "gap to either wall that the middle of the tread must leave (D3-12) [m]");
  each(
    "sweep.middle_tolerance_m", p.middle_tolerance_m, Within{0.001, 0.2},
    "how near to the middle of the tread the sweep ends [m]");
  each(
    "sweep.contact_gap_limit_m", p.contact_gap_limit_m, Within{0.02, 1.0},
    "a bumper that closes farther than this from its wall is stuck or blocked [m]");
  each(
    "sweep.margin_m", p.sweep_margin_m, Within{0.01, 1.0},
    "distance beyond the width without a contact that is a fault [m]");
  each(
    "contact.approach_gap_m", p.approach_gap_m, Within{0.0, 0.1},
    "block 1's gap to the riser at which it is lifted [m]");
  each(
    "contact.block3_gap_m", p.block3_gap_m, Within{0.0, 0.05},
    "block 3's gap to the riser that counts as contact [m]");
  each(
    "contact.touch_down_gap_m", p.touch_down_gap_m, Within{0.0, 0.05},
    "gap under a lowered block that counts as contact [m]");
  each(
    "contact.touch_down_load", p.touch_down_load, Within{0.0, 0.5},
    "share of the weight on a block that confirms its contact");
  each(
    "contact.stall_zone_m", p.stall_zone_m, Within{0.0, 0.1},
    "gap within which a stalled approach counts as contact [m]");
  each(
    "contact.stall_s", p.stall_s, Within{0.2, 10.0},
    "time without coming nearer that is a stall [s]");
  each(
    "contact.stall_roll_m", p.stall_roll_m, Within{0.005, 0.2},
    "roll by odometry without coming nearer that is pushing against a riser [m]");
  each(
    "contact.offset_sigma_m", p.offset_sigma_m, Within{0.0, 0.02},
    "offset of a range sensor that was never calibrated, standard deviation [m]");
  each(
    "contact.gain_sigma", p.gain_sigma, Within{0.0, 0.2},
    "its gain error, standard deviation [m/m]");
  each(
    "contact.doubt_sigmas", p.doubt_sigmas, Within{0.0, 6.0},
    "gap that such a sensor may still show in contact [standard deviations]");
  each(
    "contact.height_tolerance_m", p.height_tolerance_m, Within{0.002, 0.1},
    "difference of heights taken as equal [m]");
  each("roll.back_off_m", p.back_off_m, Within{0.0, 0.05}, "gap to the riser while sweeping [m]");
  each(
    "roll.top_m", p.top_roll_m, Within{0.05, 0.5},
    "roll onto the last tread, which has no riser behind it [m]");
  each(
    "roll.max_m", p.max_roll_m, Within{0.1, 2.0},
    "roll without meeting the riser that is a fault [m]");
  each(
    "roll.second_switch_s", p.second_switch_s, Within{0.1, 10.0},
    "time after the first riser switch within which the second must close [s]");
  each(
    "roll.realign_m", p.realign_roll_m, Within{0.002, 0.05},
    "roll back before turning off a skewed contact [m]");
  each("roll.max_realigns", p.max_realigns, Within{1, 100}, "realignments allowed at one riser");
  each(
    "roll.max_relifts", p.max_relifts, Within{0, 100},
    "times block 2 is lifted again after it came down on the old tread");
  each(
    "roll.steering_tolerance_rad", p.steering_tolerance_rad, Within{0.001, 0.2},
    "error of the steering angle taken as reached [rad]");
  each(
    "ahead.stair_seen_m", p.stair_seen_m, Within{0.1, 1.2},
    "front range within which stairs count as seen [m]");
  each(
    "ahead.front_free_m", p.front_free_m, Within{0.1, 2.0},
    "range of a healthy stair_front beyond which nothing stands ahead [m]");
  each(
    "ahead.front_free_s", p.front_free_s, Within{0.0, 10.0},
    "time the front must be free before it is believed [s]");
  each(
    "silence.driver_s", p.driver_silence_s, Within{0.05, 5.0},
    "age of the driver's samples beyond which the robot is held [s]");
  each(
    "silence.pose_s", p.pose_silence_s, Within{0.05, 5.0},
    "age of the pose beyond which the robot waits [s]");
  each(
    "silence.pose_settle_s", p.pose_settle_s, Within{0.0, 10.0},
    "time the pose must be sound before the robot goes on [s]");
  each(
    "silence.max_rejoins", p.max_rejoins, Within{0, 1000},
    "times on one step that the robot goes on by itself after waiting for the pose");
  each(
    "silence.max_resweeps", p.max_resweeps, Within{0, 100},
    "times that a tread is swept again to touch its walls, when y is doubted");
  each(
    "silence.refusal_s", p.refusal_s, Within{0.1, 10.0},
    "time of commands being refused that is a fault [s]");
  each("limit.steer_s", p.steer_limit_s, limit_s, "turning the wheels [s]");
  each("limit.find_s", p.find_limit_s, limit_s, "turning on the spot until stairs are seen [s]");
  each("limit.align_s", p.align_limit_s, limit_s, "turning square to the riser [s]");
  each("limit.approach_s", p.approach_limit_s, limit_s, "rolling to the first riser [s]");
  each("limit.lift_s", p.lift_limit_s, limit_s, "lifting or lowering a block [s]");
  each("limit.roll_s", p.roll_limit_s, limit_s, "rolling to a riser or back [s]");
  each("limit.sweep_s", p.sweep_limit_s, limit_s, "one leg of a sweep between two trims [s]");
  each(
    "limit.confirm_s", p.confirm_limit_s, limit_s,
    "the localizer counting a step that was felt [s]");
  each("limit.top_s", p.top_limit_s, limit_s, "seeing that the landing is free [s]");
  each(
    "limit.relocalise_s", p.relocalise_limit_s, Within{0.1, 60.0},
    "waiting for the localizer to take a pose that was told [s]");
  each("limit.pose_s", p.pose_limit_s, Within{1.0, 3600.0}, "waiting for a sound pose [s]");
  each(
    "limit.held_s", p.held_limit_s, Within{1.0, 86400.0},
    "being held or paused before it is a fault [s]");
}

/// Refuses parameters that contradict each other (D2).
void check(const ClimbParams & params, stetro_config::Faults & faults);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__CLIMB_PARAMS_HPP_
