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

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "stetro_supervisor/floor/scan_beams.hpp"
#include "support/two_floors.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kTurn_rad = 6.283185307179586;

class ScanBeamsTest : public testing::Test
{
protected:
  ScanBeamsTest() { lidar.x_m = 0.05; }

  /// Eight ranges on the floor's own walls.
  ScanBeams seen_from(const FloorPlace & place)
  {
    Scan scan;
    scan.profile.fan = {0.0, kTurn_rad / 360.0, 360};
    auto fan = scan.profile.fan;
    fan.first_rad += place.yaw_rad;
    const Eigen::Vector2d mount(std::cos(place.yaw_rad), std::sin(place.yaw_rad));
    floor.walls().cast(place.position_m + lidar.x_m * mount, fan, 12.0, scan.profile.ranges_m);
    return beams_of(scan, lidar, params);
  }

  FloorPlace any_place()
  {
    std::uniform_real_distribution<double> x(0.3, 4.7);
    std::uniform_real_distribution<double> y(0.3, 3.7);
    std::uniform_real_distribution<double> yaw(-3.0, 3.0);
    return {"ground", {x(random), y(random)}, yaw(random), Eigen::Matrix3d::Zero()};
  }

  const stetro_site::Site site = two_floors(16, 8);
  FloorParams params;
  stetro_site::Lidar lidar;
  const DrawnFloor floor{site, "ground", params.resolution_m};
  std::mt19937 random{20260304};
};

/// By the search of the whole floor, where enough of the beams say anything.
bool searched(const DrawnFloor & floor, const ScanBeams & beams, const FloorPlace & place)
{
  const auto speaking = std::count_if(
    beams.ranges_m.begin(), beams.ranges_m.end(), [](double range) { return !std::isnan(range); });
  if (speaking < static_cast<std::ptrdiff_t>(kWrongBeams + 2)) {
    return true;
  }
  const HeadingSearch search{floor.grid(), beams.beams, place.yaw_rad};
  const auto answer = search.find(beams.ranges_m, kWrongBeams);
  const auto own = floor.grid().cell_at(place.position_m);
  return std::any_of(answer.cells.cells.begin(), answer.cells.cells.end(), [&](const auto & cell) {
    return std::abs(cell.column - own.column) <= 1 && std::abs(cell.row - own.row) <= 1;
  });
}

TEST_F(ScanBeamsTest, AllowAPlaceAsTheSearchOfTheWholeFloorWould)
{
  int allowed = 0;
  for (int i = 0; i < 80; ++i) {
    const FloorPlace truth = any_place();
    ScanBeams beams = seen_from(truth);
    beams.ranges_m[static_cast<std::size_t>(i) % kScanBeams] = std::nan("");
    const FloorPlace asked = i % 2 == 0 ? truth : any_place();
    const bool allows = beams_allow(floor, beams, asked);
    EXPECT_EQ(allows, searched(floor, beams, asked)) << "case " << i;
    allowed += allows ? 1 : 0;
  }
  EXPECT_GT(allowed, 36) << "the true places";
  EXPECT_LT(allowed, 64) << "and not all others";
}

TEST_F(ScanBeamsTest, SayWhatMostOfTheirRaysSay)
{
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const double nothing = std::nan("");
  Scan scan;
  scan.profile.fan = {0.0, kTurn_rad / 360.0, 360};
  scan.profile.ranges_m.assign(360, 2.0);
  const auto about = [&](std::size_t beam, double left, double middle, double right) {
    scan.profile.ranges_m[(beam * 45 + 359) % 360] = left;
    scan.profile.ranges_m[beam * 45] = middle;
    scan.profile.ranges_m[beam * 45 + 1] = right;
  };
  about(0, kNone, 3.0, kNone);
  about(1, 3.0, kNone, 4.0);
  about(2, -kNone, -kNone, 1.0);
  about(3, nothing, kNone, nothing);
  about(4, nothing, 3.0, 5.0);
  about(5, nothing, 3.0, kNone);
  about(6, nothing, kNone, kNone);
  const auto beams = beams_of(scan, lidar, params);
  EXPECT_EQ(beams.ranges_m[0], kNone) << "two of three have no return";
  EXPECT_EQ(beams.ranges_m[1], 4.0) << "one that was dropped";
  EXPECT_EQ(beams.ranges_m[2], -kNone) << "too near";
  EXPECT_TRUE(std::isnan(beams.ranges_m[3])) << "one ray alone is no majority";
  EXPECT_EQ(beams.ranges_m[4], 4.0);
  EXPECT_TRUE(std::isnan(beams.ranges_m[5])) << "one against one";
  EXPECT_EQ(beams.ranges_m[6], kNone);
  EXPECT_EQ(beams.ranges_m[7], 2.0);
}

// Nothing within the lidar's reach in five directions of eight is not the corner of a small room.
TEST_F(ScanBeamsTest, NoReturnExcludesPlacesNearWalls)
{
  const FloorPlace corner{"ground", {0.5, 0.5}, 0.2, Eigen::Matrix3d::Zero()};
  Scan scan;
  scan.profile.fan = {0.0, kTurn_rad / 360.0, 360};
  scan.profile.ranges_m.assign(360, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(beams_allow(floor, beams_of(scan, lidar, params), corner));
  params.dependable_m = 0.0;
  EXPECT_TRUE(beams_allow(floor, beams_of(scan, lidar, params), corner))
    << "a lidar that is not depended upon";
}

TEST_F(ScanBeamsTest, TooFewExcludeNothing)
{
  const FloorPlace truth{"ground", {1.0, 1.0}, 0.2, Eigen::Matrix3d::Zero()};
  ScanBeams beams = seen_from(truth);
  std::fill(beams.ranges_m.begin(), beams.ranges_m.begin() + 4, std::nan(""));
  std::fill(beams.ranges_m.begin() + 4, beams.ranges_m.end(), 0.2);
  EXPECT_TRUE(beams_allow(floor, beams, truth));
  std::fill(beams.ranges_m.begin(), beams.ranges_m.end(), 0.2);
  EXPECT_FALSE(beams_allow(floor, beams, truth)) << "eight of them do";
}

}  // namespace
}  // namespace stetro_supervisor
