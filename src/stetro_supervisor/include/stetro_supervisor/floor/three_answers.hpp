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

#ifndef STETRO_SUPERVISOR__FLOOR__THREE_ANSWERS_HPP_
#define STETRO_SUPERVISOR__FLOOR__THREE_ANSWERS_HPP_

#include <optional>
#include <string>

#include "stetro_supervisor/floor/floor_place.hpp"
#include "stetro_supervisor/profile/profile_finding.hpp"

namespace stetro_supervisor
{

/// Where the robot is on a floor, asked three ways about one scan.
struct ThreeAnswers
{
  FloorPlace told;  ///< by the localizer
  Verdict profile_verdict = Verdict::kNoVerdict;
  NoVerdictReason profile_reason = NoVerdictReason::kNone;
  std::optional<FloorPlace> profile;  ///< by the centre of mass, where that has one place
  bool by_ends = false;               ///< by the ends of the beams instead: profiles do not compare
  bool beams_allow_told = true;       ///< the four-beam search does not exclude it
  bool beams_allow_profile = true;
};

/// What they say together.
struct Conclusion
{
  Verdict verdict = Verdict::kNoVerdict;
  std::string reason;         ///< of the verdict, in words
  bool corrects = false;      ///< the profile's place is worth telling the localizer
  bool against_told = false;  ///< what was told is wrong, as far as this scan tells
  double distance = 0.0;      ///< of told from profile [standard deviations]; 0 without a profile
};

/// Combines the three, each with its own error.
/**
 * Told pose t with covariance T, profile p with P: with d = p - t they agree if
 *
 *   d' (T + P)^-1 d <= agree_sigmas^2                                                        (1)
 *
 * The four beams answer with a set, so they agree or exclude. The ends of the beams can bear out
 * what was told on a floor that has changed, where profiles do not compare; alone they contradict
 * nothing, as they do not ask what the beams should not have seen through.
 *
 *   profile            beams                  verdict                       against what was told
 *   agrees, (1)        allow the profile      agrees: the profile is told   no
 *   elsewhere          allow the profile      corrected: it is told         yes
 *   one place          exclude the profile    none: two answers contradict  if they exclude it too
 *   by ends, agrees    allow both             agrees: it is told            no
 *   by ends otherwise  as none
 *   several, none      allow what was told    ambiguous, none               no, unless beams of the
 *                                                                           scan pass through walls
 *   several, none      exclude it             ambiguous, none               yes
 */
[[nodiscard]] Conclusion weigh(const ThreeAnswers & answers, double agree_sigmas);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__THREE_ANSWERS_HPP_
