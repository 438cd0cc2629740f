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

#include <string>

#include "stetro_supervisor/mission.hpp"
#include "stetro_supervisor/rejoin.hpp"

namespace stetro_supervisor
{
namespace
{

bool is_free(State state)
{
  return state == State::kIdle || state == State::kAborted || state == State::kFinished;
}

bool emergency_stop_closed(const Situation & s)
{
  return s.seen.contacts && s.seen.contacts->emergency_stop.state != ContactState::kOpen;
}

/// What is seen to move, in words; empty if nothing is.
std::string moving_part(const Situation & s)
{
  for (int number = 1; number <= 3; ++number) {
    if (s.block(number).moving) {
      return "block " + std::to_string(number);
    }
  }
  return s.seen.blocks && s.seen.blocks->steering_moving ? "the steering" : "";
}

constexpr char kNoDrawnFloor[] =
  "going to a segment is not supported here, for no floor is drawn in the site file, and going "
  "down "
  "stairs is not supported";

}  // namespace

bool Mission::is_busy() const
{
  return journey_ != nullptr ? !journey_->is_free() : !is_free(climb().state());
}

std::string Mission::known_flights() const
{
  if (journey_ == nullptr) {
    return "'" + climb().geometry().segment_id + "'";
  }
  std::string ids;
  for (const auto & flight : journey_->site().flights()) {
    ids += (ids.empty() ? "'" : ", '") + flight.id() + "'";
  }
  return ids;
}

std::string Mission::refuse_clean(const MissionRequest & request)
{
  const bool known = journey_ != nullptr
                       ? journey_->site().find_flight(request.segment_id) != nullptr
                       : request.segment_id == climb().geometry().segment_id;
  if (!known) {
    return "segment '" + request.segment_id + "' is no flight here, accepted: " + known_flights();
  }
  if (is_busy()) {
    return "a mission is under way in state '" + state_name() + "'";
  }
  if (journey_ != nullptr) {
    journey_->select(request.segment_id);
  }
  const Situation s = climb().situation();
  if (emergency_stop_closed(s)) {
    return "the emergency stop is closed or unknown";
  }
  if (!s.pose_lets_approach()) {
    return "no climb without a sound pose: " + s.pose_doubt();
  }
  if (s.seen.pose->step >= s.geometry.steps()) {
    return "the robot is on the last tread already, and going down is not supported";
  }
  Memory fresh = s.memory;
  fresh.record = MissionRecord{};
  fresh.record.step = s.seen.pose->step;
  const RejoinChoice choice =
    choose_entry({s.params, s.geometry, s.seen, fresh, s.state, s.now, s.entered});
  if (choice.entry) {
    climb().start(request.request_id, request.issuer, s.seen.pose->step);
    if (journey_ != nullptr) {
      journey_->clean();
    }
  }
  return choice.refusal;
}

std::string Mission::refuse_to_go(const MissionRequest & request)
{
  if (journey_ == nullptr || !journey_->knows_floors()) {
    return kNoDrawnFloor;
  }
  if (is_busy()) {
    return "a mission is under way in state '" + state_name() + "'";
  }
  const std::string reason = journey_->refuse_to_go(request.segment_id);
  if (reason.empty()) {
    journey_->go(request.request_id, request.issuer, request.segment_id);
  }
  return reason;
}

std::string Mission::refuse_pause() const
{
  const MissionState state = mission_state();
  if (state == MissionState::kPaused) {
    return "paused already";
  }
  const bool works =
    drives() ? row_of(journey_->drive().state()).works && is_busy() : row_of(climb().state()).works;
  return works ? "" : "nothing moves in state '" + state_name() + "'";
}

std::string Mission::refuse_resume() const
{
  const bool waits = drives() ? journey_->drive().state() == DriveState::kWaitPose
                              : climb().state() == State::kWaitPose;
  if (waits) {
    return "waits for the pose and goes on by itself: " +
           (drives() ? journey_->drive().note() : climb().note());
  }
  const MissionState state = mission_state();
  if (state != MissionState::kHeld && state != MissionState::kPaused) {
    return "neither paused nor held, but '" + state_name() + "'";
  }
  return drives() ? journey_->pose_doubt() : choose_entry(climb().situation()).refusal;
}

std::string Mission::refuse_abort() const
{
  if (mission_state() == MissionState::kFault) {
    const Fault fault = drives() ? journey_->drive().fault() : climb().fault();
    return "the fault '" + std::string(to_string(fault)) + "' has to be cleared first";
  }
  return record().active ? "" : "no mission is under way";
}

std::string Mission::refuse_clear() const
{
  if (mission_state() != MissionState::kFault) {
    return "there is no fault";
  }
  const Situation s = climb().situation();
  if (emergency_stop_closed(s)) {
    return "the emergency stop is closed or unknown";
  }
  for (int number = 1; number <= 3; ++number) {
    if (s.block(number).fault) {
      return "block " + std::to_string(number) +
             " is still broken, accepted: after 'stetro_jog reset' has mended it";
    }
  }
  return "";
}

std::string Mission::refuse_check()
{
  if (journey_ == nullptr) {
    return "no floor is drawn in the site file, so there is nothing to compare a scan with";
  }
  const std::string reason = journey_->refuse_check();
  if (reason.empty()) {
    journey_->check_pose();
  }
  return reason;
}

std::string Mission::refuse_relocalise(const MissionRequest & request)
{
  const Situation s = climb().situation();
  if (mission_state() == MissionState::kRunning) {
    return "the mission is running, in state '" + state_name() +
           "', accepted: idle, paused, held, finished, aborted or in fault";
  }
  if (const std::string part = moving_part(s); !part.empty()) {
    return part + " still moves, accepted: a robot at rest";
  }
  const std::string reason = refuse_told(request);
  if (!reason.empty()) {
    return reason;
  }
  if (!s.seen.pose) {
    return "no localizer has been heard yet, accepted: one that can be told";
  }
  forwarded_ = Forwarded{request, s.seen.pose->resets, s.now};
  if (drives() && journey_->drive().state() == DriveState::kWaitPose) {
    journey_->drive().ask(Asked::kRelocalise);
  } else if (!drives() && climb().state() == State::kWaitPose) {
    climb().ask(Asked::kRelocalise);
  }
  return "";
}

/// A drawn floor is told by its id. At a flight's foot its frame means the flight's step 0.
const DrawnFloor * Mission::told_floor(const MissionRequest & request) const
{
  const bool by_flight = request.told.frame_id == flight().id();
  return journey_ != nullptr && !by_flight ? journey_->drawn_floor(request.segment_id) : nullptr;
}

std::string Mission::refuse_told(const MissionRequest & request) const
{
  if (const DrawnFloor * floor = told_floor(request)) {
    return refusal_on_floor(request.told, *floor);
  }
  const std::string reason = refusal_of(request.told, request.segment_id, flight());
  const bool knows_floors = journey_ != nullptr && journey_->knows_floors();
  return !reason.empty() && knows_floors ? reason + "; or a drawn floor by its id" : reason;
}

}  // namespace stetro_supervisor
