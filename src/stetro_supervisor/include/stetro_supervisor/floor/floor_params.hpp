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

#ifndef STETRO_SUPERVISOR__FLOOR__FLOOR_PARAMS_HPP_
#define STETRO_SUPERVISOR__FLOOR__FLOOR_PARAMS_HPP_

#include <cstdint>

#include "stetro_config/fault.hpp"
#include "stetro_config/rule.hpp"
#include "stetro_site/floor_speeds.hpp"

namespace stetro_supervisor
{

/// How the robot drives over floors, and how it doubts its pose there.
struct FloorParams
{
  // speeds
  double speed_m_s = stetro_site::FloorSpeeds{}.roll_m_s;
  double roll_off_m_s = 0.10;
  double creep_m_s = 0.05;
  double turn_rad_s = stetro_site::FloorSpeeds{}.turn_rad_s;
  // places
  double margin_m = 0.07;
  double resolution_m = 0.05;
  double foot_m = 0.5;
  double roll_off_m = 0.45;
  // how well a leg is kept
  double arrive_m = 0.02;
  double aim_rad = 0.01;
  double heading_rad = 0.10;
  double cross_track_m = 0.06;
  // what stands in the way
  double stop_m = 0.35;
  double free_s = 1.0;
  double wait_s = 8.0;
  std::int64_t max_replans = 10;
  // limits of the states
  double turn_limit_s = 30.0;
  double leg_limit_s = 120.0;
  double blocked_limit_s = 60.0;
  double hand_over_limit_s = 10.0;
  // the second opinion
  double check_every_s = 1.0;
  double check_turn_rad_s = 0.10;
  double check_radius_m = 0.6;
  double check_yaw_sigma_rad = 0.05;
  double map_sigma_m = 0.005;
  double pose_sigma_m = 0.01;
  double pose_sigma_rad = 0.005;
  double agree_sigmas = 3.5;
  std::int64_t doubts = 2;
  double beam_error_m = 0.12;
  double dependable_m = 12.0;
  double search_heading_rad = 0.05;
  double search_pause_s = 0.3;
};

/// The one list of the parameters: loading, bounds, printing and the reference table.
template <class Visitor>
void visit(FloorParams & p, Visitor && each)
{
  using stetro_config::Within;
  const Within limit_s{1.0, 600.0};
  each("floor.speed_m_s", p.speed_m_s, Within{0.02, 1.0}, "rolling along a leg [m/s]");
  each("floor.roll_off_m_s", p.roll_off_m_s, Within{0.02, 0.5}, "rolling off the last tread [m/s]");
  each("floor.creep_m_s", p.creep_m_s, Within{0.01, 0.2}, "over the last decimetre of a leg [m/s]");
  each("floor.turn_rad_s", p.turn_rad_s, Within{0.05, 2.0}, "turning in place [rad/s]");
  each(
    "floor.margin_m", p.margin_m, Within{0.0, 1.0},
    "room left between the circle about the body and every wall and stair [m]");
  each(
    "floor.resolution_m", p.resolution_m, Within{0.01, 0.2},
    "cells that polygon floors are drawn in; a grid map keeps its own [m]");
  each(
    "floor.foot_m", p.foot_m, Within{0.3, 0.9},
    "distance before the first riser at which a flight is taken up [m]");
  each(
    "floor.roll_off_m", p.roll_off_m, Within{0.35, 2.0},
    "distance beyond a flight's end at which the robot is on the floor [m]");
  each("floor.arrive_m", p.arrive_m, Within{0.005, 0.2}, "rest of a leg that counts as driven [m]");
  each("floor.aim_rad", p.aim_rad, Within{0.002, 0.2}, "heading error at which a turn ends [rad]");
  each(
    "floor.heading_rad", p.heading_rad, Within{0.01, 0.5},
    "heading error on a leg beyond which the robot stops and turns anew [rad]");
  each(
    "floor.cross_track_m", p.cross_track_m, Within{0.01, 0.5},
    "distance from a leg beyond which the robot stops and plans anew [m]");
  each(
    "floor.stop_m", p.stop_m, Within{0.1, 2.0},
    "distance before its face at which something in the way stops the robot [m]");
  each(
    "floor.free_s", p.free_s, Within{0.0, 10.0},
    "time the way must be free before the robot goes on [s]");
  each(
    "floor.wait_s", p.wait_s, Within{0.0, 600.0},
    "time that what stands in the way is given to walk on, before a way around it is looked for "
    "[s]");
  each(
    "floor.max_replans", p.max_replans, Within{0, 1000},
    "ways around obstacles that are tried on one floor");
  each("floor.limit.turn_s", p.turn_limit_s, limit_s, "turning to a heading [s]");
  each("floor.limit.leg_s", p.leg_limit_s, limit_s, "rolling along a leg [s]");
  each("floor.limit.blocked_s", p.blocked_limit_s, limit_s, "standing before an obstacle [s]");
  each(
    "floor.limit.hand_over_s", p.hand_over_limit_s, limit_s,
    "the localizer following from floor to flight or back [s]");
  each(
    "floor.check_every_s", p.check_every_s, Within{0.1, 60.0},
    "between two checks of the pose while moving [s]");
  each(
    "floor.check_turn_rad_s", p.check_turn_rad_s, Within{0.0, 3.0},
    "yaw rate above which a scan is smeared and not used [rad/s]");
  each(
    "floor.check_radius_m", p.check_radius_m, Within{0.1, 5.0},
    "how far from the told pose a check looks [m]");
  each(
    "floor.check_yaw_sigma_rad", p.check_yaw_sigma_rad, Within{0.002, 0.3},
    "heading of the told pose, least standard deviation that a check allows for [rad]");
  each(
    "floor.map_sigma_m", p.map_sigma_m, Within{0.0, 0.2},
    "error of the walls in the site file, across them; cells of a map add their own [m]");
  each(
    "floor.pose_sigma_m", p.pose_sigma_m, Within{0.001, 0.2},
    "added to the position that a profile tells: stamps, tilt, mounting [m]");
  each(
    "floor.pose_sigma_rad", p.pose_sigma_rad, Within{0.0005, 0.1},
    "added to the heading that a profile tells [rad]");
  each(
    "floor.agree_sigmas", p.agree_sigmas, Within{1.0, 10.0},
    "difference within which two answers agree [standard deviations]");
  each(
    "floor.doubts", p.doubts, Within{1, 100},
    "checks in a row against the pose before the robot stops and looks for itself");
  each(
    "floor.beam_error_m", p.beam_error_m, Within{0.01, 1.0},
    "error of a range in the four-beam search, map and heading included [m]");
  each(
    "floor.dependable_m", p.dependable_m, Within{0.0, 100.0},
    "what is nearer returns to most rays of a beam, so that no return says that nothing is; "
    "at most the lidar's max_range_m; 0: no return says nothing [m]");
  each(
    "floor.search_heading_rad", p.search_heading_rad, Within{0.01, 0.5},
    "between the headings that a search tries [rad]");
  each(
    "floor.search_pause_s", p.search_pause_s, Within{0.0, 60.0},
    "between the end of a search and the scan of the next [s]");
}

/// Refuses parameters that contradict each other.
void check(const FloorParams & params, stetro_config::Faults & faults);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__FLOOR_PARAMS_HPP_
