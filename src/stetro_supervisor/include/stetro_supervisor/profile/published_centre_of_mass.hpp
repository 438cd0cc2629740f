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

#ifndef STETRO_SUPERVISOR__PROFILE__PUBLISHED_CENTRE_OF_MASS_HPP_
#define STETRO_SUPERVISOR__PROFILE__PUBLISHED_CENTRE_OF_MASS_HPP_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "stetro_site/profile_caster.hpp"
#include "stetro_supervisor/profile/profile_moments.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"

namespace stetro_supervisor
{

/// Moments of the profile, the triangles of beams without an echo left out.
/** A profile of less than a turn is closed through the scanner. */
[[nodiscard]] std::optional<ProfileMoments> moments_of(
  const Beams & beams, const std::vector<double> & ranges_m);

/// S-C eq. (8) with eq. (10) turned the right way (D5-4): K + R(psi) (c_model - c_robot).
/** Both centroids as seen from their scanners, in the scanner's axes; no arctangent is needed. */
[[nodiscard]] Eigen::Vector2d corrected_position(
  const ScannerPose & believed, const Eigen::Vector2d & model_centroid_m,
  const Eigen::Vector2d & robot_centroid_m);

/// When the published iteration ends.
struct PublishedLimits
{
  double reach_m = 30.0;    ///< of the model's beams
  double settled_m = 1e-3;  ///< a smaller step "varies marginally"
  int iterations = 20;
};

/// How the published iteration went.
struct PublishedSearch
{
  std::vector<Eigen::Vector2d> positions_m;  ///< after each step, as in S-C eq. (11)
  bool settled = false;  ///< the last step was marginal; it says nothing of the place being right
};

/// The paper's search for the scanner's position at a known heading, with no guard of its own.
/**
 * The model is scanned from where the robot is believed to be, the belief moves by the difference
 * of the centroids, and again until it stays. It ends early only where a profile has no area. The
 * yardstick for TrustedCentreOfMass: with obstacles it fails in one case of four (D5-9).
 */
[[nodiscard]] PublishedSearch published_search(
  const stetro_site::ProfileCaster & map, const Beams & scan, const ScannerPose & believed,
  const PublishedLimits & limits);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__PUBLISHED_CENTRE_OF_MASS_HPP_
