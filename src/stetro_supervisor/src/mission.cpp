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
#include "stetro_supervisor/floor/floor_place.hpp"
#include "stetro_supervisor/pose_reason.hpp"

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

bool starts_something(RequestKind kind)
{
  return kind == RequestKind::kCleanFlight || kind == RequestKind::kResume ||
         kind == RequestKind::kRelocalise;
}

MissionState state_of_climb(const Climb & climb)
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

MissionState state_of_drive(const Journey & journey)
{
  if (journey.part() == Part::kDone || journey.part() == Part::kAborted) {
    return journey.part() == Part::kDone ? MissionState::kFinished : MissionState::kAborted;
  }
  switch (journey.drive().state()) {
    case DriveState::kPaused:
      return MissionState::kPaused;
    case DriveState::kHeld:
    case DriveState::kWaitPose:
      return MissionState::kHeld;
    case DriveState::kFault:
      return MissionState::kFault;
    default:
      return MissionState::kRunning;
  }
}

}  // namespace

MissionState Mission::mission_state() const
{
  return drives() ? state_of_drive(*journey_) : state_of_climb(climb());
}

std::string Mission::state_name() const
{
  if (!drives()) {
    return to_string(climb().state());
  }
  switch (mission_state()) {
    case MissionState::kFinished:
      return to_string(State::kFinished);
    case MissionState::kAborted:
      return to_string(State::kAborted);
    default:
      return to_string(journey_->drive().state());
  }
}

MissionRecord Mission::record() const
{
  return journey_ != nullptr ? journey_->record() : climb().record();
}

void Mission::ask(Asked asked)
{
  if (!drives()) {
    climb().ask(asked);
  } else if (asked == Asked::kResume) {
    journey_->resume_drive();
  } else {
    journey_->drive().ask(asked);
  }
}

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
  const MissionRecord record = this->record();
  if (record.active && record.request_id == request.request_id && record.issuer == request.issuer) {
    // the id of the request that started this mission, before a restart
    const bool goes = !record.goal.empty();
    const MissionRequest start{
      record.request_id, record.issuer,
      goes ? RequestKind::kGoToSegment : RequestKind::kCleanFlight,
      goes ? record.goal : record.segment_id};
    return same_matter(start, request) ? "" : kIdReused;
  }
  if (climb().is_asked() || (drives() && journey_->drive().is_asked())) {
    return "another request is being taken up, ask again";
  }
  if (forwarded_ && starts_something(request.kind)) {
    return "the localizer is being told a pose by request '" + forwarded_->request.request_id +
           "', ask again when that is answered";
  }
  const auto judge = [this](const std::string & reason, Asked asked) {
    if (reason.empty()) {
      ask(asked);
    }
    return reason;
  };
  switch (request.kind) {
    case RequestKind::kCleanFlight:
      return refuse_clean(request);
    case RequestKind::kGoToSegment:
      return refuse_to_go(request);
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
    case RequestKind::kCheckPose:
      return refuse_check();
    default:
      return "unknown kind of request";
  }
}

std::optional<MissionAnswer> Mission::settle()
{
  if (!forwarded_) {
    return std::nullopt;
  }
  const Situation s = climb().situation();
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
  const bool sure = pose->integrity != Integrity::kLost && (pose->reasons & kNotInitialised) == 0u;
  if (const DrawnFloor * floor = told_floor(forwarded_->request)) {
    const auto place = place_on_floor(*pose, journey_->site());
    return sure && place && place->floor_id == floor->id()
             ? ""
             : "the localizer took the pose, but is on '" + pose->segment_id + "'" + within + ": " +
                 reasons_in_words(pose->reasons);
  }
  const int told = flight().step_at(in_flight(forwarded_->request.told, flight()).x_m);
  if (sure && pose->step == told) {
    return "";
  }
  return "the localizer took the pose, but is not on step " + std::to_string(told) + within +
         ": it says step " + std::to_string(pose->step) + ", " + reasons_in_words(pose->reasons) +
         "; do the blocks stand so?";
}

MissionStatus Mission::status() const
{
  const MissionRecord record = this->record();
  MissionStatus status;
  status.mission = mission_state();
  status.state = climb().state();
  status.state_name = state_name();
  if (drives()) {
    const FloorDrive & drive = journey_->drive();
    status.segment_id = journey_->segment();
    status.step = 0;
    status.time_in_state_s = drive.time_in_state_s();
    status.time_limit_s = drive.time_limit_s();
    status.fault = drive.fault();
    status.detail = drive.note();
    return status;
  }
  const Situation s = climb().situation();
  status.segment_id = climb().geometry().segment_id;
  status.step = record.active ? record.step : s.pose_sound() ? s.seen.pose->step : -1;
  status.step_count = climb().geometry().steps();
  for (std::size_t i = 0; i < record.swept.size(); ++i) {
    const double width = s.geometry.width_at_m(static_cast<int>(i) + 1);
    status.swept_share.push_back(record.swept[i].share(width, s.geometry.contact_width_m));
  }
  status.time_in_state_s = climb().time_in_state_s();
  status.time_limit_s = climb().time_limit_s();
  status.fault = climb().fault();
  status.detail = climb().note();
  return status;
}

}  // namespace stetro_supervisor
