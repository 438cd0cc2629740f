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

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "stetro_supervisor/profile/trusted_centre_of_mass.hpp"
#include "support/wall_caster.hpp"

namespace stetro_supervisor
{
namespace
{

using Eigen::Vector2d;
using stetro_site::Segment;

constexpr double kPi = 3.141592653589793;
constexpr double kReach = 12.0;
constexpr double kSigma = 0.01;

std::vector<Segment> furnished()
{
  auto walls = rectangle({0.0, 0.0}, {8.0, 6.0});
  for (const auto & wall : rectangle({5.0, 1.0}, {6.0, 2.5})) {
    walls.push_back(wall);
  }
  return walls;
}

RangeProfile scanned(const std::vector<Segment> & world, const ScannerPose & pose)
{
  RangeProfile scan;
  scan.fan = {-kPi, kPi / 360.0, 720};
  const double first = scan.fan.first_rad + pose.yaw_rad;
  WallCaster(world).cast(pose.position_m, {first, scan.fan.step_rad, 720}, kReach, scan.ranges_m);
  return scan;
}

void add_noise(RangeProfile & scan, double sigma, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, sigma);
  for (double & range : scan.ranges_m) {
    range += noise(random);
  }
}

ProfileFinding checked(
  const std::vector<Segment> & map, const RangeProfile & scan, const Belief & belief,
  const BeamNoise & noise = {kSigma, 0.0, 0.5})
{
  const WallCaster caster(map);
  DescentParams descent;
  descent.reach_m = kReach;
  const FreeSpace everywhere = [](const Vector2d &) { return true; };
  return TrustedCentreOfMass(caster, everywhere, noise, TrustParams{}, descent).check(scan, belief);
}

const ScannerPose kTruth{{2.0, 3.5}, 0.4};

Belief belief_at(const Vector2d & position_m, double yaw_rad)
{
  Belief belief;
  belief.area.around = {position_m, yaw_rad};
  belief.area.radius_m = 3.0;
  return belief;
}

TEST(TrustedCentreOfMass, AgreesWithARightPose)
{
  const auto finding =
    checked(furnished(), scanned(furnished(), kTruth), belief_at(kTruth.position_m, 0.4));
  EXPECT_EQ(finding.verdict, Verdict::kAgrees) << name_of(finding.reason);
  EXPECT_FALSE(finding.searched);
}

TEST(TrustedCentreOfMass, CorrectsAWrongOne)
{
  const auto finding =
    checked(furnished(), scanned(furnished(), kTruth), belief_at({3.5, 2.0}, 0.4));
  EXPECT_EQ(finding.verdict, Verdict::kCorrected) << name_of(finding.reason);
  EXPECT_LT((finding.best.pose.position_m - kTruth.position_m).norm(), 1e-3);
}

// Without an echo a beam has no end that could count in a centroid, here or on the map.
TEST(TrustedCentreOfMass, CentroidStepsComeHomeThoughBeamsAreSilent)
{
  const auto room = rectangle({0.0, 0.0}, {8.0, 6.0});
  RangeProfile scan = scanned(room, kTruth);
  std::fill_n(scan.ranges_m.begin(), 72, std::numeric_limits<double>::infinity());  // a dark wall
  const WallCaster map(room);
  DescentParams centroids_only;
  centroids_only.reach_m = kReach;
  centroids_only.alignment_steps = 0;
  const FreeSpace everywhere = [](const Vector2d &) { return true; };
  // The steps end when they are as short as 2 % of the room: a gate that leaves room for the last.
  const BeamNoise coarse{5.0 * kSigma, 0.0, 0.5};
  TrustedCentreOfMass check(map, everywhere, coarse, TrustParams{}, centroids_only);
  const auto finding = check.check(scan, belief_at({3.0, 2.0}, 0.4));
  EXPECT_FALSE(finding.searched);
  EXPECT_EQ(finding.verdict, Verdict::kCorrected) << name_of(finding.reason);
  EXPECT_LT((finding.best.pose.position_m - kTruth.position_m).norm(), kSigma);
}

TEST(TrustedCentreOfMass, TurnsAndMovesWithTheRoom)
{
  const Eigen::Matrix2d turn = rotation(0.9);
  const Vector2d shift(100.0, -40.0);
  std::vector<Segment> map;
  for (const Segment & wall : furnished()) {
    map.push_back({turn * wall.from_m + shift, turn * wall.to_m + shift});
  }
  RangeProfile scan = scanned(furnished(), kTruth);  // what the scanner sees does not change
  add_noise(scan, kSigma, 3);
  const auto here = checked(furnished(), scan, belief_at({2.5, 3.0}, 0.4));
  const auto there = checked(map, scan, belief_at(turn * Vector2d(2.5, 3.0) + shift, 0.4 + 0.9));
  const Vector2d expected = turn * here.best.pose.position_m + shift;
  EXPECT_LT((there.best.pose.position_m - expected).norm(), 1e-3);
  const Eigen::Matrix2d covariance =
    turn * here.best.covariance.topLeftCorner<2, 2>() * turn.transpose();
  EXPECT_LT(
    (there.best.covariance.topLeftCorner<2, 2>() - covariance).norm(), 0.02 * covariance.norm());
}

TEST(TrustedCentreOfMass, SaysHowSureItIs)
{
  double nees = 0.0;
  constexpr int kRuns = 100;
  for (unsigned seed = 0; seed < kRuns; ++seed) {
    RangeProfile scan = scanned(furnished(), kTruth);
    add_noise(scan, kSigma, seed);
    const auto finding = checked(furnished(), scan, belief_at({2.3, 3.3}, 0.4));
    ASSERT_NE(finding.verdict, Verdict::kNoVerdict) << name_of(finding.reason);
    const Vector2d error = finding.best.pose.position_m - kTruth.position_m;
    const Eigen::Matrix2d covariance = finding.best.covariance.topLeftCorner<2, 2>();
    nees += error.dot(covariance.ldlt().solve(error)) / kRuns;
  }
  EXPECT_NEAR(nees, 2.0, 0.6) << "two degrees of freedom, 100 runs: +- 3 standard deviations";
}

TEST(TrustedCentreOfMass, SeesPastStrangers)
{
  auto world = furnished();
  for (const auto & wall : rectangle({2.5, 4.2}, {3.0, 4.7})) {
    world.push_back(wall);
  }
  for (const auto & wall : rectangle({0.6, 2.0}, {1.0, 2.6})) {
    world.push_back(wall);
  }
  const auto finding = checked(furnished(), scanned(world, kTruth), belief_at({2.6, 3.0}, 0.4));
  EXPECT_EQ(finding.verdict, Verdict::kCorrected) << name_of(finding.reason);
  EXPECT_LT((finding.best.pose.position_m - kTruth.position_m).norm(), 5e-3);
  EXPECT_GT(finding.best.beams.shorter, 50u);
}

TEST(TrustedCentreOfMass, AnotherRoomIsNoVerdict)
{
  const auto elsewhere = rectangle({0.0, 0.0}, {3.0, 9.0});
  const auto finding =
    checked(furnished(), scanned(elsewhere, {{1.0, 4.0}, 0.4}), belief_at({2.0, 3.0}, 0.4));
  EXPECT_EQ(finding.verdict, Verdict::kNoVerdict);
  EXPECT_NE(finding.reason, NoVerdictReason::kNone);
}

TEST(TrustedCentreOfMass, FindsTheHeadingOfAnUnevenRoom)
{
  Belief belief = belief_at({2.6, 3.0}, 0.0);
  belief.area.yaw_half_width_rad = kPi;
  belief.yaw_sigma_rad = 0.1;
  ScannerPose turned = kTruth;
  turned.yaw_rad = 2.5;
  const auto finding = checked(furnished(), scanned(furnished(), turned), belief);
  EXPECT_EQ(finding.verdict, Verdict::kCorrected) << name_of(finding.reason);
  EXPECT_LT((finding.best.pose.position_m - kTruth.position_m).norm(), 0.01);
  EXPECT_NEAR(std::remainder(finding.best.pose.yaw_rad - 2.5, 2.0 * kPi), 0.0, 0.005);
}

TEST(TrustedCentreOfMass, TellsTheSymmetryOfASquare)
{
  const auto square = rectangle({0.0, 0.0}, {6.0, 6.0});
  Belief belief = belief_at({3.0, 3.0}, 0.0);
  belief.area.yaw_half_width_rad = kPi;
  belief.yaw_sigma_rad = 0.1;
  const auto finding = checked(square, scanned(square, {{2.0, 3.5}, 0.7}), belief);
  EXPECT_EQ(finding.verdict, Verdict::kAmbiguous) << name_of(finding.reason);
  EXPECT_EQ(finding.alternatives.size(), 3u);
}

TEST(TrustedCentreOfMass, CorridorShowsItsFreeDirection)
{
  // 40 m long, reach 12 m; a niche far off is all that tells where along it.
  auto corridor = rectangle({-20.0, 0.0}, {20.0, 2.0});
  RangeProfile scan = scanned(corridor, {{0.0, 0.9}, 0.0});
  add_noise(scan, kSigma, 1);
  const auto finding = checked(corridor, scan, belief_at({0.3, 1.1}, 0.0));
  if (finding.verdict == Verdict::kNoVerdict) {
    SUCCEED() << name_of(finding.reason);
    return;
  }
  EXPECT_GT(finding.best.covariance(0, 0), 100.0 * finding.best.covariance(1, 1));
  EXPECT_NEAR(finding.best.pose.position_m.y(), 0.9, 0.01);
}

TEST(TrustedCentreOfMass, HalfATurnAndMissingEchoesWillDo)
{
  RangeProfile scan = scanned(furnished(), kTruth);
  scan.fan.count = 400;
  scan.ranges_m.resize(400);
  for (std::size_t i = 0; i < 400; i += 3) {
    scan.ranges_m[i] = std::numeric_limits<double>::infinity();
  }
  const auto finding = checked(furnished(), scan, belief_at({2.2, 3.3}, 0.4));
  EXPECT_EQ(finding.verdict, Verdict::kCorrected) << name_of(finding.reason);
  EXPECT_LT((finding.best.pose.position_m - kTruth.position_m).norm(), 5e-3);
}

TEST(TrustedCentreOfMass, SilentScannerIsNoVerdict)
{
  RangeProfile scan = scanned(furnished(), kTruth);
  for (double & range : scan.ranges_m) {
    range = std::numeric_limits<double>::infinity();
  }
  const auto finding = checked(furnished(), scan, belief_at(kTruth.position_m, 0.4));
  EXPECT_EQ(finding.verdict, Verdict::kNoVerdict);
  EXPECT_EQ(finding.reason, NoVerdictReason::kFewBeams);
}

}  // namespace
}  // namespace stetro_supervisor
