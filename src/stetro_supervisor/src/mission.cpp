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
#include "stetro_supervisor/mission.hpp"

#include <algorithm>

#include "stetro_config/value.hpp"
#include "stetro_supervisor/pose_reason.hpp"
#include "stetro_supervisor/rejoin.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr std::size_t kAnswersKept = 256;

constexpr char kIdReused[] = "request_id was used for another request";

bool same_matter(const MissionRequest & a, const MissionRequest & b)
{
  return a.kind == b.kind && a.segment_id == b.segment_id && same(a.told, b.told);
}

bool is_free(State state)
{
  return state == State::kIdle || state == State::kAborted || state == State::kFinished;
}

bool starts_something(RequestKind kind)
{
  return kind == RequestKind::kCleanFlight || kind == RequestKind::kResume ||
         kind == RequestKind::kRelocalise;
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

MissionState mission_state(const Climb & climb)
{
  switch (climb.state()) {
    case State::kIdle:
      return MissionState::kIdle;
    case State::kPaused:
      return MissionState::kPaused;
    case State::kHeld:
    case State::kWaitPose:
      return MissionState::kHeld;
    case State::kFinished:
      return MissionState::kFinished;
    case State::kAborted:
      return MissionState::kAborted;
    case State::kFault:
      return MissionState::kFault;
    default:
      return MissionState::kRunning;
  }
}

}  // namespace

const Mission::Answered * Mission::find(const MissionRequest & request) const
{
  const auto found = std::find_if(answered_.begin(), answered_.end(), [&](const Answered & a) {
    return a.request.request_id == request.request_id && a.request.issuer == request.issuer;
  });
  return found != answered_.end() ? &*found : nullptr;
}

bool Mission::knows(const MissionRequest & request) const
{
  const Answered * known = find(request);
  return known != nullptr && same_matter(known->request, request);
}

MissionAnswer Mission::request(const MissionRequest & request)
{
  MissionAnswer refused{request.request_id, request.issuer, false, ""};
  if (request.request_id.empty() || request.issuer.empty()) {
    refused.reason = "request_id or issuer is empty, accepted: both given";
    return refused;
  }
  const Answered * known = find(request);
  if (known == nullptr) {
    return answer_new(request);
  }
  if (!same_matter(known->request, request)) {
    refused.reason = kIdReused;
    return refused;
  }
  return known->answer;
}

MissionAnswer Mission::answer_new(const MissionRequest & request)
{
  MissionAnswer answer{request.request_id, request.issuer, false, refusal(request)};
  answer.waits = answer.reason.empty() && request.kind == RequestKind::kRelocalise;
  answer.accepted = answer.reason.empty() && !answer.waits;
  answered_.push_back({request, answer});
  if (answered_.size() > kAnswersKept) {
    answered_.pop_front();
  }
  return answer;
}

std::string Mission::refusal(const MissionRequest & request)
{
  const MissionRecord & record = climb_.record();
  if (record.active && record.request_id == request.request_id && record.issuer == request.issuer) {
    // the id of the request that started this mission, before a restart
    const MissionRequest start{
      record.request_id, record.issuer, RequestKind::kCleanFlight, record.segment_id};
    return same_matter(start, request) ? "" : kIdReused;
  }
  if (climb_.is_asked()) {
    return "another request is being taken up, ask again";
  }
  if (forwarded_ && starts_something(request.kind)) {
    return "the localizer is being told a pose by request '" + forwarded_->request.request_id +
           "', ask again when that is answered";
  }
  const auto judge = [this](const std::string & reason, Asked asked) {
    if (reason.empty()) {
      climb_.ask(asked);
    }
    return reason;
  };
  switch (request.kind) {
    case RequestKind::kCleanFlight:
      return refuse_clean(request);
    case RequestKind::kGoToSegment:
      return "going to a segment is not supported yet, and going down stairs is not supported";
    case RequestKind::kRelocalise:
      return refuse_relocalise(request);
    case RequestKind::kPause:
      return judge(refuse_pause(), Asked::kPause);
    case RequestKind::kResume:
      return judge(refuse_resume(), Asked::kResume);
    case RequestKind::kAbort:
      return judge(refuse_abort(), Asked::kAbort);
    case RequestKind::kClearFault:
      return judge(refuse_clear(), Asked::kClearFault);
    default:
      return "unknown kind of request";
  }
}

std::string Mission::refuse_clean(const MissionRequest & request)
{
  const Situation s = climb_.situation();
  const std::string & flight = climb_.geometry().segment_id;
  if (request.segment_id != flight) {
    return "segment '" + request.segment_id + "' is no flight here, accepted: '" + flight + "'";
  }
  if (!is_free(climb_.state())) {
    return std::string("a mission is under way in state '") + to_string(climb_.state()) + "'";
  }
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
    climb_.start(request.request_id, request.issuer, s.seen.pose->step);
  }
  return choice.refusal;
}

std::string Mission::refuse_pause() const
{
  if (climb_.state() == State::kPaused) {
    return "paused already";
  }
  return row_of(climb_.state()).works
           ? ""
           : std::string("nothing moves in state '") + to_string(climb_.state()) + "'";
}

std::string Mission::refuse_resume() const
{
  if (climb_.state() == State::kWaitPose) {
    return "waits for the pose and goes on by itself: " + climb_.note();
  }
  if (climb_.state() != State::kHeld && climb_.state() != State::kPaused) {
    return std::string("neither paused nor held, but '") + to_string(climb_.state()) + "'";
  }
  return choose_entry(climb_.situation()).refusal;
}

std::string Mission::refuse_abort() const
{
  if (climb_.state() == State::kFault) {
    return "the fault '" + std::string(to_string(climb_.fault())) + "' has to be cleared first";
  }
  return climb_.record().active ? "" : "no mission is under way";
}

std::string Mission::refuse_clear() const
{
  if (climb_.state() != State::kFault) {
    return "there is no fault";
  }
  const Situation s = climb_.situation();
  if (emergency_stop_closed(s)) {
    return "the emergency stop is closed or unknown";
  }
  for (int number = 1; number <= 3; ++number) {
    if (s.block(number).fault) {
      return "block " + std::to_string(number) + " is still broken";
    }
  }
  return "";
}

std::string Mission::refuse_relocalise(const MissionRequest & request)
{
  const Situation s = climb_.situation();
  if (mission_state(climb_) == MissionState::kRunning) {
    return std::string("the mission is running, in state '") + to_string(climb_.state()) +
           "', accepted: idle, paused, held, finished, aborted or in fault";
  }
  if (const std::string part = moving_part(s); !part.empty()) {
    return part + " still moves, accepted: a robot at rest";
  }
  const std::string reason = refusal_of(request.told, request.segment_id, flight_);
  if (!reason.empty()) {
    return reason;
  }
  if (!s.seen.pose) {
    return "no localizer has been heard yet, accepted: one that can be told";
  }
  forwarded_ = Forwarded{request, s.seen.pose->resets, s.now};
  if (climb_.state() == State::kWaitPose) {
    climb_.ask(Asked::kRelocalise);
  }
  return "";
}

std::optional<MissionAnswer> Mission::settle()
{
  if (!forwarded_) {
    return std::nullopt;
  }
  const Situation s = climb_.situation();
  const std::string doubt = doubt_of_told(s);
  const double waited_s = seconds_between(forwarded_->since, s.now);
  if (!doubt.empty() && waited_s >= 0.0 && waited_s <= s.params.relocalise_limit_s) {
    return std::nullopt;
  }
  const MissionRequest request = forwarded_->request;
  forwarded_.reset();
  const MissionAnswer answer{request.request_id, request.issuer, doubt.empty(), doubt};
  const auto known = std::find_if(answered_.begin(), answered_.end(), [&](const Answered & a) {
    return a.request.request_id == request.request_id && a.request.issuer == request.issuer;
  });
  if (known != answered_.end()) {
    known->answer = answer;
  }
  return answer;
}

std::string Mission::doubt_of_told(const Situation & s) const
{
  const auto & pose = s.seen.pose;
  const std::string within =
    " within " + stetro_config::to_text(s.params.relocalise_limit_s) + " s";
  if (!pose || pose->resets == forwarded_->resets) {
    return "the localizer has not taken the pose" + within + "; its log and diagnostics say why";
  }
  const int told = flight_.step_at(in_flight(forwarded_->request.told, flight_).x_m);
  const bool sure = pose->integrity != Integrity::kLost && (pose->reasons & kNotInitialised) == 0u;
  if (sure && pose->step == told) {
    return "";
  }
  return "the localizer took the pose, but is not on step " + std::to_string(told) + within +
         ": it says step " + std::to_string(pose->step) + ", " + reasons_in_words(pose->reasons) +
         "; do the blocks stand so?";
}

MissionStatus Mission::status() const
{
  const Situation s = climb_.situation();
  const MissionRecord & record = climb_.record();
  MissionStatus status;
  status.mission = mission_state(climb_);
  status.state = climb_.state();
  status.segment_id = climb_.geometry().segment_id;
  status.step = record.active ? record.step : s.pose_sound() ? s.seen.pose->step : -1;
  status.step_count = climb_.geometry().steps();
  for (std::size_t i = 0; i < record.swept.size(); ++i) {
    const double width = s.geometry.width_at_m(static_cast<int>(i) + 1);
    status.swept_share.push_back(record.swept[i].share(width, s.geometry.contact_width_m));
  }
  status.time_in_state_s = climb_.time_in_state_s();
  status.time_limit_s = climb_.time_limit_s();
  status.fault = climb_.fault();
  status.detail = climb_.note();
  return status;
}

}  // namespace stetro_supervisor
