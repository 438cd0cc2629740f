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

#include "stetro_supervisor/floor/three_answers.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "stetro_site/frame_transform.hpp"

namespace stetro_supervisor
{
namespace
{

/// Of eq. (1), its root.
double sigmas_apart(const FloorPlace & told, const FloorPlace & profile)
{
  Eigen::Vector3d d;
  d << profile.position_m - told.position_m,
    stetro_site::wrap_angle(profile.yaw_rad - told.yaw_rad);
  const Eigen::Matrix3d both = told.covariance + profile.covariance;
  return std::sqrt(std::max(0.0, d.dot(both.ldlt().solve(d))));
}

std::string two_digits(double value)
{
  const std::string text = std::to_string(value);
  return text.substr(0, text.size() - 4);
}

Conclusion without_profile(const ThreeAnswers & answers)
{
  Conclusion conclusion;
  conclusion.verdict =
    answers.profile_verdict == Verdict::kAmbiguous ? Verdict::kAmbiguous : Verdict::kNoVerdict;
  const bool through_walls = answers.profile_reason == NoVerdictReason::kBeyondTheWalls;
  conclusion.reason = answers.profile_verdict == Verdict::kAmbiguous
                        ? "several places explain the scan"
                        : std::string("profile: ") + name_of(answers.profile_reason);
  conclusion.against_told = !answers.beams_allow_told || through_walls;
  if (!answers.beams_allow_told) {
    conclusion.reason += "; four beams exclude the told place";
  }
  return conclusion;
}

}  // namespace

Conclusion weigh(const ThreeAnswers & answers, double agree_sigmas)
{
  if (!answers.profile) {
    return without_profile(answers);
  }
  Conclusion conclusion;
  conclusion.distance = sigmas_apart(answers.told, *answers.profile);
  const bool borne_out =
    conclusion.distance <= agree_sigmas && answers.beams_allow_told && answers.beams_allow_profile;
  if (answers.by_ends && !borne_out) {
    return without_profile(answers);
  }
  if (!answers.beams_allow_profile) {
    conclusion.reason = "four beams exclude the place that the profile tells";
    conclusion.against_told = !answers.beams_allow_told;
    return conclusion;
  }
  const bool agrees = conclusion.distance <= agree_sigmas;
  conclusion.verdict = agrees ? Verdict::kAgrees : Verdict::kCorrected;
  conclusion.corrects = true;
  conclusion.against_told = !agrees;
  conclusion.reason = two_digits(conclusion.distance) + " standard deviations from what was told";
  conclusion.reason += answers.by_ends ? ", by the ends of the beams" : "";
  return conclusion;
}

}  // namespace stetro_supervisor
