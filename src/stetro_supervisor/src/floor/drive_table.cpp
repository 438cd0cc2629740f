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

#include "stetro_supervisor/floor/drive_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "stetro_supervisor/robot_health.hpp"

namespace stetro_supervisor
{
namespace
{

using S = DriveSituation;

constexpr double kObstaclesWithin_m = 3.0;
constexpr double kOffWalls_m = 0.10;  // what is nearer to a drawn wall is that wall
constexpr double kTurnGain = 1.5;     // [1/s]
constexpr double kSlowestTurn_rps = 0.05;

MotionCommand stay(const S &) { return hold(); }
MotionCommand rest(const S &) { return nothing(); }
MotionCommand steer_across(const S &) { return steer(kQuarterTurn_rad); }
MotionCommand steer_along(const S &) { return steer(0.0); }

MotionCommand turn(const S & s)
{
  const double error = s.to_turn_rad();
  const double rate =
    std::clamp(kTurnGain * std::abs(error), kSlowestTurn_rps, s.params.turn_rad_s);
  return traverse(0.0, std::copysign(rate, error));
}

/// Slower over the last of the leg: what the wheels still roll after a stop must not matter.
MotionCommand roll_on(const S & s)
{
  const double fastest = s.memory.errand.straight ? s.params.roll_off_m_s : s.params.speed_m_s;
  return roll(std::min(fastest, s.params.creep_m_s + std::max(0.0, s.rest_m())));
}

// guards

bool is_across(const S & s) { return s.steering_at(kQuarterTurn_rad); }
bool is_along(const S & s) { return s.steering_at(0.0); }
bool has_no_way(const S & s) { return !s.memory.no_way.empty(); }
bool has_no_way_around(const S & s) { return has_no_way(s) && !s.memory.obstacles_m.empty(); }
bool has_way(const S & s) { return !s.memory.corners_m.empty(); }

bool has_arrived(const S & s)
{
  return s.at_goal() && std::abs(s.to_goal_heading_rad()) <= 2.0 * s.params.aim_rad;
}

/// Straight off the stairs no turn is made that is not needed: their edge is near.
bool faces_leg(const S & s)
{
  const double least = s.memory.errand.straight ? s.params.heading_rad : 2.0 * s.params.aim_rad;
  return s.has_leg() && std::abs(s.to_leg_rad()) <= least;
}

bool faces_aside(const S & s) { return !faces_leg(s) && !has_arrived(s); }
bool has_turned_to_leg(const S & s)
{
  return s.has_leg() && std::abs(s.to_leg_rad()) <= s.params.aim_rad;
}
bool has_turned_to_goal(const S & s)
{
  return s.at_goal() && std::abs(s.to_goal_heading_rad()) <= s.params.aim_rad;
}

bool is_in_the_way(const S & s) { return s.bumps() || s.is_obstructed(); }
bool is_at_end(const S & s) { return s.rest_m() <= s.params.arrive_m; }

bool has_strayed(const S & s)
{
  return std::abs(s.cross_track_m()) > s.params.cross_track_m ||
         std::abs(s.off_leg_rad()) > s.params.heading_rad;
}

bool is_free_again(const S & s)
{
  return s.memory.free_since && seconds_between(*s.memory.free_since, s.now) >= s.params.free_s;
}

bool has_waited(const S & s)
{
  return s.in_state_s() >= s.params.wait_s && s.memory.replans < s.params.max_replans;
}

/// For as long as the pose must be sound after any doubt: it has just changed its frame.
bool is_handed_over_for_good(const S & s)
{
  return s.is_handed_over() && s.in_state_s() >= s.limits.pose_settle_s;
}

bool is_sound_again(const S & s)
{
  return s.memory.sound_since &&
         seconds_between(*s.memory.sound_since, s.now) >= s.limits.pose_settle_s;
}

template <Asked what>
bool asked(const S & s)
{
  return s.memory.asked == what;
}

bool works(const S & s) { return row_of(s.state).works; }

bool has_errand(const S & s)
{
  return works(s) || s.state == DriveState::kHeld || s.state == DriveState::kPaused;
}

bool emergency_stop(const S & s)
{
  return s.state != DriveState::kFault && is_emergency_stop_closed(s.seen);
}

bool block_broken(const S & s) { return works(s) && is_block_broken(s.seen); }
bool switch_broken(const S & s) { return works(s) && is_switch_broken(s.seen); }
bool abort_asked(const S & s) { return has_errand(s) && asked<Asked::kAbort>(s); }
bool pause_asked(const S & s) { return works(s) && asked<Asked::kPause>(s); }

bool refused_too_long(const S & s)
{
  return works(s) && s.memory.refused_since &&
         seconds_between(*s.memory.refused_since, s.now) > s.limits.refusal_s;
}

bool driver_lost(const S & s)
{
  const bool gone = s.memory.driver_changed || s.memory.clock_went_back;
  const bool silent = is_driver_silent(s.seen, s.now, s.limits.driver_silence_s);
  return (works(s) && (gone || silent)) || (s.state == DriveState::kPaused && gone);
}

bool pose_unusable(const S & s) { return works(s) && row_of(s.state).needs_pose && !s.pose.place; }

// effects

void begin_leg_here(const S & s, DriveMemory & memory)
{
  memory.corners_m[memory.leg - 1] = s.pose.place->position_m;
}

void next_leg(const S &, DriveMemory & memory) { ++memory.leg; }

/// What is seen and not drawn shall be driven round.
void remember_obstacles(const S & s, DriveMemory & memory)
{
  ++memory.replans;
  if (!s.seen.scan || !s.pose.place) {
    return;
  }
  const auto & drawn = s.memory.errand.floor->free_space();
  for (const Eigen::Vector2d & point :
       points_seen(*s.seen.scan, *s.pose.place, s.robot.lidar, kObstaclesWithin_m)) {
    if (drawn.clearance_m(point) > kOffWalls_m) {
      memory.obstacles_m.push_back(point);
    }
  }
}

/// They may have walked on.
void forget_obstacles(const S &, DriveMemory & memory) { memory.obstacles_m.clear(); }

double steer_limit(const S & s) { return s.limits.steer_limit_s; }
double turn_limit(const S & s) { return s.params.turn_limit_s; }
double leg_limit(const S & s) { return s.params.leg_limit_s; }
double blocked_limit(const S & s) { return s.params.blocked_limit_s; }
double hand_over_limit(const S & s) { return s.params.hand_over_limit_s; }
double pose_limit(const S & s) { return s.limits.pose_limit_s; }
double held_limit(const S & s) { return s.limits.held_limit_s; }

DriveRow resting(DriveState state)
{
  return {state, rest, nullptr, Fault::kNone, {}, false, false};
}

std::vector<DriveRow> working_rows()
{
  using D = DriveState;
  return {
    {D::kPlan,
     stay,
     steer_limit,
     Fault::kNoWay,
     {{"no way around what is in the way", has_no_way_around, D::kBlocked, Fault::kNone,
       forget_obstacles},
      {"no way", has_no_way, D::kFault, Fault::kNoWay},
      {"a way", has_way, D::kAim}}},
    {D::kAim,
     stay,
     steer_limit,
     Fault::kMisaligned,
     {{"at the goal", has_arrived, D::kHandOver},
      {"faces aside", faces_aside, D::kSteerAcross},
      {"faces the leg", faces_leg, D::kSteerAlong}}},
    {D::kSteerAcross,
     steer_across,
     steer_limit,
     Fault::kSteerTimeout,
     {{"wheels across", is_across, D::kTurn}}},
    {D::kTurn,
     turn,
     turn_limit,
     Fault::kMisaligned,
     {{"faces the leg", has_turned_to_leg, D::kSteerAlong},
      {"faces as asked", has_turned_to_goal, D::kHandOver}}},
    {D::kSteerAlong,
     steer_along,
     steer_limit,
     Fault::kSteerTimeout,
     {{"wheels along", is_along, D::kRoll, Fault::kNone, begin_leg_here}}},
    {D::kRoll,
     roll_on,
     leg_limit,
     Fault::kLegTimeout,
     {{"end of the leg", is_at_end, D::kAim, Fault::kNone, next_leg},
      {"something in the way", is_in_the_way, D::kBlocked},
      {"off its line", has_strayed, D::kPlan}}},
    {D::kBlocked,
     stay,
     blocked_limit,
     Fault::kWayBlocked,
     {{"the way is free", is_free_again, D::kPlan},
      {"it stays: around it", has_waited, D::kPlan, Fault::kNone, remember_obstacles}}},
    {D::kHandOver,
     stay,
     hand_over_limit,
     Fault::kNotHandedOver,
     {{"the localizer is there too", is_handed_over_for_good, D::kArrived}}},
  };
}

std::vector<DriveRow> standing_rows()
{
  using D = DriveState;
  const DriveExit resume{"resume asked", asked<Asked::kResume>, D::kPlan};
  DriveRow fault = resting(D::kFault);
  fault.command = [](const S &) { return stop(); };
  fault.exits = {{"clear asked", asked<Asked::kClearFault>, D::kHeld}};
  return {
    resting(D::kIdle),
    {D::kWaitPose,
     stay,
     pose_limit,
     Fault::kPoseLost,
     {{"told where it stands", asked<Asked::kRelocalise>, D::kHeld},
      {"the pose is usable again", is_sound_again, D::kPlan}},
     true,
     false},
    {D::kHeld, stay, held_limit, Fault::kHeldTooLong, {resume}, false, false},
    {D::kPaused, stay, held_limit, Fault::kHeldTooLong, {resume}, false, false},
    fault,
    resting(D::kAborted),
    resting(D::kArrived)};
}

std::vector<DriveRow> ordered_rows()
{
  std::vector<DriveRow> rows = working_rows();
  for (const DriveRow & row : standing_rows()) {
    rows.push_back(row);
  }
  std::sort(rows.begin(), rows.end(), [](const DriveRow & a, const DriveRow & b) {
    return a.state < b.state;
  });
  return rows;
}

}  // namespace

const char * to_string(DriveState state)
{
  constexpr std::array<const char *, kDriveStateCount> kNames{
    {"idle", "floor_plan", "floor_aim", "floor_steer_across", "floor_turn", "floor_steer_along",
     "floor_roll", "floor_blocked", "floor_hand_over", "floor_wait_pose", "floor_held",
     "floor_paused", "floor_fault", "floor_aborted", "floor_arrived"}};
  return kNames[static_cast<std::size_t>(state)];
}

const std::vector<DriveRow> & drive_table()
{
  static const std::vector<DriveRow> kTable = ordered_rows();
  return kTable;
}

const std::vector<DriveExit> & common_drive_exits()
{
  using D = DriveState;
  static const std::vector<DriveExit> kExits{
    {"emergency stop", emergency_stop, D::kFault, Fault::kEmergencyStop},
    {"a block is broken", block_broken, D::kFault, Fault::kBlockFault},
    {"abort asked", abort_asked, D::kAborted},
    {"driver silent or restarted, or the clock went back", driver_lost, D::kHeld},
    {"a switch is broken", switch_broken, D::kFault, Fault::kContactFault},
    {"pause asked", pause_asked, D::kPaused},
    {"commands refused", refused_too_long, D::kFault, Fault::kCommandRefused},
    {"the pose is not usable", pose_unusable, D::kWaitPose},
  };
  return kExits;
}

}  // namespace stetro_supervisor
