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

#include "stetro_supervisor/floor/floor_drive.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "stetro_supervisor/floor/grid_planner.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kNoLeg_m = 0.03;  // a goal that near is reached

/// When a condition began to hold without a break.
void note_since(std::optional<Time> & since, bool holds, Time now)
{
  if (!holds) {
    since.reset();
  } else if (!since) {
    since = now;
  }
}

}  // namespace

double body_radius_m(const stetro_site::RobotGeometry & robot)
{
  return std::hypot(0.5 * robot.length_m(), 0.5 * robot.contact_width_m);
}

FloorDrive::FloorDrive(
  const FloorParams & params, const ClimbParams & limits, const stetro_site::RobotGeometry & robot)
: params_(params),
  limits_(limits),
  robot_(robot),
  clearance_m_(body_radius_m(robot) + params.margin_m)
{
}

void FloorDrive::start(const Errand & errand)
{
  if (!errand.floor) {
    throw std::invalid_argument("floor drive: an errand without a floor, one wanted");
  }
  memory_ = DriveMemory{};
  memory_.errand = errand;
  started_ = true;
}

void FloorDrive::restore(const std::string & note)
{
  memory_ = DriveMemory{};
  memory_.note = note;
  state_ = DriveState::kHeld;
}

DriveSituation FloorDrive::situation() const
{
  return {params_, limits_, robot_, seen_, pose_, memory_, state_, now_, entered_};
}

double FloorDrive::time_limit_s() const
{
  const auto limit_s = row_of(state_).limit_s;
  return limit_s != nullptr ? limit_s(situation()) : std::numeric_limits<double>::infinity();
}

void FloorDrive::watch()
{
  memory_.driver_changed = seen_.driver_instance && memory_.driver_instance &&
                           *seen_.driver_instance != *memory_.driver_instance;
  if (seen_.driver_instance) {
    memory_.driver_instance = seen_.driver_instance;
  }
  const auto & answer = seen_.driver_answer;
  const bool refused =
    answer && answer->refused && seconds_between(answer->time, now_) <= limits_.driver_silence_s;
  note_since(memory_.refused_since, refused, now_);
  note_since(memory_.sound_since, pose_.place.has_value(), now_);
  const DriveSituation s = situation();
  note_since(memory_.obstructed_since, s.sees_obstacle(), now_);
  note_since(memory_.free_since, !s.bumps() && !s.is_obstructed(), now_);
}

const DriveExit * FloorDrive::first_open(const DriveSituation & s) const
{
  for (const auto * exits : {&common_drive_exits(), &row_of(state_).exits}) {
    for (const DriveExit & exit : *exits) {
      if (exit.guard(s)) {
        return &exit;
      }
    }
  }
  return nullptr;
}

void FloorDrive::enter(const DriveExit & exit, const DriveSituation & s, const std::string & why)
{
  transition_ = DriveTransition{state_, exit.to, why};
  if (exit.effect != nullptr) {
    exit.effect(s, memory_);
  }
  memory_.fault = exit.fault;
  memory_.note =
    row_of(exit.to).works && exit.to != DriveState::kWaitPose && exit.to != DriveState::kBlocked
      ? ""
      : why;
  state_ = exit.to;
  entered_ = now_;
  if (state_ == DriveState::kPlan) {
    plan();
  }
}

bool FloorDrive::is_planned() const
{
  return !memory_.corners_m.empty() || !memory_.no_way.empty();
}

void FloorDrive::plan()
{
  memory_.corners_m.clear();
  memory_.leg = 1;
  memory_.no_way.clear();
  const Errand & errand = memory_.errand;
  if (!pose_.place || !errand.floor) {
    return;  // the next tick waits for the pose
  }
  const Eigen::Vector2d from = pose_.place->position_m;
  if (errand.straight || (errand.goal_m - from).norm() < kNoLeg_m) {
    memory_.corners_m = {from, errand.goal_m};
  } else {
    const auto field = memory_.obstacles_m.empty()
                         ? errand.floor->drivable()
                         : errand.floor->drivable_around(memory_.obstacles_m);
    const FloorPath path = GridPlanner{field, clearance_m_}.plan(from, errand.goal_m);
    memory_.corners_m = path.corners_m;
    memory_.no_way = path.refusal;
  }
  while (memory_.leg < memory_.corners_m.size() &&
         (memory_.corners_m[memory_.leg] - from).norm() < kNoLeg_m) {
    ++memory_.leg;
  }
}

MotionCommand FloorDrive::tick(Time now, const Observation & seen, const DrivePose & pose)
{
  transition_.reset();
  memory_.clock_went_back = now < now_;
  if (now_ == Time{0} || memory_.clock_went_back) {
    entered_ = now;
    memory_.obstructed_since.reset();
    memory_.free_since.reset();
    memory_.sound_since.reset();
    memory_.refused_since.reset();
  }
  now_ = now;
  seen_ = seen;
  pose_ = pose;
  if (state_ == DriveState::kPlan && !is_planned()) {
    plan();
  }
  watch();
  const DriveSituation s = situation();
  if (started_) {
    started_ = false;
    enter({"an errand", nullptr, DriveState::kPlan}, s, "an errand");
  } else if (const DriveExit * exit = first_open(s)) {
    std::string why = exit->when;
    why += exit->to == DriveState::kWaitPose ? ": " + pose_.doubt : "";
    why += exit->fault == Fault::kNoWay ? ": " + memory_.no_way : "";
    enter(*exit, s, why);
  } else if (s.in_state_s() > time_limit_s()) {
    const std::string why = std::string("no exit of '") + to_string(state_) + "' within " +
                            std::to_string(time_limit_s()) + " s";
    enter({"time limit", nullptr, DriveState::kFault, row_of(state_).on_limit}, s, why);
  }
  if (state_ == DriveState::kWaitPose && !pose_.place) {
    memory_.note = pose_.doubt;  // what is waited for may change
  }
  memory_.asked = Asked::kNothing;
  return row_of(state_).command(situation());
}

}  // namespace stetro_supervisor
