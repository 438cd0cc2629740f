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

#include "stetro_supervisor/profile/trusted_centre_of_mass.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "capped_profile.hpp"
#include "stetro_supervisor/profile/circular_misfit.hpp"
#include "stetro_supervisor/profile/contraction.hpp"
#include "stetro_supervisor/profile/published_centre_of_mass.hpp"

namespace stetro_supervisor
{

/// One scan at the three finenesses that are worked with.
struct TrustedCentreOfMass::Scans
{
  const Beams & whole;
  Beams descent;
  double size_m;  ///< square root of the profile's area
  double cap_m;   ///< ranges beyond it are cut off in centroids
};

namespace
{

/// Differences beyond this share of the profile's size count alike when a centroid step is judged.
constexpr double kMisfitCap = 0.2;
/// A centroid step is no longer than this share of the profile's size.
constexpr double kLongestStep = 0.5;
/// A centroid step shorter than this share of the profile's size is the last.
constexpr double kShortestStep = 0.02;
/// Distance from the walls, of the profile's size, that an alignment begins with.
constexpr double kFirstScale = 0.03;
/// An alignment that ends with fewer beams agreeing is not worth another from where it ended.
constexpr double kPromising = 0.4;
/// Weight of a beam that agrees, when those that do not are asked for another place.
constexpr double kSayOfTheAgreeing = 0.1;
/// A place where fewer beams agree is left at once.
constexpr double kHopeless = 0.3;
/// The last step of all beams together, in its own standard deviations. At a known heading more is
/// allowed where nearly all beams agree, as then the next step would start from the same beams.
constexpr double kLastStep = 0.5;
constexpr double kPlainStep = 4.0;
constexpr int kSettlingSteps = 6;
/// Alignments from one start: the scale of the first may shrink before the last wall is in place.
constexpr int kAttempts = 3;

}  // namespace

TrustedCentreOfMass::TrustedCentreOfMass(
  const stetro_site::ProfileCaster & map, FreeSpace is_free, const BeamNoise & noise,
  const TrustParams & trust, const DescentParams & descent)
: map_(map),
  is_free_(std::move(is_free)),
  noise_(noise),
  trust_(trust),
  descent_(descent),
  view_(descent.reach_m, descent.wall_baseline_m),
  alignment_(3.0 * std::hypot(noise.range_sigma_m, noise.map_sigma_m))
{
}

ScannerPose TrustedCentreOfMass::descend_by_centroid(const Scans & scans, const ScannerPose & from)
{
  const Beams & scan = scans.descent;
  const auto robot = capped_moments(scan, scan.ranges_m(), scans.cap_m);
  ScannerPose at = from;
  ScannerPose best = from;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; robot; ++i) {
    view_.look(map_, scan, at);
    ++casts_;
    const double misfit =
      circular_misfit(scan.ranges_m(), view_.ranges_m(), 0, kMisfitCap * scans.size_m);
    if (misfit < least) {
      least = misfit;
      best = at;
    }
    const auto model = capped_moments(scan, view_.ranges_m(), scans.cap_m);
    if (!model || i == descent_.centroid_steps) {
      break;
    }
    Eigen::Vector2d step =
      corrected_position(at, model->centroid_m, robot->centroid_m) - at.position_m;
    const double length = step.norm();
    step *= std::min(1.0, kLongestStep * scans.size_m / length);
    for (int halved = 0; halved < 3 && !is_free_(at.position_m + step); ++halved) {
      step *= 0.5;
    }
    if (length < kShortestStep * scans.size_m || !is_free_(at.position_m + step)) {
      break;
    }
    at.position_m += step;
  }
  return best;
}

std::optional<ScannerPose> TrustedCentreOfMass::free_step(
  const ScannerPose & from, const Eigen::Vector3d & step) const
{
  for (double part = 1.0; part > 0.1; part *= 0.5) {
    const ScannerPose next = moved(from, part * step);
    if (is_free_(next.position_m)) {
      return next;
    }
  }
  return std::nullopt;
}

std::optional<ScannerPose> TrustedCentreOfMass::align(
  const Scans & scans, const Beams & scan, const ScannerPose & from, const HeadingPrior & prior)
{
  ScannerPose at = from;
  alignment_.restart(kFirstScale * scans.size_m);
  for (int i = 0; i < descent_.alignment_steps; ++i) {
    view_.look(map_, scan, at);
    ++casts_;
    view_.find_walls(scan);
    const auto step = alignment_.step(scan, view_, prior, at.yaw_rad);
    if (!step || step->head<2>().norm() > kLongestStep * scans.size_m) {
      return std::nullopt;
    }
    const auto next = free_step(at, *step);
    if (!next) {
      break;
    }
    at = *next;
    if (alignment_.fits() && step->head<2>().norm() < 0.3 * noise_.range_sigma_m) {
      break;
    }
  }
  return at;
}

Eigen::Matrix3d TrustedCentreOfMass::pull_of_strangers(
  const Scans & scans, const BeamComparison & beams, const HeadingPrior & prior) const
{
  const double sigma = std::hypot(noise_.range_sigma_m, noise_.map_sigma_m);
  const double pull_m = trust_.gate * sigma * (1.0 - beams.agreeing_share());
  const double turn_rad = prior.sigma_rad > 0.0 ? pull_m / scans.size_m : 0.0;
  return Eigen::Vector3d(pull_m * pull_m, pull_m * pull_m, turn_rad * turn_rad).asDiagonal();
}

ExplainedPlace TrustedCentreOfMass::settle(
  const Scans & scans, const ScannerPose & from, const HeadingPrior & prior)
{
  ExplainedPlace place;
  place.pose = from;
  for (int i = 0; i < kSettlingSteps; ++i) {
    view_.look(map_, scans.whole, place.pose);
    ++casts_;
    view_.find_walls(scans.whole);
    compare_beams(scans.whole, view_, noise_, trust_.gate, place.beams);
    const auto settled = settled_step(place.beams, prior, place.pose.yaw_rad);
    if (!settled) {
      place.refused = NoVerdictReason::kOneDirection;
      return place;
    }
    const double inflation = std::max(1.0, place.beams.chi_square);
    const Eigen::Matrix3d covariance = inflation * settled->covariance + settled->doubt +
                                       pull_of_strangers(scans, place.beams, prior);
    place.covariance = turned(covariance, place.pose.yaw_rad);
    place.pose = moved(place.pose, settled->step);
    // The comparison was made before the step: good where the step is small beside its own error.
    const double sigmas = std::sqrt(settled->step.dot(place.beams.information * settled->step));
    const bool plain =
      place.beams.agreeing_share() >= trust_.plain_share && !(prior.sigma_rad > 0.0);
    const bool hopeless = place.beams.agreeing_share() < kHopeless;
    if (sigmas < (plain ? kPlainStep : kLastStep) || hopeless || !is_free_(place.pose.position_m)) {
      break;
    }
  }
  return place;
}

void TrustedCentreOfMass::judge(const Belief & belief, ExplainedPlace & place) const
{
  const BeamComparison & beams = place.beams;
  const double from_belief = (place.pose.position_m - belief.area.around.position_m).norm();
  const auto fails = [&]() -> NoVerdictReason {
    const auto all = static_cast<double>(beams.outcomes.size());
    if (static_cast<double>(beams.speaking()) < trust_.speaking_share * all) {
      return NoVerdictReason::kFewBeams;
    }
    if (beams.agreeing_share() < trust_.agreeing_share) {
      return NoVerdictReason::kNotExplained;
    }
    if (beams.longer_share() > trust_.longer_share) {
      return NoVerdictReason::kBeyondTheWalls;
    }
    if (beams.least_direction_share < trust_.direction_share) {
      return NoVerdictReason::kOneDirection;
    }
    if (beams.near_share() > trust_.near_share) {
      return NoVerdictReason::kNearMisses;
    }
    if (beams.chi_square > trust_.chi_square) {
      return NoVerdictReason::kNoise;
    }
    if (largest_sigma_m(place.covariance) > trust_.largest_sigma_m) {
      return NoVerdictReason::kDirectionFree;
    }
    return from_belief > belief.area.radius_m ? NoVerdictReason::kOutOfSearch
                                              : NoVerdictReason::kNone;
  };
  place.refused = fails();
}

bool TrustedCentreOfMass::rivals(const BeamComparison & a, const BeamComparison & best) const
{
  return a.agreeing_share() >= trust_.agreeing_share && a.longer_share() <= trust_.longer_share &&
         a.contradiction < best.contradiction + trust_.tell_apart;
}

ExplainedPlace TrustedCentreOfMass::explore(
  const Scans & scans, const ScannerPose & from, const Belief & belief)
{
  const HeadingPrior prior{from.yaw_rad, belief.yaw_sigma_rad};
  ExplainedPlace best;
  ScannerPose start = from;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const auto aligned = align(scans, scans.descent, start, prior);
    if (!aligned) {
      break;
    }
    ExplainedPlace place = settle(scans, *aligned, prior);
    if (place.refused != NoVerdictReason::kOneDirection) {
      judge(belief, place);
    }
    if (place.beams.mismatch >= best.beams.mismatch) {
      break;
    }
    start = place.pose;
    best = std::move(place);
    if (best.refused == NoVerdictReason::kNone || best.beams.agreeing_share() < kPromising) {
      break;
    }
  }
  return best;
}

ExplainedPlace TrustedCentreOfMass::ask_strangers(
  const Scans & scans, const ExplainedPlace & best, const Belief & belief)
{
  std::vector<double> factors;
  for (BeamOutcome outcome : best.beams.outcomes) {
    factors.push_back(outcome == BeamOutcome::kAgrees ? kSayOfTheAgreeing : 1.0);
  }
  if (factors.size() != scans.whole.size()) {
    return {};
  }
  const HeadingPrior prior{best.pose.yaw_rad, belief.yaw_sigma_rad};
  alignment_.weigh(std::move(factors));
  const auto aligned = align(scans, scans.whole, best.pose, prior);
  alignment_.weigh({});
  if (!aligned) {
    return {};
  }
  ExplainedPlace place = settle(scans, *aligned, prior);
  if (place.refused != NoVerdictReason::kOneDirection) {
    judge(belief, place);
  }
  return place;
}

void TrustedCentreOfMass::search(
  const Scans & scans, const Belief & belief, ProfileFinding & finding)
{
  finding.searched = true;
  SearchGrid grid;
  grid.spacing_m = descent_.search_spacing * scans.size_m;
  grid.most = descent_.search_places;
  grid.kept = (belief.area.yaw_half_width_rad > 0.0 ? 2 : 1) * descent_.search_kept;
  grid.reach_m = descent_.reach_m;
  const Beams few = scans.whole.thinned(descent_.search_beams);
  std::vector<ExplainedPlace> places{std::move(finding.best)};
  const auto consider = [&places](ExplainedPlace found) {
    const bool known = std::any_of(
      places.begin(), places.end(),
      [&found](const ExplainedPlace & other) { return are_one(found, other); });
    if (!known && found.refused != NoVerdictReason::kOutOfSearch) {
      places.push_back(std::move(found));
    }
  };
  const auto rank = [&places] {
    std::sort(places.begin(), places.end(), [](const auto & a, const auto & b) {
      return a.beams.mismatch < b.beams.mismatch;
    });
  };
  for (const Place & place : likely_places(map_, is_free_, few, belief.area, grid)) {
    consider(explore(scans, place.pose, belief));
  }
  rank();
  if (places[0].beams.agreeing_share() < trust_.plain_share) {
    consider(ask_strangers(scans, places[0], belief));
    rank();
  }
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (!rivals(places[i].beams, places[0].beams)) {
      continue;
    }
    if (places[i].refused == NoVerdictReason::kNone) {
      finding.alternatives.push_back(places[i].pose);
    } else if (places[0].refused == NoVerdictReason::kNone) {
      places[0].refused = NoVerdictReason::kRival;
    }
  }
  finding.best = std::move(places[0]);
}

void TrustedCentreOfMass::conclude(
  const Scans & scans, const Belief & belief, ProfileFinding & finding)
{
  const auto & outcomes = finding.best.beams.outcomes;
  if (outcomes.size() == scans.whole.size()) {
    view_.look(map_, scans.whole, finding.best.pose);
    ++casts_;
    finding.expected = agreeing_moments(scans.whole, view_.ranges_m(), outcomes);
    finding.measured = agreeing_moments(scans.whole, scans.whole.ranges_m(), outcomes);
  }
  const auto & ranges_m = scans.whole.ranges_m();
  const auto valid = std::count_if(
    ranges_m.begin(), ranges_m.end(), [](double range) { return std::isfinite(range); });
  finding.valid_share = static_cast<double>(valid) / static_cast<double>(ranges_m.size());
  finding.casts = casts_;
  finding.reason = finding.best.refused;
  if (finding.reason != NoVerdictReason::kNone) {
    finding.verdict = Verdict::kNoVerdict;
    return;
  }
  if (!finding.alternatives.empty()) {
    finding.verdict = Verdict::kAmbiguous;
    return;
  }
  const double moved_m = (finding.best.pose.position_m - belief.area.around.position_m).norm();
  finding.verdict = moved_m <= descent_.agrees_within_m ? Verdict::kAgrees : Verdict::kCorrected;
}

void TrustedCentreOfMass::prepare(const stetro_site::BeamFan & fan)
{
  last_scan_.emplace(RangeProfile{fan, std::vector<double>(fan.count, 0.0)});
}

ProfileFinding TrustedCentreOfMass::check(const RangeProfile & scan, const Belief & belief)
{
  casts_ = 0;
  if (!last_scan_ || !last_scan_->renew(scan)) {
    last_scan_.emplace(scan);
  }
  const Beams & whole = *last_scan_;
  Scans scans{whole, whole.thinned(descent_.descent_beams), 0.0, 0.0};
  scans.cap_m = std::min(descent_.reach_m, kCapMedians * median_range(whole));
  ProfileFinding finding;
  const auto size = capped_moments(scans.descent, scans.descent.ranges_m(), scans.cap_m);
  if (!size) {
    finding.reason = NoVerdictReason::kFewBeams;
    return finding;
  }
  scans.size_m = std::sqrt(size->area_m2);
  const bool heading_open = belief.area.yaw_half_width_rad > 0.0;
  if (!heading_open) {
    const ScannerPose near = descend_by_centroid(scans, belief.area.around);
    finding.best = explore(scans, near, belief);
  }
  const bool plain = finding.best.refused == NoVerdictReason::kNone &&
                     finding.best.beams.agreeing_share() >= trust_.plain_share;
  if (!plain) {
    search(scans, belief, finding);
  }
  conclude(scans, belief, finding);
  return finding;
}

}  // namespace stetro_supervisor
