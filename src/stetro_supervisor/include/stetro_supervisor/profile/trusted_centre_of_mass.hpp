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

#ifndef STETRO_SUPERVISOR__PROFILE__TRUSTED_CENTRE_OF_MASS_HPP_
#define STETRO_SUPERVISOR__PROFILE__TRUSTED_CENTRE_OF_MASS_HPP_

#include <cstddef>
#include <optional>
#include <vector>

#include "stetro_site/profile_caster.hpp"
#include "stetro_supervisor/profile/beam_comparison.hpp"
#include "stetro_supervisor/profile/beam_noise.hpp"
#include "stetro_supervisor/profile/place_search.hpp"
#include "stetro_supervisor/profile/profile_alignment.hpp"
#include "stetro_supervisor/profile/profile_finding.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"
#include "stetro_supervisor/profile/wall_view.hpp"

namespace stetro_supervisor
{

/// What a finding must hold to be believed.
struct TrustParams
{
  double gate = 3.5;             ///< standard deviations within which a beam agrees
  double speaking_share = 0.2;   ///< least, of all beams: that say something of the place
  double agreeing_share = 0.75;  ///< least, of the beams that speak
  double direction_share = 0.4;  ///< least, of the evidence in any direction
  /// Most, of beams through walls of the map: for a map that is exact to its stated error. Where
  /// furniture moves, some times as many.
  double longer_share = 0.005;
  /// Most, of beams that miss their wall narrowly: what stands before a wall does so by more, and a
  /// place a little off makes such misses of all its walls of one direction.
  double near_share = 0.04;
  double chi_square = 2.0;       ///< most, mean of the agreeing beams
  double largest_sigma_m = 1e9;  ///< most, of the position in its worst direction
  /// From here on the way from the believed pose is believed without a look at all other places.
  double plain_share = 0.97;
  /// Beams through walls by which a place must be worse than another to be ruled out by it. Beams
  /// that end before a wall rule nothing out: an unknown box can stand where it looks like one.
  double tell_apart = 2.0;
};

/// How the search goes.
struct DescentParams
{
  double reach_m = 30.0;         ///< of a beam, on the map
  double wall_baseline_m = 0.0;  ///< see WallView; some cells on a grid, 0 on drawn walls
  int centroid_steps = 3;
  int alignment_steps = 10;
  std::size_t descent_beams = 100;
  std::size_t search_beams = 72;
  double search_spacing = 0.05;  ///< of the square root of the profile's area
  std::size_t search_places = 4000;
  std::size_t search_kept = 12;
  double agrees_within_m = 0.05;  ///< of the believed pose: the verdict is kAgrees
};

/// The believed pose, and how far from it the scanner may be.
struct Belief
{
  SearchArea area;
  double yaw_sigma_rad = 0.0;  ///< of the heading within a search step; 0: known exactly
};

/// S-C's cross-check of a pose with a guard at each step.
/**
 *  1. Centroid steps, eq. (8), from the believed pose: limited, never out of free space, ranges
 *     beyond a common cap cut off on both sides, so that a beam through a door does not decide.
 *  2. ProfileAlignment from the best of them, beam by beam.
 *  3. The beams that agree give pose and covariance; the comparison must hold TrustParams.
 *  4. If it does not, or others might, all places of the area are tried (likely_places), the best
 *     refined as in 2 and 3, and compared: one explains, several do, none does.
 *
 * Keeps its memory from check to check; for one thread.
 */
class TrustedCentreOfMass
{
public:
  TrustedCentreOfMass(
    const stetro_site::ProfileCaster & map, FreeSpace is_free, const BeamNoise & noise,
    const TrustParams & trust, const DescentParams & descent);

  /// Works out the beams' directions ahead of the first scan; check() does it when they change.
  void prepare(const stetro_site::BeamFan & fan);

  [[nodiscard]] ProfileFinding check(const RangeProfile & scan, const Belief & belief);

private:
  struct Scans;

  ScannerPose descend_by_centroid(const Scans & scans, const ScannerPose & from);
  /// The step, or the part of it that ends in free space; nothing if none does.
  std::optional<ScannerPose> free_step(
    const ScannerPose & from, const Eigen::Vector3d & step) const;
  /// A place speaks against believing the best one, be it determined itself or not.
  bool rivals(const BeamComparison & a, const BeamComparison & best) const;
  std::optional<ScannerPose> align(
    const Scans & scans, const Beams & scan, const ScannerPose & from, const HeadingPrior & prior);
  /// Where some beams end on strangers, others may, that pass for a wall: as many and off by a
  /// gate, they would move the place this much.
  Eigen::Matrix3d pull_of_strangers(
    const Scans & scans, const BeamComparison & beams, const HeadingPrior & prior) const;
  ExplainedPlace settle(const Scans & scans, const ScannerPose & from, const HeadingPrior & prior);
  ExplainedPlace explore(const Scans & scans, const ScannerPose & from, const Belief & belief);
  /// Where the beams that do not agree would have the place: they may be the walls, and what agrees
  /// an unknown box that looks like one.
  ExplainedPlace ask_strangers(
    const Scans & scans, const ExplainedPlace & best, const Belief & belief);
  void judge(const Belief & belief, ExplainedPlace & place) const;
  void search(const Scans & scans, const Belief & belief, ProfileFinding & finding);
  void conclude(const Scans & scans, const Belief & belief, ProfileFinding & finding);

  const stetro_site::ProfileCaster & map_;
  FreeSpace is_free_;
  BeamNoise noise_;
  TrustParams trust_;
  DescentParams descent_;
  WallView view_;
  ProfileAlignment alignment_;
  std::optional<Beams> last_scan_;  ///< its beams' directions serve the next scan
  int casts_ = 0;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__TRUSTED_CENTRE_OF_MASS_HPP_
