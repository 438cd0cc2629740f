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

#include "profiles/rooms_suite.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

#include "profiles/cpu_time.hpp"
#include "profiles/median.hpp"
#include "profiles/random_room.hpp"
#include "profiles/room_scanner.hpp"
#include "stetro_site/frame_transform.hpp"
#include "stetro_site/segment_caster.hpp"
#include "stetro_supervisor/profile/published_centre_of_mass.hpp"
#include "stetro_supervisor/profile/trusted_centre_of_mass.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_supervisor::Belief;
using stetro_supervisor::ProfileFinding;
using stetro_supervisor::RangeProfile;
using stetro_supervisor::ScannerPose;
using stetro_supervisor::Verdict;

constexpr double kPi = 3.141592653589793;
constexpr std::size_t kBeams = 720;
constexpr double kReach = 200.0;        // more than the room's diagonal
constexpr double kSearchRadius = 42.0;  // displacement is up to 40
constexpr double kStatedSigma = 0.02;   // of a range without noise, 0.02 % of the room
constexpr double kFalse = 1.0;
constexpr double kFine = 0.1;
// A heading is off by as much as it moves what is seen half the room's side away.
constexpr double kFalseYaw = kFalse / (0.5 * RandomRoom::kSide);  // 1.1 degrees
constexpr double kFineYaw = kFine / (0.5 * RandomRoom::kSide);    // 0.11 degrees
constexpr double kFalseSigmas = 5.0;
constexpr double kUnmappedSpread = 0.02;  // of the share of beams that was asked for
constexpr std::size_t kSymmetriesOfASquare = 4;

/// One case: what is there, what was seen, what is believed.
struct RoomCase
{
  RandomRoom room;
  ScannerPose truth;
  RangeProfile scan;
};

double share_before(const RangeProfile & scan, const RangeProfile & clear)
{
  std::size_t before = 0;
  for (std::size_t i = 0; i < kBeams; ++i) {
    before += scan.ranges_m[i] < clear.ranges_m[i] ? 1 : 0;
  }
  return static_cast<double>(before) / static_cast<double>(kBeams);
}

/// Puts unmapped boxes into the world until their share of the beams is as asked.
void add_unmapped(RoomCase & one, double share, std::mt19937_64 & random)
{
  constexpr int kBoxes = 40;  // tried before all are taken away again
  const RangeProfile clear = scanned(one.room.map_walls(), one.truth, kBeams);
  for (;;) {
    one.room.unmapped.clear();
    for (int i = 0; i < kBoxes; ++i) {
      one.room.unmapped.push_back(draw_box(random, one.room));
      const double now = share_before(scanned(one.room.world_walls(), one.truth, kBeams), clear);
      if (now > share + kUnmappedSpread) {
        one.room.unmapped.pop_back();
      } else if (now >= share - kUnmappedSpread) {
        return;
      }
    }
  }
}

RoomCase draw_case(const RoomsKind & kind, std::uint64_t seed, std::size_t number)
{
  std::seed_seq mixed{seed, static_cast<std::uint64_t>(number)};
  std::mt19937_64 random(mixed);
  RoomCase one{draw_room(random, kind.draw), {}, {}};
  one.truth = {one.room.truth, std::uniform_real_distribution<double>(-kPi, kPi)(random)};
  if (kind.unmapped_share > 0.0) {
    add_unmapped(one, kind.unmapped_share, random);
  }
  one.scan = scanned(one.room.world_walls(), one.truth, kBeams);
  if (kind.noise_sigma > 0.0) {
    add_noise(one.scan, kind.noise_sigma, random);
  }
  return one;
}

/// The published search on one case. It has no verdict and no covariance: all it says is a pose.
RoomsScore solve_published(const stetro_site::ProfileCaster & map, const RoomCase & one)
{
  RoomsScore score;
  stetro_supervisor::PublishedLimits limits;
  limits.reach_m = kReach;
  limits.settled_m = 1e-3;
  const double start = cpu_time_us();
  const auto search = stetro_supervisor::published_search(
    map, stetro_supervisor::Beams(one.scan), {one.room.believed, one.truth.yaw_rad}, limits);
  score.us.push_back(cpu_time_us() - start);
  score.cases = 1;
  if (search.positions_m.empty()) {
    score.no_verdict = 1;
    return score;
  }
  const double error = (search.positions_m.back() - one.room.truth).norm();
  score.within_1 = error < kFalse ? 1 : 0;
  score.within_01 = error < kFine ? 1 : 0;
  score.false_accepts = error < kFalse ? 0 : 1;
  return score;
}

Belief belief_of(const RoomsKind & kind, const RoomCase & one)
{
  Belief belief;
  belief.area.around = {one.room.believed, kind.heading_unknown ? 0.0 : one.truth.yaw_rad};
  belief.area.radius_m = kSearchRadius;
  if (kind.heading_unknown) {
    belief.area.yaw_half_width_rad = kPi;
    belief.yaw_sigma_rad = 0.1;  // of a step of the search, 5 degrees
  }
  return belief;
}

/// Position and heading of a pose less those of the truth.
struct PoseError
{
  PoseError(const ScannerPose & pose, const ScannerPose & truth)
  : position(pose.position_m - truth.position_m),
    yaw_rad(std::abs(stetro_site::wrap_angle(pose.yaw_rad - truth.yaw_rad)))
  {
  }

  [[nodiscard]] bool is_within(double units, double rad) const
  {
    return position.norm() < units && yaw_rad < rad;
  }

  /// Beyond what the covariance says; a known heading has none.
  [[nodiscard]] bool is_beyond(const Eigen::Matrix3d & covariance) const
  {
    const Eigen::Matrix2d of_position = covariance.topLeftCorner<2, 2>();
    const double sigmas = std::sqrt(position.dot(of_position.inverse() * position));
    const double yaw_sigma = std::sqrt(covariance(2, 2));
    return sigmas > kFalseSigmas || (yaw_sigma > 0.0 && yaw_rad > kFalseSigmas * yaw_sigma);
  }

  Eigen::Vector2d position;
  double yaw_rad;
};

bool holds_truth(const ProfileFinding & finding, const ScannerPose & truth)
{
  const auto is_true = [&truth](const ScannerPose & pose) {
    return PoseError(pose, truth).is_within(kFine, kFineYaw);
  };
  return is_true(finding.best.pose) ||
         std::any_of(finding.alternatives.begin(), finding.alternatives.end(), is_true);
}

RoomsScore solve_trusted(
  const stetro_site::ProfileCaster & map, const RoomsKind & kind, const RoomCase & one)
{
  stetro_supervisor::BeamNoise noise;
  noise.range_sigma_m = std::max(kind.noise_sigma, kStatedSigma);
  stetro_supervisor::TrustParams trust;
  trust.largest_sigma_m = kFalse / kFalseSigmas;
  stetro_supervisor::DescentParams descent;
  descent.reach_m = kReach;
  stetro_supervisor::TrustedCentreOfMass check(
    map, [&one](const Eigen::Vector2d & p) { return one.room.is_free(p); }, noise, trust, descent);
  const Belief belief = belief_of(kind, one);
  check.prepare(one.scan.fan);  // a robot's lidar has one fan for life
  RoomsScore score;
  const double start = cpu_time_us();
  const ProfileFinding finding = check.check(one.scan, belief);
  score.us.push_back(cpu_time_us() - start);
  score.add(rated(finding, one.room, one.truth));
  return score;
}

}  // namespace

RoomsScore rated(const ProfileFinding & finding, const RandomRoom & room, const ScannerPose & truth)
{
  RoomsScore score;
  score.cases = 1;
  score.searched = finding.searched ? 1 : 0;
  if (finding.verdict == Verdict::kNoVerdict) {
    score.no_verdict = 1;
    return score;
  }
  if (finding.verdict == Verdict::kAmbiguous) {
    const std::size_t allowed = room.boxes.empty() ? kSymmetriesOfASquare : 1;
    score.ambiguous = 1;
    score.ambiguous_right =
      holds_truth(finding, truth) && finding.alternatives.size() < allowed ? 1 : 0;
    return score;
  }
  const PoseError error(finding.best.pose, truth);
  score.within_1 = error.is_within(kFalse, kFalseYaw) ? 1 : 0;
  score.within_01 = error.is_within(kFine, kFineYaw) ? 1 : 0;
  score.false_accepts = score.within_1 == 0 || error.is_beyond(finding.best.covariance) ? 1 : 0;
  return score;
}

std::vector<RoomsKind> kinds_of_rooms()
{
  constexpr double kNoise = 0.002 * RandomRoom::kSide;
  return {
    {"rooms", 0.0, 0.0, false, RoomDraw::kListed},
    {"rooms_noisy", kNoise, 0.0, false, RoomDraw::kListed},
    {"rooms_unmapped", 0.0, 0.2, false, RoomDraw::kListed},
    {"rooms_heading_unknown", 0.0, 0.0, true, RoomDraw::kListed},
    {"rooms_even", 0.0, 0.0, false, RoomDraw::kEven}};
}

void RoomsScore::add(const RoomsScore & other)
{
  cases += other.cases;
  within_1 += other.within_1;
  within_01 += other.within_01;
  no_verdict += other.no_verdict;
  ambiguous += other.ambiguous;
  ambiguous_right += other.ambiguous_right;
  false_accepts += other.false_accepts;
  searched += other.searched;
  us.insert(us.end(), other.us.begin(), other.us.end());
}

double RoomsScore::median_us() const { return median(us); }

RoomsTable run_rooms(
  const RoomsKind & kind, std::size_t rooms, std::uint64_t seed, const std::function<void()> & done)
{
  RoomsTable table{kind, {}, {}};
  for (std::size_t i = 0; i < rooms; ++i) {
    const RoomCase one = draw_case(kind, seed, i);
    const stetro_site::SegmentCaster map(one.room.map_walls());
    table.published.add(solve_published(map, one));
    table.trusted.add(solve_trusted(map, kind, one));
    done();
  }
  return table;
}

}  // namespace stetro_bringup
