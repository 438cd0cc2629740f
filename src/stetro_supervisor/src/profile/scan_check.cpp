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

#include "stetro_supervisor/profile/scan_check.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace stetro_supervisor
{
namespace
{

/// Headings are searched this many standard deviations about the believed one.
constexpr double kYawSigmas = 3.0;
constexpr double kCellSigma = 0.3;  // of an even error within a cell, 1 / sqrt(12), in cells

/// Why a check of the profiles may fail at a right place: the floor is not as it was mapped.
bool is_for_the_ends(NoVerdictReason reason)
{
  return reason == NoVerdictReason::kNotExplained || reason == NoVerdictReason::kBeyondTheWalls ||
         reason == NoVerdictReason::kOneDirection || reason == NoVerdictReason::kNearMisses ||
         reason == NoVerdictReason::kNoise || reason == NoVerdictReason::kOutOfSearch;
}

}  // namespace

ScanCheckParams scan_check_params(const ScanSetup & setup)
{
  ScanCheckParams params;
  params.noise.range_sigma_m = setup.range_sigma_m;
  params.noise.map_sigma_m = std::hypot(setup.map_sigma_m, kCellSigma * setup.resolution_m);
  params.noise.wall_correlation_m = 0.5;
  params.descent.reach_m = setup.reach_m;
  params.descent.wall_baseline_m = 6.0 * setup.resolution_m;
  params.determination.reach_m = setup.reach_m;
  params.determination.noise = params.noise;
  return params;
}

ScanCheckParams scan_check_params(double resolution_m)
{
  ScanSetup setup;
  setup.resolution_m = resolution_m;
  ScanCheckParams params = scan_check_params(setup);
  params.determination.noise = DeterminationParams{}.noise;
  return params;
}

ScanCheck::ScanCheck(
  const stetro_site::ProfileCaster & map, FreeSpace is_free,
  std::shared_ptr<const stetro_site::DistanceField> walls, const ScanCheckParams & params,
  std::shared_ptr<const UsabilityLayer> layer)
: map_(map),
  is_free_(std::move(is_free)),
  params_(params),
  trusted_(map, is_free_, params.noise, params.trust, params.descent),
  ends_(walls ? std::make_unique<const EndMatching>(std::move(walls), params.ends) : nullptr),
  layer_(std::move(layer))
{
}

ProfileFinding ScanCheck::check(const RangeProfile & scan, const Belief & belief)
{
  ProfileFinding finding = trusted_.check(scan, belief);
  if (ends_ && finding.verdict == Verdict::kNoVerdict && is_for_the_ends(finding.reason)) {
    ask_ends(scan, belief, finding);
  }
  if (finding.verdict == Verdict::kNoVerdict) {
    return finding;
  }
  const Eigen::Vector2d & at = finding.best.pose.position_m;
  const Determination told = told_about(at);
  if (finding.by_ends) {
    finding.best.covariance = stretched(finding.best.covariance, told);
  }
  finding.best.covariance = widened(finding.best.covariance, told, 0.0);
  if (const Usability * place = layer_ ? layer_->at(at) : nullptr) {
    finding.spectral_radius = place->spectral_radius;
  }
  return finding;
}

Determination ScanCheck::told_about(const Eigen::Vector2d & at) const
{
  Determination worst = determination(map_, at, params_.determination);
  const double d = params_.beside_m;
  for (const Eigen::Vector2d & side :
       {Eigen::Vector2d(d, 0.0), Eigen::Vector2d(0.0, d), Eigen::Vector2d(-d, 0.0),
        Eigen::Vector2d(0.0, -d)}) {
    if (is_free_(at + side)) {
      const Determination told = determination(map_, at + side, params_.determination);
      worst = told.worst_sigma_m > worst.worst_sigma_m ? told : worst;
    }
  }
  return worst;
}

void ScanCheck::ask_ends(
  const RangeProfile & scan, const Belief & belief, ProfileFinding & finding) const
{
  SearchArea area = belief.area;
  area.yaw_half_width_rad = std::max(area.yaw_half_width_rad, kYawSigmas * belief.yaw_sigma_rad);
  const auto matches = ends_->matches(Beams(scan), area, params_.descent.reach_m);
  const EndTrustParams & trust = params_.end_trust;
  if (matches.empty() || matches[0].on_wall_share < trust.on_wall_share) {
    return;  // the profiles' reason stands
  }
  const EndMatch & best = matches[0];
  finding.of_profiles = finding.reason;
  finding.by_ends = true;
  finding.best.pose = best.pose;
  finding.expected.reset();  // of profiles that do not compare
  finding.measured.reset();
  for (std::size_t i = 1; i < matches.size(); ++i) {
    const double unexplained = 1.0 - matches[i].likelihood;
    if (
      unexplained < trust.rival_ratio * (1.0 - best.likelihood) ||
      best.likelihood - matches[i].likelihood < trust.rival_margin) {
      finding.reason = NoVerdictReason::kRival;
      return;
    }
  }
  const double map_m2 = trust.map_sigma_m * trust.map_sigma_m;
  const Eigen::Vector3d of_the_map(map_m2, map_m2, trust.map_sigma_rad * trust.map_sigma_rad);
  const Eigen::Matrix3d stiff = 1e-6 * Eigen::Matrix3d::Identity();
  finding.best.covariance = (best.information + stiff).inverse();
  finding.best.covariance.diagonal() += of_the_map;
  const double moved_m = (best.pose.position_m - belief.area.around.position_m).norm();
  if (moved_m > belief.area.radius_m) {
    finding.reason = NoVerdictReason::kOutOfSearch;
    return;
  }
  if (largest_sigma_m(finding.best.covariance) > params_.trust.largest_sigma_m) {
    finding.reason = NoVerdictReason::kDirectionFree;
    return;
  }
  finding.reason = finding.best.refused = NoVerdictReason::kNone;
  finding.verdict =
    moved_m <= params_.descent.agrees_within_m ? Verdict::kAgrees : Verdict::kCorrected;
}

}  // namespace stetro_supervisor
