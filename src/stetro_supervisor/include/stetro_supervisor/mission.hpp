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
#ifndef STETRO_SUPERVISOR__MISSION_HPP_
#define STETRO_SUPERVISOR__MISSION_HPP_

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stetro_site/flight.hpp"
#include "stetro_supervisor/climb.hpp"
#include "stetro_supervisor/journey.hpp"
#include "stetro_supervisor/told_pose.hpp"

namespace stetro_supervisor
{

enum class RequestKind : std::uint8_t {
  kUnknown,
  kCleanFlight,
  kGoToSegment,
  kRelocalise,
  kPause,
  kResume,
  kAbort,
  kClearFault,
  kCheckPose
};

struct MissionRequest
{
  std::string request_id;  ///< unique per issuer, not empty: the same id twice is one request
  std::string issuer;      ///< not empty
  RequestKind kind = RequestKind::kUnknown;
  std::string segment_id;  ///< for kCleanFlight, kGoToSegment and kRelocalise
  ToldPose told{};         ///< for kRelocalise
};

/// The answer echoes the request. Refused says why: what was found, what is accepted.
struct MissionAnswer
{
  std::string request_id;
  std::string issuer;
  bool accepted = false;
  std::string reason;  ///< empty when accepted
  bool waits = false;  ///< neither yet: `Mission::settle()` will answer
};

enum class MissionState : std::uint8_t {
  kIdle,
  kRunning,
  kPaused,
  kHeld,
  kFinished,
  kAborted,
  kFault
};

struct MissionStatus
{
  MissionState mission = MissionState::kIdle;
  State state = State::kIdle;  ///< of the climb
  std::string state_name;      ///< of whatever is at the wheel: the climb, or the drive on floors
  std::string segment_id;
  int step = -1;       ///< of the mission, else of the localizer; -1 unknown; 0 on floors
  int step_count = 0;  ///< 0 on floors
  std::vector<double> swept_share;  ///< of tread 1..N, 0 to 1
  double time_in_state_s = 0.0;
  double time_limit_s = 0.0;  ///< +inf where there is none
  Fault fault = Fault::kNone;
  std::string detail;  ///< why the robot stands, in words
};

/// Answers requests and says what the robot is doing.
/**
 * To check the pose is to compare the next scan that can be used with the map; it is accepted when
 * there is a scan and a pose on a drawn floor, and what comes of it is a report of the journey.
 *
 * A request is judged by the situation of the last tick and taken up by the next one. Going down
 * stairs is refused as not supported, and so is going to a segment over floors nobody has drawn.
 *
 * To relocalise is to tell the localizer a pose while nothing moves. Whoever owns the mission
 * forwards it when the answer waits; the answer comes from `settle()`, when the localizer's pose
 * has jumped and its blocks agree with the step that was told, or not within `limit.relocalise_s`.
 * Meanwhile nothing can be started or resumed, and a climb that waited for the pose is held: it
 * goes on when asked to, if then posture, step and mission agree (`rejoin.hpp`).
 */
class Mission
{
public:
  /// \param climb outlives the mission
  /// \param flight that it climbs, and that a told pose is judged by
  Mission(Climb & climb, stetro_site::Flight flight)
  : lone_climb_(&climb), flight_(std::move(flight))
  {
  }

  /// \param journey outlives the mission; its present flight is the one a request is judged by
  explicit Mission(Journey & journey) : journey_(&journey) {}

  /// Accepts or refuses; a request seen before gets the answer it got then and changes nothing.
  /**
   * Seen before means: the same id of the same issuer, for the same kind, segment and told pose. An
   * id that was used for another is refused, for the two cannot be told apart in an answer.
   */
  MissionAnswer request(const MissionRequest & request);

  /// Whether a request has been answered before and would only get that answer again.
  bool knows(const MissionRequest & request) const;

  /// The answer that waited, once: to be asked for after each tick.
  std::optional<MissionAnswer> settle();

  MissionStatus status() const;

private:
  struct Answered
  {
    MissionRequest request;
    MissionAnswer answer;
  };

  /// A told pose on its way to the localizer.
  struct Forwarded
  {
    MissionRequest request;
    std::uint32_t resets;  // of the localizer's pose before
    Time since;
  };

  Climb & climb() { return journey_ != nullptr ? journey_->climb() : *lone_climb_; }
  const Climb & climb() const { return journey_ != nullptr ? journey_->climb() : *lone_climb_; }
  const stetro_site::Flight & flight() const
  {
    return journey_ != nullptr ? journey_->flight() : *flight_;
  }
  bool drives() const { return journey_ != nullptr && journey_->drives(); }
  bool is_busy() const;
  MissionState mission_state() const;
  std::string known_flights() const;
  MissionRecord record() const;
  std::string state_name() const;
  void ask(Asked asked);

  const Answered * find(const MissionRequest & request) const;
  MissionAnswer answer_new(const MissionRequest & request);
  std::string refusal(const MissionRequest & request);
  std::string refuse_clean(const MissionRequest & request);
  std::string refuse_to_go(const MissionRequest & request);
  std::string refuse_relocalise(const MissionRequest & request);
  std::string refuse_told(const MissionRequest & request) const;
  const DrawnFloor * told_floor(const MissionRequest & request) const;  // null: told on a flight
  std::string doubt_of_told(const Situation & s) const;  // that the localizer has followed
  std::string refuse_pause() const;
  std::string refuse_resume() const;
  std::string refuse_abort() const;
  std::string refuse_clear() const;
  std::string refuse_check();

  Climb * lone_climb_ = nullptr;               // one of these two
  Journey * journey_ = nullptr;                //
  std::optional<stetro_site::Flight> flight_;  // of the lone climb
  std::optional<Forwarded> forwarded_;
  std::deque<Answered> answered_;  // the last ones, for duplicates
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__MISSION_HPP_
