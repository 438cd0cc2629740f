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

#ifndef STETRO_SUPERVISOR__PROFILE__SCAN_CHECK_HPP_
#define STETRO_SUPERVISOR__PROFILE__SCAN_CHECK_HPP_

#include <memory>

#include "stetro_site/distance_field.hpp"
#include "stetro_site/profile_caster.hpp"
#include "stetro_supervisor/profile/beam_noise.hpp"
#include "stetro_supervisor/profile/determination.hpp"
#include "stetro_supervisor/profile/end_matching.hpp"
#include "stetro_supervisor/profile/profile_finding.hpp"
#include "stetro_supervisor/profile/trusted_centre_of_mass.hpp"
#include "stetro_supervisor/profile/usability_layer.hpp"

namespace stetro_supervisor
{

/// What a place found by the ends of the beams must hold to be believed.
struct EndTrustParams
{
  double on_wall_share = 0.70;  ///< least, of the ends
  /// Least: what any place elsewhere leaves unexplained, by what the best one does.
  double rival_ratio = 1.3;
  double rival_margin = 0.04;  ///< least, of the likelihood, by which the best one is better
  double map_sigma_m = 0.025;  ///< of the map as a whole, added to the position's covariance
  double map_sigma_rad = 0.01;
};

/// How a lidar is checked against the map of a floor that people use.
struct ScanCheckParams
{
  BeamNoise noise;
  TrustParams trust;
  DescentParams descent;
  EndMatchingParams ends;
  EndTrustParams end_trust;
  DeterminationParams determination;
  /// The map's bound is the worst of the place found and of those this far to its four sides [m].
  double beside_m = 0.02;
};

/// A lidar, and how its floor is drawn.
struct ScanSetup
{
  double range_sigma_m = 0.02;  ///< of one range
  double reach_m = 12.0;        ///< of a beam
  double map_sigma_m = 0.0;     ///< of the walls that were drawn or mapped, across them
  double resolution_m = 0.0;    ///< of a map of cells; 0: drawn walls
};

/// How such a lidar is checked on such a floor.
/**
 * TrustParams and DescentParams by themselves are for a map that is exact to its stated error. A
 * map of cells errs by its cells as well, evenly within one, and its walls are stairs.
 */
[[nodiscard]] ScanCheckParams scan_check_params(const ScanSetup & setup);

/// The same for a lidar of 12 m on a map of cells, or of drawn walls (`resolution_m` 0).
/** The map's bound is asked for walls as they are known at best, wherever they are drawn. */
[[nodiscard]] ScanCheckParams scan_check_params(double resolution_m);

/// The check of a pose on a floor as it is used: profiles first, then the ends of the beams.
/**
 *  1. TrustedCentreOfMass: exact, and sure of itself, where the floor is as it was mapped.
 *  2. Where its profiles do not compare, as too much has changed, EndMatching: a place where most
 *     ends lie on walls, clearly better than any other of the area.
 *  3. What the map says of the place that was found and beside it (determination): along the
 *     direction that is told worst, the covariance is never less than the map's own bound. A scan
 *     on a map of cells would find one in the steps of its walls. A place found by the ends, which
 *     tell less, is that much worse along this direction, too (stretched).
 *
 * Keeps its memory from check to check; for one thread.
 */
class ScanCheck
{
public:
  /// \param walls for the ends; null: profiles only
  /// \param layer tells the finding's spectral radius; null: not asked
  ScanCheck(
    const stetro_site::ProfileCaster & map, FreeSpace is_free,
    std::shared_ptr<const stetro_site::DistanceField> walls, const ScanCheckParams & params,
    std::shared_ptr<const UsabilityLayer> layer);

  /// Works out the beams' directions ahead of the first scan.
  void prepare(const stetro_site::BeamFan & fan) { trusted_.prepare(fan); }

  [[nodiscard]] ProfileFinding check(const RangeProfile & scan, const Belief & belief);

private:
  void ask_ends(const RangeProfile & scan, const Belief & belief, ProfileFinding & finding) const;
  [[nodiscard]] Determination told_about(const Eigen::Vector2d & at) const;

  const stetro_site::ProfileCaster & map_;
  FreeSpace is_free_;
  ScanCheckParams params_;
  TrustedCentreOfMass trusted_;
  std::unique_ptr<const EndMatching> ends_;
  std::shared_ptr<const UsabilityLayer> layer_;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__SCAN_CHECK_HPP_
