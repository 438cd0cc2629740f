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
#include "stetro_supervisor/climb.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "stetro_site/frame_transform.hpp"
#include "stetro_supervisor/sweep.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kNearer_m = 0.002;  // progress that a stalled roll would not make

/// When a condition began to hold without a break.
void note_since(std::optional<Time> & since, bool holds, Time now)
{
  if (!holds) {
    since.reset();
  } else if (!since) {
    since = now;
  }
}

bool sweeps(State state)
{
  return state == State::kSweepLeft || state == State::kSweepRight ||
         state == State::kSweepToMiddle;
}

}  // namespace

Climb::Climb(ClimbParams params, ClimbGeometry geometry)
: params_(std::move(params)), geometry_(std::move(geometry))
{
  check_climbable(geometry_, params_);
}

void Climb::restore(const MissionRecord & record)
{
  memory_.record = record;
  memory_.note = "restarted in the middle of a mission: waits for a resume request";
  state_ = record.active ? State::kHeld : State::kIdle;
}

void Climb::start(const std::string & request_id, const std::string & issuer, int step)
{
  MissionRecord record;
  record.active = true;
  record.segment_id = geometry_.segment_id;
  record.request_id = request_id;
  record.issuer = issuer;
  record.step = step;
  record.swept.resize(static_cast<std::size_t>(geometry_.steps()));
  memory_.record = record;
  memory_.trims = 0;
  memory_.resweeps = 0;
  memory_.offset_pending = true;
  memory_.leg_mark = memory_.path;
  memory_.asked = Asked::kStart;
}

void Climb::leave()
{
  memory_.record = MissionRecord{};
  memory_.asked = Asked::kNothing;
  memory_.fault = Fault::kNone;
  memory_.note.clear();
  state_ = State::kIdle;
  entered_ = now_;
}

Situation Climb::situation() const
{
  return {params_, geometry_, seen_, memory_, state_, now_, entered_};
}

double Climb::time_limit_s() const
{
  const auto limit = row_of(state_).limit_s;
  return limit ? params_.*limit : std::numeric_limits<double>::infinity();
}

void Climb::take_time(Time now)
{
  const bool first = now_ == Time{0};
  memory_.clock_went_back = now < now_;
  if (first || memory_.clock_went_back) {
    entered_ = now;
    memory_.medians = {};
    memory_.skewed_since.reset();
    memory_.front_free_since.reset();
    memory_.pose_sound_since.reset();
    memory_.refused_since.reset();
  }
  now_ = now;
}

void Climb::follow_path(const OdometryPose & odometry)
{
  if (last_odometry_ && !memory_.driver_changed) {
    const double dx = odometry.x_m - last_odometry_->x_m;
    const double dy = odometry.y_m - last_odometry_->y_m;
    const double turn = situation().heading_rad() - odometry.yaw_rad;  // frame odom to flight
    const double along = std::cos(turn) * dx - std::sin(turn) * dy;
    memory_.path.along_m += along;
    memory_.path.across_m += std::sin(turn) * dx + std::cos(turn) * dy;
    memory_.path.turned_rad += stetro_site::wrap_angle(odometry.yaw_rad - last_odometry_->yaw_rad);
    memory_.offset.roll(along);
  }
  last_odometry_ = odometry;
}

void Climb::take_ranges(double dt_s)
{
  for (std::size_t i = 0; i < kPlaceCount; ++i) {
    if (seen_.ranges[i]) {
      memory_.medians[i].take(*seen_.ranges[i]);
    }
  }
  const auto & middle = seen_.range(Place::kStairFront);
  const bool fresh = middle && middle->time > last_front_time_;
  const auto front_m = situation().front_middle_m();
  const bool on_tread = phase_of(state_) == Phase::kSweeping && situation().riser_ahead();
  if (fresh && front_m && on_tread && !memory_.offset_pending) {
    memory_.offset.see(*front_m, dt_s);
  }
  last_front_time_ = middle ? middle->time : last_front_time_;
}

void Climb::watch_driver(const Situation & s)
{
  memory_.driver_changed = seen_.driver_instance && memory_.driver_instance &&
                           *seen_.driver_instance != *memory_.driver_instance;
  if (seen_.driver_instance) {
    memory_.driver_instance = seen_.driver_instance;
  }
  const auto & answer = seen_.driver_answer;
  const bool refused =
    answer && answer->refused && seconds_between(answer->time, s.now) <= params_.driver_silence_s;
  note_since(memory_.refused_since, refused, now_);
}

void Climb::watch(const Situation & s)
{
  note_since(memory_.skewed_since, s.riser_left() != s.riser_right(), now_);
  const auto front = s.range_m(Place::kStairFront);
  note_since(memory_.front_free_since, front && *front > params_.front_free_m, now_);
  note_since(memory_.pose_sound_since, s.pose_sound(), now_);
  if (row_of(state_).gap_m) {
    watch_gap(row_of(state_).gap_m(s));
  }
  if (sweeps(state_) && s.pose_usable() && s.step() >= 1) {
    memory_.record.swept.at(static_cast<std::size_t>(s.step() - 1)).pass(seen_.pose->y_m);
    memory_.heading.update(params_, s.heading_rad(), sweep_direction(s), memory_.offset.value_m());
  }
  if (state_ == State::kRollToRiser || state_ == State::kRealignBackOff) {
    memory_.record.rolled_m = memory_.rolled_before_m + s.along_m();
  }
}

void Climb::watch_gap(std::optional<double> gap_m)
{
  if (!gap_m || *gap_m < memory_.nearest_m - kNearer_m) {
    memory_.nearest_m = gap_m.value_or(std::numeric_limits<double>::infinity());
    memory_.nearest_time = now_;
    memory_.nearest_along_m = memory_.path.along_m;
  }
  memory_.farthest_m = std::max(memory_.farthest_m, gap_m.value_or(0.0));
}

const Exit * Climb::first_open(const Situation & s, const Row & row) const
{
  for (const auto * exits : {&common_exits(), &row.exits}) {
    for (const Exit & exit : *exits) {
      if (exit.guard(s)) {
        return &exit;
      }
    }
  }
  return nullptr;
}

std::string Climb::reason(const Exit & exit, const Situation & s) const
{
  if (exit.to == State::kWaitPose) {
    return s.pose_doubt();
  }
  if (exit.fault == Fault::kCommandRefused && seen_.driver_answer) {
    return std::string(exit.when) + ": " + seen_.driver_answer->reason;
  }
  if (exit.fault == Fault::kStepContradiction && seen_.pose) {
    return std::string(exit.when) + ": it says " + std::to_string(seen_.pose->step) + ", k is " +
           std::to_string(memory_.record.step);
  }
  return exit.when;
}

void Climb::enter(const Exit & exit, const Situation & s)
{
  const std::string why = reason(exit, s);
  transition_ = Transition{now_, state_, exit.to, why};
  if (exit.effect) {
    exit.effect(s, memory_);
  }
  memory_.fault = exit.to == State::kFault ? exit.fault : Fault::kNone;
  const bool tells = exit.to == State::kHeld || exit.to == State::kWaitPose ||
                     exit.to == State::kPaused || exit.to == State::kFault;
  memory_.note = tells ? why : "";
  state_ = exit.to;
  entered_ = now_;
  memory_.mark = memory_.path;
  memory_.farthest_m = 0.0;
  watch_gap(std::nullopt);
  const Phase phase = phase_of(state_);
  if (phase == Phase::kNone) {
    memory_.record.active = false;
  } else if (phase != Phase::kStanding) {
    memory_.record.state = state_;
  }
  if (row_of(state_).enter) {
    row_of(state_).enter(s, memory_);
  }
}

void Climb::look_on(Time now, const Observation & seen)
{
  transition_.reset();
  take_time(now);
  seen_ = seen;
  watch_driver(situation());
  if (seen_.odometry) {
    follow_path(*seen_.odometry);
  }
  const Time last_front = last_front_time_;
  const auto & front = seen_.range(Place::kFrontLeft);
  take_ranges(front ? std::max(0.0, seconds_between(last_front, front->time)) : 0.0);
}

MotionCommand Climb::tick(Time now, const Observation & seen)
{
  look_on(now, seen);
  const Situation s = situation();
  watch(s);
  const Row & row = row_of(state_);
  const double limit_s = time_limit_s();
  if (const Exit * exit = first_open(s, row)) {
    enter(*exit, s);
  } else if (s.in_state_s() > limit_s) {
    enter({"time limit", nullptr, State::kFault, row.on_limit}, s);
    memory_.note = std::string("no exit of '") + to_string(transition_->from) + "' within " +
                   std::to_string(limit_s) + " s";
  }
  if (state_ == State::kWaitPose && !s.pose_sound()) {
    memory_.note = s.pose_doubt();  // what is waited for may change
  }
  memory_.asked = Asked::kNothing;
  return row_of(state_).command(situation());
}

}  // namespace stetro_supervisor
