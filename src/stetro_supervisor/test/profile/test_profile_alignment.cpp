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

#include "stetro_supervisor/profile/profile_alignment.hpp"
#include "support/wall_caster.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kReach = 30.0;

WallCaster furnished()
{
  auto walls = rectangle({0.0, 0.0}, {8.0, 6.0});
  for (const auto & wall : rectangle({5.0, 1.0}, {6.0, 2.5})) {
    walls.push_back(wall);
  }
  return WallCaster(walls);
}

RangeProfile scanned(const WallCaster & world, const ScannerPose & pose)
{
  RangeProfile scan;
  scan.fan = {0.0, 6.283185307179586 / 360.0, 360};
  world.cast(pose.position_m, {pose.yaw_rad, scan.fan.step_rad, 360}, kReach, scan.ranges_m);
  return scan;
}

ScannerPose aligned(
  const WallCaster & map, const Beams & scan, ScannerPose at, const HeadingPrior & prior)
{
  WallView view(kReach, 0.0);
  ProfileAlignment alignment(0.03);
  alignment.restart(0.3);
  for (int i = 0; i < 12; ++i) {
    view.look(map, scan, at);
    view.find_walls(scan);
    const auto step = alignment.step(scan, view, prior, at.yaw_rad);
    if (!step) {
      ADD_FAILURE() << "no step";
      return at;
    }
    at = moved(at, *step);
  }
  return at;
}

TEST(ProfileAlignment, FindsThePlaceAtAKnownHeading)
{
  const WallCaster map = furnished();
  const ScannerPose truth{{2.0, 3.0}, 0.8};
  const ScannerPose found = aligned(map, Beams(scanned(map, truth)), {{2.4, 2.7}, 0.8}, {0.8, 0.0});
  EXPECT_LT((found.position_m - truth.position_m).norm(), 1e-6);
  EXPECT_DOUBLE_EQ(found.yaw_rad, 0.8) << "known, and not to be changed";
}

TEST(ProfileAlignment, FindsTheHeadingToo)
{
  const WallCaster map = furnished();
  const ScannerPose truth{{2.0, 3.0}, 0.8};
  const ScannerPose found =
    aligned(map, Beams(scanned(map, truth)), {{2.2, 2.9}, 0.74}, {0.74, 0.2});
  EXPECT_LT((found.position_m - truth.position_m).norm(), 2e-3);
  EXPECT_NEAR(found.yaw_rad, 0.8, 1e-3);
}

TEST(ProfileAlignment, StrangersLoseTheirSay)
{
  const WallCaster map = furnished();
  const ScannerPose truth{{2.0, 3.0}, 0.0};
  RangeProfile scan = scanned(map, truth);
  for (std::size_t i = 100; i < 170; ++i) {
    scan.ranges_m[i] *= 0.6;  // somebody stands there
  }
  const ScannerPose found = aligned(map, Beams(scan), {{2.3, 2.8}, 0.0}, {0.0, 0.0});
  EXPECT_LT((found.position_m - truth.position_m).norm(), 0.005);
}

TEST(ProfileAlignment, WallsOfOneDirectionGiveNoStep)
{
  const WallCaster corridor({{{-1e3, 0.0}, {1e3, 0.0}}, {{1e3, 2.0}, {-1e3, 2.0}}});
  const Beams scan(scanned(corridor, {{0.0, 0.8}, 0.0}));
  WallView view(kReach, 0.0);
  view.look(corridor, scan, {{0.0, 1.0}, 0.0});
  view.find_walls(scan);
  EXPECT_FALSE(ProfileAlignment(0.03).step(scan, view, {0.0, 0.0}, 0.0));
}

}  // namespace
}  // namespace stetro_supervisor
