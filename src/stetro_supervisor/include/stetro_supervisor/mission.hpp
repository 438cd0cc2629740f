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
#include <string>
#include <vector>

#include "stetro_supervisor/climb.hpp"

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
  kClearFault
};

struct MissionRequest
{
  std::string request_id;  ///< unique per issuer, not empty: the same id twice is one request
  std::string issuer;      ///< not empty
  RequestKind kind = RequestKind::kUnknown;
  std::string segment_id;  ///< for kCleanFlight
};

/// The answer echoes the request. Refused says why: what was found, what is accepted.
struct MissionAnswer
{
  std::string request_id;
  std::string issuer;
  bool accepted = false;
  std::string reason;  ///< empty when accepted
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
  State state = State::kIdle;
  std::string segment_id;
  int step = -1;  ///< of the mission, else of the localizer; -1 unknown
  int step_count = 0;
  std::vector<double> swept_share;  ///< of tread 1..N, 0 to 1
  double time_in_state_s = 0.0;
  double time_limit_s = 0.0;  ///< +inf where there is none
  Fault fault = Fault::kNone;
  std::string detail;  ///< why the robot stands, in words
};

/// Answers requests and says what the robot is doing.
/**
 * A request is judged by the situation of the last tick and taken up by the next one. Going down
 * stairs, going to another segment and relocalising are refused as not supported.
 */
class Mission
{
public:
  /// \param climb outlives the mission
  explicit Mission(Climb & climb) : climb_(climb) {}

  /// Accepts or refuses; a request seen before gets the answer it got then and changes nothing.
  /**
   * Seen before means: the same id of the same issuer, for the same kind and segment. An id that
   * was used for another kind or segment is refused, for the two cannot be told apart in an answer.
   */
  MissionAnswer request(const MissionRequest & request);

  /// Whether a request has been answered before and would only get that answer again.
  bool knows(const MissionRequest & request) const;

  MissionStatus status() const;

private:
  struct Answered
  {
    MissionRequest request;
    MissionAnswer answer;
  };

  const Answered * find(const MissionRequest & request) const;
  MissionAnswer answer_new(const MissionRequest & request);
  std::string refusal(const MissionRequest & request);
  std::string refuse_clean(const MissionRequest & request);
  std::string refuse_pause() const;
  std::string refuse_resume() const;
  std::string refuse_abort() const;
  std::string refuse_clear() const;

  Climb & climb_;
  std::deque<Answered> answered_;  // the last ones, for duplicates
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__MISSION_HPP_
