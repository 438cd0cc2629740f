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

#include "stetro_supervisor/journey.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::Flight;
using stetro_site::Floor;
using stetro_site::Pose;

constexpr double kOnLastTread_m = 0.40;  // before the end of a flight, where it is left straight on
constexpr double kFacesUp_rad = 0.6;

}  // namespace

/// The last tread is flush with the floor: straight on until all of the body is off the stairs.
void Journey::roll_off(const Flight & flight)
{
  const Floor & floor = site_.floor(flight.spec().upper_floor);
  Pose here{0.0, 0.5 * flight.width_m(flight.total_run_m()), 0.0, 0.0};
  if (place_ && place_->floor_id == floor.id) {
    here.y_m = in_flight(*place_, floor, flight).y_m;
  }
  here.x_m = flight.total_run_m() + params_.roll_off_m;
  part_ = Part::kRollOff;
  floor_ = floor.id;
  Errand errand;
  errand.floor = floors_.at(floor_);
  errand.goal_m = on_floor(here, floor, flight).position_m;
  errand.straight = true;
  errand.hand_over_to = floor_;
  start(errand);
  tell("rolls off '" + flight.id() + "' onto '" + floor_ + "'");
}

void Journey::start(const Errand & errand)
{
  errand_resets_ = seen_.pose ? seen_.pose->resets : 0u;
  drive_.start(errand);
}

void Journey::drive_to_foot(const Flight & flight)
{
  const Floor & floor = site_.floor(flight.spec().lower_floor);
  const Pose foot{-params_.foot_m, 0.5 * flight.width_m(0.0), 0.0, 0.0};
  const FloorPlace place = on_floor(foot, floor, flight);
  part_ = Part::kToFoot;
  floor_ = floor.id;
  flight_ = flight.id();
  Errand errand;
  errand.floor = floors_.at(floor_);
  errand.goal_m = place.position_m;
  errand.yaw_rad = place.yaw_rad;
  errand.hand_over_to = flight.id();
  start(errand);
  tell("drives to the foot of '" + flight.id() + "'");
}

/// From the floor it is on, with nothing left of a flight: the next flight, or the end.
void Journey::go_on()
{
  if (floor_ == goal_) {
    part_ = Part::kDone;
    tell("on '" + goal_ + "', the goal");
    return;
  }
  const Route route = find_route(site_, floor_, goal_);
  if (route.segments.size() < 2) {
    give_up("no way to '" + goal_ + "' from '" + floor_ + "': " + route.refusal);
    return;
  }
  drive_to_foot(site_.flight(route.segments[1]));
}

/// A robot that somebody has carried to where its goal cannot be reached from.
void Journey::give_up(const std::string & why)
{
  part_ = Part::kAborted;
  drive_.restore(why);
  tell(why);
}

const Flight * Journey::flight_to_leave(const FloorPlace & place) const
{
  const Floor & floor = site_.floor(place.floor_id);
  for (const Flight & flight : site_.flights()) {
    if (flight.spec().upper_floor != floor.id) {
      continue;
    }
    const Pose pose = in_flight(place, floor, flight);
    const double beyond_m = pose.x_m - flight.total_run_m();
    const bool near = beyond_m > -kOnLastTread_m && beyond_m < params_.roll_off_m - 0.05;
    const bool between = pose.y_m > 0.0 && pose.y_m < flight.widest_m();
    if (near && between && std::abs(pose.yaw_rad) < kFacesUp_rad) {
      return &flight;
    }
  }
  return nullptr;
}

/// From wherever the robot is.
void Journey::set_out()
{
  stray_ = false;
  if (!place_) {
    flight_ = seen_.pose->segment_id;
    begin_climb(seen_.pose->step);
    return;
  }
  floor_ = place_->floor_id;
  if (const Flight * flight = flight_to_leave(*place_)) {
    roll_off(*flight);
  } else if (floor_ == goal_) {
    part_ = Part::kRollOff;  // nothing to drive; but the localizer must be on the floor
    Errand errand;
    errand.floor = floors_.at(floor_);
    errand.goal_m = place_->position_m;
    errand.hand_over_to = floor_;
    start(errand);
  } else {
    go_on();
  }
}

void Journey::go(
  const std::string & request_id, const std::string & issuer, const std::string & goal)
{
  request_id_ = request_id;
  issuer_ = issuer;
  goal_ = goal;
  set_out();
}

void Journey::resume_drive()
{
  const bool another = seen_.pose && seen_.pose->resets != errand_resets_;
  const bool found = pose_doubt().empty() && place_ && is_drawn_floor(place_->floor_id);
  if ((stray_ || another) && found) {
    set_out();
  } else {
    drive_.ask(Asked::kResume);
  }
}

MissionRecord Journey::record() const
{
  const bool still = part_ == Part::kStill;
  if (still || part_ == Part::kClimb) {
    MissionRecord record = climb().record();
    record.goal = still ? "" : goal_;
    return record;
  }
  MissionRecord record;
  record.active = part_ == Part::kToFoot || part_ == Part::kRollOff;
  record.segment_id = floor_;
  record.request_id = request_id_;
  record.issuer = issuer_;
  record.goal = goal_;
  return record;
}

std::string Journey::misfit(const MissionRecord & record) const
{
  const std::string unknown =
    "the kept mission is for another flight: '" + record.segment_id + "', not used";
  const bool goes = !record.goal.empty();
  const bool goal_known =
    site_.find_floor(record.goal) != nullptr || site_.find_flight(record.goal) != nullptr;
  if (goes && (!goal_known || !knows_floors())) {
    return "the kept mission goes to '" + record.goal + "', which is not on this site, not used";
  }
  const auto found = climbs_.find(record.segment_id);
  if (found == climbs_.end()) {
    return goes && is_drawn_floor(record.segment_id) ? "" : unknown;
  }
  const int steps = found->second->geometry().steps();
  const bool fits = record.step >= 0 && record.step <= steps &&
                    record.swept.size() == static_cast<std::size_t>(steps);
  return fits ? "" : unknown;
}

void Journey::restore(const MissionRecord & record)
{
  goal_ = record.goal;
  request_id_ = record.request_id;
  issuer_ = record.issuer;
  if (climbs_.count(record.segment_id) != 0) {
    flight_ = record.segment_id;
    part_ = goal_.empty() ? Part::kStill : Part::kClimb;
    climb().restore(record);
    return;
  }
  part_ = Part::kToFoot;
  floor_ = record.segment_id;
  stray_ = true;
  drive_.restore("restarted in the middle of a mission: waits for a resume request");
}

}  // namespace stetro_supervisor
