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

#include "profiles/maps_suite.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "profiles/cpu_time.hpp"
#include "profiles/median.hpp"
#include "profiles/room_scanner.hpp"
#include "stetro_supervisor/profile/published_centre_of_mass.hpp"
#include "stetro_supervisor/profile/scan_check.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_supervisor::Determination;
using stetro_supervisor::ProfileFinding;
using stetro_supervisor::RangeProfile;
using stetro_supervisor::ScannerPose;
using stetro_supervisor::Verdict;

constexpr double kPi = 3.141592653589793;
constexpr std::size_t kBeams = 720;
constexpr double kReach = 12.0;
constexpr double kBodyRadius = 0.25;  // half of the body's diagonal
constexpr double kDisplacement = 1.0;
constexpr double kYawSigma = kPi / 180.0;
constexpr double kRangeSigma = 0.02;
constexpr double kDropouts = 0.1;
constexpr double kSolved = 0.05;
constexpr double kFalse = 0.25;
constexpr double kFalseSigmas = 5.0;
constexpr double kFree = 1.5;  // a free direction's sigma by that across it, if it is on the map

/// A cell of a floor where the body fits.
struct Stand
{
  const RecordedFloor * floor;
  Eigen::Vector2d centre_m;
};

/// One case: where the scanner is, what it saw, what is believed.
struct MapCase
{
  const RecordedFloor * floor;
  ScannerPose truth;
  ScannerPose believed;
  RangeProfile scan;
};

std::vector<Stand> stands_on(const RecordedFloor & floor)
{
  std::vector<Stand> stands;
  const auto & distances = floor.free->distances();
  for (std::size_t i = 0; i < floor.grid->cells().size(); ++i) {
    const auto cell = floor.grid->cell(i);
    if (distances.distance_m(cell) >= kBodyRadius) {
      stands.push_back({&floor, floor.grid->centre_m(cell)});
    }
  }
  return stands;
}

double uniform(std::mt19937_64 & random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

MapCase draw_case(const std::vector<Stand> & stands, std::mt19937_64 & random)
{
  const auto number = std::uniform_int_distribution<std::size_t>(0, stands.size() - 1)(random);
  const Stand & stand = stands[number];
  const double half = 0.5 * stand.floor->grid->resolution_m();
  MapCase one{stand.floor, {}, {}, {}};
  one.truth.position_m =
    stand.centre_m + Eigen::Vector2d(uniform(random, -half, half), uniform(random, -half, half));
  one.truth.yaw_rad = uniform(random, -kPi, kPi);
  do {
    const double distance = kDisplacement * std::sqrt(uniform(random, 0.0, 1.0));
    const double direction = uniform(random, -kPi, kPi);
    one.believed.position_m =
      one.truth.position_m + distance * Eigen::Vector2d(std::cos(direction), std::sin(direction));
  } while (!one.floor->is_free(one.believed.position_m));
  one.believed.yaw_rad =
    one.truth.yaw_rad + std::normal_distribution<double>(0.0, kYawSigma)(random);
  return one;
}

RangeProfile seen(const World & world, const ScannerPose & from, std::mt19937_64 & random)
{
  RangeProfile scan = world(from, kBeams, kReach);
  add_noise(scan, kRangeSigma, random);
  drop_out(scan, kDropouts, random);
  return scan;
}

Determination told_at(const RecordedFloor & floor, const Eigen::Vector2d & at)
{
  stetro_supervisor::DeterminationParams params;
  params.reach_m = kReach;
  return stetro_supervisor::determination(*floor.map, at, params);
}

bool is_determined(const Determination & told) { return told.worst_sigma_m <= kDeterminedSigma; }

/// The part of an error that the map says can be known [m].
double told_error_m(const Determination & told, Eigen::Vector2d error)
{
  if (!is_determined(told)) {
    error -= told.worst_direction * told.worst_direction.dot(error);
  }
  return error.norm();
}

MapsScore rate(const ProfileFinding & finding, const MapCase & one, const Determination & told)
{
  MapsScore score;
  score.cases = 1;
  if (finding.verdict == Verdict::kNoVerdict) {
    score.no_verdict = 1;
    score.reasons[stetro_supervisor::name_of(finding.reason)] = 1;
    return score;
  }
  if (finding.verdict == Verdict::kAmbiguous) {
    score.ambiguous = 1;
    return score;
  }
  const Eigen::Vector2d error = finding.best.pose.position_m - one.truth.position_m;
  const Eigen::Matrix2d covariance = finding.best.covariance.topLeftCorner<2, 2>();
  const double sigmas = std::sqrt(error.dot(covariance.inverse() * error));
  score.solved = error.norm() < kSolved ? 1 : 0;
  score.free_direction_shown = shows_free_direction(covariance, told) ? 1 : 0;
  score.by_ends = finding.by_ends ? 1 : 0;
  const bool claimed = error.norm() > kFalse && sigmas > kFalseSigmas;
  score.false_accepts = told_error_m(told, error) > kFalse || claimed ? 1 : 0;
  return score;
}

MapsScore check_trusted(const MapCase & one, const Determination & told)
{
  stetro_supervisor::ScanCheck check(
    *one.floor->map, one.floor->is_free, one.floor->walls, scan_check_params_of(*one.floor),
    one.floor->layer);
  check.prepare(one.scan.fan);
  stetro_supervisor::Belief belief;
  belief.area.around = one.believed;
  belief.area.radius_m = kDisplacement + kSolved;
  belief.yaw_sigma_rad = kYawSigma;
  const double start = cpu_time_us();
  const ProfileFinding finding = check.check(one.scan, belief);
  const double end = cpu_time_us();
  MapsScore score = rate(finding, one, told);
  score.us.push_back(end - start);
  return score;
}

/// Keeps the errors of the published search's steps under the spectral radius of the true place.
void draw_steps(
  const MapCase & one, const std::vector<Eigen::Vector2d> & positions_m, MapsTable & table)
{
  const stetro_supervisor::UsabilityParams asked;  // as the layer asks, and not a place beside it
  const auto here = stetro_supervisor::contraction(
    *one.floor->map, one.truth.position_m, as_published(asked.contraction));
  if (!here) {
    return;
  }
  const std::size_t kind = here->spectral_radius < 0.5 ? 0 : (here->spectral_radius < 1.0 ? 1 : 2);
  for (std::size_t step = 0; step < kDrawnSteps; ++step) {
    // A search that has settled stays where it is.
    const Eigen::Vector2d & at =
      step == 0 ? one.believed.position_m : positions_m[std::min(step, positions_m.size()) - 1];
    table.published_errors_m[kind][step].push_back((at - one.truth.position_m).norm());
  }
}

/// The published search says a pose and no more: what is off is off.
MapsScore check_published(const MapCase & one, MapsTable & table)
{
  MapsScore score;
  stetro_supervisor::PublishedLimits limits;
  limits.reach_m = kReach;
  const double start = cpu_time_us();
  const auto search = stetro_supervisor::published_search(
    *one.floor->map, stetro_supervisor::Beams(one.scan), one.believed, limits);
  score.us.push_back(cpu_time_us() - start);
  score.cases = 1;
  if (search.positions_m.empty()) {
    score.no_verdict = 1;
    return score;
  }
  draw_steps(one, search.positions_m, table);
  const double error = (search.positions_m.back() - one.truth.position_m).norm();
  score.solved = error < kSolved ? 1 : 0;
  score.false_accepts = error > kFalse ? 1 : 0;
  return score;
}

RadiusFigures figures_of(std::vector<double> radii)
{
  const auto below =
    std::count_if(radii.begin(), radii.end(), [](double radius) { return radius < 1.0; });
  RadiusFigures figures;
  figures.share_below_1 =
    static_cast<double>(below) / static_cast<double>(std::max<std::size_t>(1, radii.size()));
  figures.median = median(std::move(radii));
  return figures;
}

void tell_contraction(const std::vector<const RecordedFloor *> & floors, MapsTable & table)
{
  std::vector<double> guarded;
  std::vector<double> published;
  for (const RecordedFloor * floor : floors) {
    const auto & layer = *floor->layer;
    for (int row = 0; row < layer.rows(); ++row) {
      for (int column = 0; column < layer.columns(); ++column) {
        const auto & place = layer.of(column, row);
        if (!std::isnan(place.spectral_radius)) {
          guarded.push_back(place.spectral_radius);
          published.push_back(place.published_radius);
        }
      }
    }
  }
  table.guarded_radius = figures_of(std::move(guarded));
  table.published_radius = figures_of(std::move(published));
}

MapsTable run_map(
  const std::string & name, const std::vector<Stand> & stands, std::size_t cases,
  std::uint64_t seed, const std::function<void()> & done)
{
  MapsTable table;
  table.name = name;
  const double cell = stands.front().floor->grid->resolution_m();
  table.free_area_m2 = static_cast<double>(stands.size()) * cell * cell;
  for (std::size_t i = 0; i < cases; ++i) {
    std::seed_seq mixed{seed, static_cast<std::uint64_t>(i)};
    std::mt19937_64 random(mixed);
    MapCase one = draw_case(stands, random);
    one.scan = seen(one.floor->world, one.truth, random);
    const Determination told = told_at(*one.floor, one.truth.position_m);
    const bool determined = is_determined(told);
    (determined ? table.determined : table.elsewhere).add(check_trusted(one, told));
    if (determined) {
      table.published.add(check_published(one, table));
    }
    if (one.floor->rough_world) {
      one.scan = seen(one.floor->rough_world, one.truth, random);
      (determined ? table.rough_determined : table.rough_elsewhere).add(check_trusted(one, told));
    }
    done();
  }
  table.determined_share = static_cast<double>(table.determined.cases) / static_cast<double>(cases);
  return table;
}

}  // namespace

bool shows_free_direction(const Eigen::Matrix2d & covariance, const Determination & told)
{
  const Eigen::Vector2d & along = told.worst_direction;
  const Eigen::Vector2d across(-along.y(), along.x());
  const double sigma_m = std::sqrt(along.dot(covariance * along));
  const double longer = sigma_m / std::sqrt(across.dot(covariance * across));
  const double on_the_map = told.worst_sigma_m / std::sqrt(across.dot(told.covariance * across));
  return sigma_m > kDeterminedSigma && longer >= std::min(kFree, on_the_map);
}

void MapsScore::add(const MapsScore & other)
{
  cases += other.cases;
  solved += other.solved;
  no_verdict += other.no_verdict;
  ambiguous += other.ambiguous;
  free_direction_shown += other.free_direction_shown;
  by_ends += other.by_ends;
  false_accepts += other.false_accepts;
  for (const auto & [reason, count] : other.reasons) {
    reasons[reason] += count;
  }
  us.insert(us.end(), other.us.begin(), other.us.end());
}

std::vector<MapsTable> run_maps(
  const std::vector<RecordedFloor> & floors, std::size_t cases, std::uint64_t seed,
  const std::function<void()> & done)
{
  std::vector<MapsTable> tables;
  std::vector<Stand> stands;
  std::vector<const RecordedFloor *> of_one_name;
  for (std::size_t i = 0; i < floors.size(); ++i) {
    const auto more = stands_on(floors[i]);
    stands.insert(stands.end(), more.begin(), more.end());
    of_one_name.push_back(&floors[i]);
    if (i + 1 == floors.size() || floors[i + 1].name != floors[i].name) {
      tables.push_back(run_map(floors[i].name, stands, cases, seed, done));
      tell_contraction(of_one_name, tables.back());
      of_one_name.clear();
      stands.clear();
    }
  }
  return tables;
}

}  // namespace stetro_bringup
