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

#include "stetro_supervisor/rejoin.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr std::size_t kAnswersKept = 256;

constexpr char kIdReused[] = "request_id was used for another request";

bool same_matter(const MissionRequest & a, const MissionRequest & b)
{
  return a.kind == b.kind && a.segment_id == b.segment_id;
}

bool is_free(State state)
{
  return state == State::kIdle || state == State::kAborted || state == State::kFinished;
}

bool emergency_stop_closed(const Situation & s)
{
  return s.seen.contacts && s.seen.contacts->emergency_stop.state != ContactState::kOpen;
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
  answer.accepted = answer.reason.empty();
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
      return "relocalising is not supported yet";
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
