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
#include <cstdlib>
#include <memory>

#include "stetro_site/free_space.hpp"
#include "stetro_supervisor/profile/scan_check.hpp"
#include "support/cell_room.hpp"
#include "support/wall_caster.hpp"

namespace stetro_supervisor
{
namespace
{

const ScannerPose kTruth{{2.1, 1.4}, 0.3};

Belief belief_off(double x_m, double y_m)
{
  Belief belief;
  belief.area.around = kTruth;
  belief.area.around.position_m += Eigen::Vector2d(x_m, y_m);
  belief.area.around.yaw_rad += 0.02;
  belief.area.radius_m = 0.8;
  belief.yaw_sigma_rad = 0.03;
  return belief;
}

FreeSpace everywhere()
{
  return [](const Eigen::Vector2d &) { return true; };
}

ProfileFinding checked(const CellRoom & map, const RangeProfile & scan, const Belief & belief)
{
  const auto caster = map.caster();
  return ScanCheck(caster, everywhere(), map.distances(), scan_check_params(0.05), nullptr)
    .check(scan, belief);
}

TEST(ScanCheck, ComparesProfilesWhereTheFloorIsAsMapped)
{
  const CellRoom room;
  const auto finding = checked(room, room.scanned(kTruth), belief_off(0.2, -0.2));
  EXPECT_EQ(finding.verdict, Verdict::kCorrected) << name_of(finding.reason);
  EXPECT_FALSE(finding.by_ends);
  EXPECT_LT((finding.best.pose.position_m - kTruth.position_m).norm(), 0.03);
}

TEST(ScanCheck, AsksTheEndsWhereTheFloorHasChanged)
{
  CellRoom map;
  map.add_wall({3.0, 0.6}, {3.0, 2.4});  // gone since: a third of the beams go through
  map.add_wall({1.2, 0.6}, {1.2, 1.5});
  const auto finding = checked(map, CellRoom().scanned(kTruth), belief_off(0.2, -0.2));
  EXPECT_EQ(finding.verdict, Verdict::kCorrected) << name_of(finding.reason);
  EXPECT_TRUE(finding.by_ends);
  EXPECT_LT((finding.best.pose.position_m - kTruth.position_m).norm(), 0.05);
  EXPECT_GT(largest_sigma_m(finding.best.covariance), 0.025) << "a changed map is not exact";
}

TEST(ScanCheck, AnotherRoomIsNoVerdict)
{
  const WallCaster elsewhere(rectangle({0.0, 0.0}, {1.7, 9.0}));
  RangeProfile scan = CellRoom().scanned(kTruth);
  elsewhere.cast({0.9, 4.0}, {0.3, scan.fan.step_rad, 360}, 12.0, scan.ranges_m);
  const auto finding = checked(CellRoom(), scan, belief_off(0.1, 0.1));
  EXPECT_EQ(finding.verdict, Verdict::kNoVerdict);
}

double sigma_along(const Eigen::Vector2d & direction, const Eigen::Matrix3d & covariance)
{
  return std::sqrt(direction.dot(covariance.topLeftCorner<2, 2>() * direction));
}

TEST(ScanCheck, IsNoSurerThanTheMapThereOrBesideIt)
{
  const CellRoom room;
  const auto map = room.caster();
  const ScanCheckParams params = scan_check_params(0.05);
  for (const Eigen::Vector2d & truth :
       {Eigen::Vector2d(2.1, 1.4), Eigen::Vector2d(1.3, 0.9), Eigen::Vector2d(2.9, 2.2)}) {
    Belief belief = belief_off(0.0, 0.0);
    belief.area.around.position_m = truth + Eigen::Vector2d(0.1, -0.05);
    const auto finding = checked(room, room.scanned({truth, 0.3}), belief);
    ASSERT_NE(finding.verdict, Verdict::kNoVerdict) << name_of(finding.reason);
    double worst = 0.0;
    for (int i = -1; i <= 1; ++i) {
      for (int j = std::abs(i) - 1; j <= 1 - std::abs(i); ++j) {
        const auto told = determination(
          map, finding.best.pose.position_m + params.beside_m * Eigen::Vector2d(i, j),
          params.determination);
        worst = std::max(worst, told.worst_sigma_m);
      }
    }
    EXPECT_GE(largest_sigma_m(finding.best.covariance), 0.999 * worst) << truth.transpose();
  }
}

TEST(ScanCheck, EndsTellEachDirectionInTheMapsProportion)
{
  CellRoom map;
  map.add_wall({3.0, 0.6}, {3.0, 2.4});  // gone since, as above
  map.add_wall({1.2, 0.6}, {1.2, 1.5});
  const auto caster = map.caster();
  ScanCheckParams params = scan_check_params(0.05);
  params.beside_m = 0.0;
  const auto finding = ScanCheck(caster, everywhere(), map.distances(), params, nullptr)
                         .check(CellRoom().scanned(kTruth), belief_off(0.2, -0.2));
  ASSERT_TRUE(finding.by_ends);
  const auto told = determination(caster, finding.best.pose.position_m, params.determination);
  const Eigen::Vector2d & u = told.worst_direction;
  const Eigen::Vector2d v(-u.y(), u.x());
  const double on_the_map = told.worst_sigma_m / std::sqrt(v.dot(told.covariance * v));
  const Eigen::Matrix3d & covariance = finding.best.covariance;
  EXPECT_GE(sigma_along(u, covariance) / sigma_along(v, covariance), 0.999 * on_the_map);
}

TEST(ScanCheck, TheMapsBoundWidensTheCovariance)
{
  // A corridor beyond the reach, with a scan that would tell more than its walls do.
  const WallCaster corridor(rectangle({-40.0, 0.0}, {40.0, 2.0}));
  stetro_site::PolygonWalls outline;
  outline.outline = {{-40.0, 0.0}, {40.0, 0.0}, {40.0, 2.0}, {-40.0, 2.0}};
  const stetro_site::PolygonFreeSpace free(outline);
  UsabilityParams asked;
  asked.contraction = {180, 12.0, 0.1};
  const auto layer = std::make_shared<const UsabilityLayer>(
    corridor, free, Eigen::Vector2d(-1.0, 0.5), Eigen::Vector2d(1.0, 1.5), asked);
  RangeProfile scan = CellRoom().scanned(kTruth);
  corridor.cast({0.0, 0.9}, {0.0, scan.fan.step_rad, 360}, 12.0, scan.ranges_m);
  Belief belief;
  belief.area.around = {{0.1, 1.0}, 0.0};
  ScanCheckParams params = scan_check_params(0.0);
  ScanCheck check(corridor, everywhere(), nullptr, params, layer);
  const auto finding = check.check(scan, belief);
  if (finding.verdict != Verdict::kNoVerdict) {
    EXPECT_GT(std::sqrt(finding.best.covariance(0, 0)), 1.0);
    EXPECT_LT(std::sqrt(finding.best.covariance(1, 1)), 0.05);
    ASSERT_TRUE(finding.spectral_radius);
    EXPECT_GT(*finding.spectral_radius, 0.9) << "the profile moves along with the scanner";
  }
}

}  // namespace
}  // namespace stetro_supervisor
