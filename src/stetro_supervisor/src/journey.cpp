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

#include "stetro_supervisor/journey.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stetro_config/value.hpp"
#include "stetro_supervisor/pose_reason.hpp"
#include "stetro_supervisor/rejoin.hpp"
#include "stetro_supervisor/robot_health.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::Flight;
using stetro_site::Floor;
using stetro_site::Pose;
using stetro_site::Site;

bool is_free_state(State state)
{
  return state == State::kIdle || state == State::kAborted || state == State::kFinished;
}

constexpr double kRecentScan_s = 0.5;
constexpr double kClearly = 0.8;  // of the yaw rate at which scans are used: wheels are uneven

/// A turn that is slow enough for its scans to be used.
MotionCommand slowed(MotionCommand command, double most_rad_s)
{
  command.wz_rps = std::clamp(command.wz_rps, -most_rad_s, most_rad_s);
  return command;
}

std::vector<const DrawnFloor *> pointers(
  const std::map<std::string, std::shared_ptr<const DrawnFloor>> & floors)
{
  std::vector<const DrawnFloor *> all;
  for (const auto & [id, floor] : floors) {
    all.push_back(floor.get());
  }
  return all;
}

}  // namespace

Journey::Journey(
  const Site & site, const stetro_site::RobotGeometry & robot, const ClimbParams & climb,
  const FloorParams & floor, const std::string & flight)
: site_(site),
  robot_(robot),
  limits_(climb),
  params_(floor),
  drive_(floor, climb, robot),
  flight_(site.flight(flight).id())
{
  for (const Flight & each : site_.flights()) {
    climbs_.emplace(each.id(), std::make_unique<Climb>(climb, make_geometry(each, robot)));
  }
  for (const Floor & each : site_.floors()) {
    if (each.is_drawn()) {
      floors_.emplace(
        each.id, std::make_shared<const DrawnFloor>(site_, each.id, floor.resolution_m));
    }
  }
  check_ = std::make_unique<FloorCheck>(pointers(floors_), robot, floor);
}

bool Journey::is_free() const
{
  const bool ended = part_ == Part::kDone || part_ == Part::kAborted;
  return ended || (part_ == Part::kStill && is_free_state(climb().state()));
}

bool Journey::has_fault() const
{
  return drives() ? drive_.state() == DriveState::kFault : climb().state() == State::kFault;
}

std::string Journey::segment() const { return drives() ? floor_ : flight_; }

void Journey::clean()
{
  part_ = Part::kStill;
  goal_.clear();
}

void Journey::select(const std::string & flight)
{
  if (flight != flight_) {
    flight_ = site_.flight(flight).id();
    climb().look_on(now_, seen_);
  }
}

MotionCommand Journey::tick(Time now, const Observation & seen)
{
  now_ = now;
  seen_ = seen;
  told_.clear();
  take_pose();
  check_->tick(now, seen, context());
  watch_whereabouts();
  MotionCommand command;
  if (part_ == Part::kStill || part_ == Part::kClimb) {
    command = climb().tick(now, seen);
    follow_climb();
  } else {
    climb().look_on(now, seen);
    const bool ended = part_ == Part::kDone || part_ == Part::kAborted;
    command = ended ? nothing() : drive_.tick(now, seen, drive_pose());
    if (!ended) {
      follow_drive();
    }
    // Half a turn at full speed takes longer than a robot that was carried off may go on.
    if (has_recent_scan() && check_->awaits_scan(now)) {
      command = slowed(command, kClearly * params_.check_turn_rad_s);
    }
  }
  moving_ = command.moves();
  return command;
}

void Journey::take_pose()
{
  place_ = seen_.pose ? place_on_floor(*seen_.pose, site_) : std::nullopt;
  const bool known = seen_.pose && climbs_.count(seen_.pose->segment_id) != 0;
  if (known && part_ == Part::kStill && is_free()) {
    select(seen_.pose->segment_id);
  }
}

std::string Journey::pose_doubt() const
{
  const auto & pose = seen_.pose;
  if (older_than(pose, now_, limits_.pose_silence_s)) {
    return "the localizer is silent";
  }
  const bool bearable =
    pose->integrity == Integrity::kDegraded && (pose->reasons & ~kBearableReasons) == 0u;
  if (pose->integrity != Integrity::kOk && !bearable) {
    return "integrity is " +
           std::string(
             pose->integrity == Integrity::kLost       ? "LOST"
             : pose->integrity == Integrity::kDegraded ? "DEGRADED"
                                                       : "UNKNOWN") +
           ": " + reasons_in_words(pose->reasons);
  }
  if (check_->doubts_pose()) {
    return "the profile is against the pose: " + check_->doubt();
  }
  return "";
}

bool Journey::has_recent_scan() const
{
  return seen_.scan && seconds_between(seen_.scan->time, now_) <= kRecentScan_s;
}

const DrawnFloor * Journey::drawn_floor(const std::string & id) const
{
  const auto found = floors_.find(id);
  return found != floors_.end() ? found->second.get() : nullptr;
}

/// A climb that has not begun: the robot may stand anywhere on the floor below.
bool Journey::waits_before_stairs() const
{
  return part_ == Part::kClimb && climb().state() == State::kWaitPose && climb().record().step == 0;
}

/// What it was about to do was for another place than the one where it has been found.
bool Journey::is_elsewhere() const
{
  const bool drive_waits =
    (part_ == Part::kToFoot || part_ == Part::kRollOff) && drive_.state() == DriveState::kWaitPose;
  const bool found = place_ && is_drawn_floor(place_->floor_id) && pose_doubt().empty() &&
                     is_level(seen_, limits_.height_tolerance_m);
  return found && ((drive_waits && seen_.pose->resets != errand_resets_) ||
                   (waits_before_stairs() && !seen_.pose->on_flight));
}

/// Sets out anew from where the robot has been found, once that has been sound for long enough.
void Journey::watch_whereabouts()
{
  if (!is_elsewhere()) {
    elsewhere_since_.reset();
    return;
  }
  elsewhere_since_ = elsewhere_since_.value_or(now_);
  if (seconds_between(*elsewhere_since_, now_) < limits_.pose_settle_s) {
    return;
  }
  if (part_ == Part::kClimb) {
    climb().leave();
  }
  tell("found on '" + place_->floor_id + "'");
  set_out();
}

DrivePose Journey::drive_pose() const
{
  DrivePose pose{std::nullopt, pose_doubt()};
  if (!pose.doubt.empty()) {
    return pose;
  }
  if (!place_ || place_->floor_id != floor_) {
    pose.doubt = "the pose is on '" + seen_.pose->segment_id + "', accepted: floor '" + floor_ +
                 "' and the ends of its flights";
    return pose;
  }
  pose.place = place_;
  return pose;
}

CheckContext Journey::context() const
{
  CheckContext context;
  const auto & pose = seen_.pose;
  if (floors_.empty() || older_than(pose, now_, limits_.pose_silence_s)) {
    return context;
  }
  const bool knows_not =
    pose->integrity == Integrity::kLost || (pose->reasons & kNotInitialised) != 0u;
  const bool drawn = place_ && is_drawn_floor(place_->floor_id);
  const bool climbs = (part_ == Part::kClimb || part_ == Part::kStill) && !is_free() &&
                      !(waits_before_stairs() && !pose->on_flight);
  if (!knows_not && drawn && pose->integrity != Integrity::kUnknown) {
    context.told = place_;
    // Before the first step, too: if the robot has been carried off, only the profile tells.
    context.corrigible =
      !pose->on_flight || (pose->step == 0 && is_level(seen_, limits_.height_tolerance_m));
  }
  const bool between = pose->on_flight && !drawn && (pose->reasons & kNotInitialised) == 0u;
  context.lost = knows_not && !climbs && !between && is_level(seen_, limits_.height_tolerance_m);
  if (context.lost && drawn && (pose->reasons & kNotInitialised) == 0u) {
    context.lost_on = place_->floor_id;
  }
  context.moving = moving_;
  return context;
}

void Journey::tell(const std::string & what) { told_ += told_.empty() ? what : "; " + what; }

void Journey::follow_drive()
{
  const auto changed = drive_.transition();
  if (!changed) {
    return;
  }
  tell(
    "floor '" + floor_ + "': " + to_string(changed->from) + " -> " + to_string(changed->to) + ": " +
    changed->why);
  const bool turns = changed->to == DriveState::kSteerAlong || changed->to == DriveState::kHandOver;
  if (turns || changed->to == DriveState::kBlocked) {
    check_->request();  // it stands; and what is in the way may be a wall, and the pose wrong
  }
  if (changed->to == DriveState::kAborted) {
    part_ = Part::kAborted;
  } else if (changed->to == DriveState::kArrived) {
    arrive();
  }
}

void Journey::arrive()
{
  if (part_ == Part::kRollOff) {
    go_on();
  } else if (flight_ == goal_) {
    part_ = Part::kDone;
    tell("at the foot of '" + goal_ + "', the goal");
  } else {
    begin_climb(0);
  }
}

void Journey::begin_climb(int step)
{
  part_ = Part::kClimb;
  climb().start(request_id_, issuer_, step);
  tell("climbs '" + flight_ + "'");
}

void Journey::follow_climb()
{
  const auto & changed = climb().transition();
  if (!changed) {
    return;
  }
  tell(
    "step " + std::to_string(climb().record().step) + ": " + to_string(changed->from) + " -> " +
    to_string(changed->to) + ": " + changed->why);
  if (part_ != Part::kClimb) {
    return;
  }
  if (climb().state() == State::kFinished) {
    roll_off(flight());
  } else if (climb().state() == State::kAborted) {
    part_ = Part::kAborted;
    floor_ = flight_;
  }
}

std::string Journey::refuse_check() const
{
  if (floors_.empty()) {
    return "no floor is drawn in the site file, so there is nothing to compare a scan with";
  }
  if (older_than(seen_.pose, now_, limits_.pose_silence_s)) {
    return "the localizer is silent";
  }
  const CheckContext known = context();
  if (known.lost) {
    return "the pose is lost, and the floors are being searched for the robot already";
  }
  if (!known.told || !known.corrigible) {
    return "the pose is on '" + seen_.pose->segment_id + "', step " +
           std::to_string(seen_.pose->step) + ", accepted: a drawn floor or the foot of a flight";
  }
  if (!has_recent_scan()) {
    return "no scan within " + stetro_config::to_text(kRecentScan_s) +
           " s, accepted: a lidar that is heard on 'scan'";
  }
  return "";
}

std::string Journey::refuse_to_go(const std::string & goal) const
{
  if (is_emergency_stop_closed(seen_)) {
    return "the emergency stop is closed";
  }
  if (const std::string doubt = pose_doubt(); !doubt.empty()) {
    return "no way without a usable pose: " + doubt;
  }
  const std::string from = place_ ? place_->floor_id : seen_.pose->segment_id;
  const Route route = find_route(site_, from, goal);
  if (route.segments.empty()) {
    return route.refusal;
  }
  for (const std::string & id : route.segments) {
    if (site_.find_floor(id) != nullptr && !is_drawn_floor(id)) {
      return "floor '" + id +
             "' on the way is not drawn, accepted: walls or a map in the site file";
    }
  }
  if (place_) {
    return is_level(seen_, limits_.height_tolerance_m)
             ? ""
             : "the blocks are not level, accepted: all three down on the floor";
  }
  if (seen_.pose->segment_id != flight_) {
    return "the pose is on '" + seen_.pose->segment_id + "', which is not the present flight";
  }
  Memory fresh = climb().situation().memory;
  fresh.record = MissionRecord{};
  fresh.record.step = seen_.pose->step;
  const Situation s = climb().situation();
  return choose_entry({s.params, s.geometry, s.seen, fresh, s.state, s.now, s.entered}).refusal;
}

}  // namespace stetro_supervisor
