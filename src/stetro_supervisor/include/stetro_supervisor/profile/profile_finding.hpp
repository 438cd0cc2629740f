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

#ifndef STETRO_SUPERVISOR__PROFILE__PROFILE_FINDING_HPP_
#define STETRO_SUPERVISOR__PROFILE__PROFILE_FINDING_HPP_

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "stetro_supervisor/profile/beam_comparison.hpp"
#include "stetro_supervisor/profile/profile_moments.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"

namespace stetro_supervisor
{

/// What the profile says of the believed pose.
enum class Verdict {
  kAgrees,     ///< the believed pose is right, within what was allowed
  kCorrected,  ///< another pose is, and no other
  kAmbiguous,  ///< several poses explain the scan
  kNoVerdict   ///< nothing can be said, see the reason
};

/// Why there is no verdict.
enum class NoVerdictReason {
  kNone,
  kFewBeams,        ///< too few ranges to say anything
  kNotExplained,    ///< no place was found where enough beams agree with the map
  kBeyondTheWalls,  ///< beams pass through walls of the map: it has changed, or is another floor
  kOneDirection,    ///< the agreement is along one direction only, as in a corridor
  kNearMisses,      ///< too many beams miss their wall narrowly: the place is a little off
  kNoise,           ///< the beams that agree scatter more than was stated
  kRival,           ///< another place explains as much and is not determined itself
  kDirectionFree,   ///< a direction of the place is known worse than is allowed
  kOutOfSearch      ///< the place found lies outside the area that was to be searched
};

[[nodiscard]] const char * name_of(Verdict verdict);
[[nodiscard]] const char * name_of(NoVerdictReason reason);

/// A place that was looked at closely.
struct ExplainedPlace
{
  ScannerPose pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< floor's axes, (x, y, psi)
  BeamComparison beams;
  NoVerdictReason refused = NoVerdictReason::kNotExplained;  ///< kNone: it explains the scan
};

/// A covariance of (x, y, psi) in the scanner's axes, in the floor's.
[[nodiscard]] Eigen::Matrix3d turned(const Eigen::Matrix3d & covariance, double yaw_rad);

/// Standard deviation of the position in its worst direction [m].
[[nodiscard]] double largest_sigma_m(const Eigen::Matrix3d & covariance);

/// Two looks ended at one pose: nearer to each other than six standard deviations.
[[nodiscard]] bool are_one(const ExplainedPlace & a, const ExplainedPlace & b);

/// The answer to one check of a pose.
struct ProfileFinding
{
  Verdict verdict = Verdict::kNoVerdict;
  NoVerdictReason reason = NoVerdictReason::kNotExplained;
  /// The best place that was found; whether it may be used, the verdict says.
  ExplainedPlace best;
  /// The other poses, where the verdict is kAmbiguous.
  std::vector<ScannerPose> alternatives;
  /// Of the map and of the scan, in the scanner's axes at the best pose, beams that do not agree
  /// left out of both.
  std::optional<ProfileMoments> expected;
  std::optional<ProfileMoments> measured;
  double valid_share = 0.0;  ///< of the beams, with a range
  int casts = 0;             ///< profiles cast on the map, whole or thinned
  /// Of a guarded centroid step at the best pose, by the map: below 1 it comes home from nearby.
  /// Nothing without a UsabilityLayer, or where it was not asked.
  std::optional<double> spectral_radius;
  bool by_ends = false;  ///< the profiles do not compare, the ends of the beams lie on walls
  NoVerdictReason of_profiles = NoVerdictReason::kNone;  ///< why they do not, where ends were asked
  bool searched = false;  ///< the way from the believed pose did not do: all places were tried
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__PROFILE_FINDING_HPP_
