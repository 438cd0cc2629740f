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

#include "stetro_supervisor/floor/profile_witness.hpp"

#include <algorithm>
#include <cmath>

#include "stetro_site/distance_field.hpp"
#include "stetro_site/frame_transform.hpp"
#include "stetro_supervisor/profile/contraction.hpp"
#include "stetro_supervisor/profile/scan_check.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kMisfitCap_m = 0.3;
constexpr double kContracts = 0.5;  // the centroid's steps halve an error or better
constexpr double kMostInflation = 10.0;
constexpr double kGuessRadius_m = 0.5;
/// The robot's lidar on a floor: as `scripts/profiles` evaluates lidars on maps.
ScanCheckParams checks_of(
  const DrawnFloor & floor, const stetro_site::Lidar & lidar, const FloorParams & params)
{
  const bool cells = std::holds_alternative<stetro_site::GridMapFile>(floor.floor().drawing);
  ScanSetup setup;
  setup.range_sigma_m = lidar.sigma_m;
  setup.reach_m = lidar.max_range_m;
  setup.map_sigma_m = params.map_sigma_m;
  setup.resolution_m = cells ? floor.grid().resolution_m() : 0.0;
  return scan_check_params(setup);
}

/// Without a search of its own: whoever guesses has searched.
ScanCheckParams for_guesses(ScanCheckParams checks)
{
  checks.descent.search_places = 9;
  checks.descent.search_kept = 1;
  return checks;
}

/// Where the ends of beams may lie.
std::shared_ptr<const stetro_site::DistanceField> walls_of(const DrawnFloor & floor)
{
  return std::make_shared<const stetro_site::DistanceField>(
    std::make_shared<const stetro_site::OccupancyGrid>(floor.grid()), stetro_site::Unknown::kFree);
}

double residual_m(
  const DrawnFloor & floor, const Scan & scan, const ExplainedPlace & best, double reach_m)
{
  const Beams beams{scan.profile};
  std::vector<double> expected_m;
  floor.walls().cast(best.pose.position_m, beams.fan_at(best.pose.yaw_rad), reach_m, expected_m);
  double squares = 0.0;
  std::size_t agreeing = 0;
  for (std::size_t i = 0; i < best.beams.outcomes.size() && i < expected_m.size(); ++i) {
    if (best.beams.outcomes[i] == BeamOutcome::kAgrees) {
      const double error = beams.ranges_m()[i] - expected_m[i];
      squares += error * error;
      ++agreeing;
    }
  }
  return agreeing > 0 ? std::sqrt(squares / static_cast<double>(agreeing)) : 0.0;
}

}  // namespace

ScannerPose scanner_at(const FloorPlace & place, const stetro_site::Lidar & lidar)
{
  const Eigen::Vector2d mount{lidar.x_m, lidar.y_m};
  return {
    place.position_m + rotation(place.yaw_rad) * mount,
    stetro_site::wrap_angle(place.yaw_rad + lidar.yaw_rad)};
}

FloorPlace base_at(const ScannerPose & scanner, const stetro_site::Lidar & lidar)
{
  FloorPlace place;
  place.yaw_rad = stetro_site::wrap_angle(scanner.yaw_rad - lidar.yaw_rad);
  const Eigen::Vector2d mount{lidar.x_m, lidar.y_m};
  place.position_m = scanner.position_m - rotation(place.yaw_rad) * mount;
  return place;
}

class ProfileWitness::Parts
{
public:
  Parts(const DrawnFloor & drawn, const stetro_site::Lidar & mounted, const FloorParams & given)
  : floor(drawn),
    lidar(mounted),
    params(given),
    checks(checks_of(drawn, mounted, given)),
    headings(drawn.grid(), given.search_heading_rad),
    around(drawn.walls(), is_free(), walls_of(drawn), checks, nullptr),
    near(drawn.walls(), is_free(), nullptr, for_guesses(checks), nullptr)
  {
  }

  Testimony take(ScanCheck & asked, const Scan & scan, const Belief & belief) const
  {
    Testimony testimony;
    testimony.finding = asked.check(scan.profile, belief);
    const ProfileFinding & finding = testimony.finding;
    const ScannerPose & best = finding.best.pose;
    if (finding.expected && finding.measured) {
      const Eigen::Matrix2d turn = rotation(best.yaw_rad);
      testimony.expected_centroid_m = best.position_m + turn * finding.expected->centroid_m;
      testimony.measured_centroid_m = best.position_m + turn * finding.measured->centroid_m;
      testimony.residual_m = residual_m(floor, scan, finding.best, lidar.max_range_m);
    }
    if (finding.verdict == Verdict::kAgrees || finding.verdict == Verdict::kCorrected) {
      testimony.spectral_radius = spectral_radius(best);
      testimony.found = base_at(best, lidar);
      testimony.found->floor_id = floor.id();
      testimony.found->covariance = covariance(testimony);
    }
    return testimony;
  }

  const DrawnFloor & floor;
  stetro_site::Lidar lidar;
  FloorParams params;
  ScanCheckParams checks;
  HeadingTables headings;
  ScanCheck around;
  ScanCheck near;
  std::vector<double> cast_m;

private:
  FreeSpace is_free() const
  {
    return [this](const Eigen::Vector2d & p) { return floor.free_space().is_free(p); };
  }

  double spectral_radius(const ScannerPose & at) const
  {
    ContractionParams given;
    given.reach_m = lidar.max_range_m;
    const auto here = contraction(floor.walls(), at.position_m, given);
    return here ? here->spectral_radius : kMostInflation;
  }

  Eigen::Matrix3d covariance(const Testimony & testimony) const
  {
    const double inflation =
      std::clamp(testimony.spectral_radius / kContracts, 1.0, kMostInflation);
    const double position_m2 = params.pose_sigma_m * params.pose_sigma_m;
    const double heading_rad2 = params.pose_sigma_rad * params.pose_sigma_rad;
    const Eigen::Vector3d own{position_m2, position_m2, heading_rad2};
    const ExplainedPlace & best = testimony.finding.best;
    Eigen::Matrix3d all = inflation * best.covariance;
    // base_link turns about the scanner: the heading's error moves it by its lever arm
    const Eigen::Vector2d lever = testimony.found->position_m - best.pose.position_m;
    Eigen::Matrix3d moved = Eigen::Matrix3d::Identity();
    moved(0, 2) = -lever.y();
    moved(1, 2) = lever.x();
    all = moved * all * moved.transpose();
    all.diagonal() += own;
    return all;
  }
};

ProfileWitness::ProfileWitness(
  const DrawnFloor & floor, const stetro_site::Lidar & lidar, const FloorParams & params)
: parts_(std::make_unique<Parts>(floor, lidar, params))
{
}

ProfileWitness::~ProfileWitness() = default;
ProfileWitness::ProfileWitness(ProfileWitness &&) noexcept = default;

const DrawnFloor & ProfileWitness::floor() const noexcept { return parts_->floor; }

HeadingTables & ProfileWitness::headings() noexcept { return parts_->headings; }

Testimony ProfileWitness::about(const Scan & scan, const FloorPlace & place)
{
  Belief belief;
  belief.area.around = scanner_at(place, parts_->lidar);
  belief.area.radius_m = parts_->params.check_radius_m;
  belief.yaw_sigma_rad =
    std::max(parts_->params.check_yaw_sigma_rad, std::sqrt(std::max(0.0, place.covariance(2, 2))));
  return parts_->take(parts_->around, scan, belief);
}

Testimony ProfileWitness::at(const Scan & scan, const FloorPlace & guess)
{
  Belief belief;
  belief.area.around = scanner_at(guess, parts_->lidar);
  belief.area.radius_m = kGuessRadius_m;
  belief.yaw_sigma_rad = parts_->params.search_heading_rad;
  return parts_->take(parts_->near, scan, belief);
}

double ProfileWitness::misfit_m(const Beams & few, const FloorPlace & place)
{
  const ScannerPose at = scanner_at(place, parts_->lidar);
  parts_->floor.walls().cast(
    at.position_m, few.fan_at(at.yaw_rad), parts_->lidar.max_range_m, parts_->cast_m);
  double sum = 0.0;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < few.size(); ++i) {
    const double measured = few.ranges_m()[i];
    if (std::isfinite(measured)) {
      sum += std::min(std::abs(measured - parts_->cast_m[i]), kMisfitCap_m);
      ++compared;
    }
  }
  return compared > 0 ? sum / static_cast<double>(compared) : kMisfitCap_m;
}

}  // namespace stetro_supervisor
