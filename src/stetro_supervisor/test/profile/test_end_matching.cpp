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

#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "stetro_supervisor/profile/end_matching.hpp"
#include "support/cell_room.hpp"

namespace stetro_supervisor
{
namespace
{

SearchArea area_about(const ScannerPose & pose) { return {pose, 0.6, 0.12}; }

TEST(EndMatching, FindsThePlaceInAFurnishedRoom)
{
  const CellRoom room;
  const ScannerPose truth{{2.1, 1.4}, 0.3};
  const EndMatching matching(room.distances(), {});
  const auto found =
    matching.matches(Beams(room.scanned(truth)), area_about({{2.35, 1.25}, 0.35}), 12.0);
  ASSERT_FALSE(found.empty());
  EXPECT_LT((found[0].pose.position_m - truth.position_m).norm(), 0.04);
  EXPECT_NEAR(found[0].pose.yaw_rad, truth.yaw_rad, 0.01);
  EXPECT_GT(found[0].on_wall_share, 0.95);
}

TEST(EndMatching, BeamsMayPassWallsThatAreGone)
{
  CellRoom world;
  const ScannerPose truth{{2.1, 1.4}, 0.0};
  const RangeProfile scan = world.scanned(truth);
  CellRoom map;
  map.add_wall({3.0, 0.6}, {3.0, 2.4});  // a screen that has been taken away since
  const EndMatching matching(map.distances(), {});
  const auto found = matching.matches(Beams(scan), area_about({{2.3, 1.6}, 0.05}), 12.0);
  ASSERT_FALSE(found.empty());
  EXPECT_LT((found[0].pose.position_m - truth.position_m).norm(), 0.04);
}

TEST(EndMatching, PlacesAreApartAndBestFirst)
{
  const CellRoom room;
  const EndMatching matching(room.distances(), {});
  const auto found =
    matching.matches(Beams(room.scanned({{2.1, 1.4}, 0.0})), area_about({{2.1, 1.4}, 0.0}), 12.0);
  for (std::size_t i = 1; i < found.size(); ++i) {
    EXPECT_LE(found[i].likelihood, found[i - 1].likelihood);
    EXPECT_GE((found[i].pose.position_m - found[0].pose.position_m).norm(), 0.2);
  }
}

TEST(EndMatching, NoEchoNoPlace)
{
  const CellRoom room;
  RangeProfile scan = room.scanned({{2.1, 1.4}, 0.0});
  for (double & range : scan.ranges_m) {
    range = std::numeric_limits<double>::infinity();
  }
  const EndMatching matching(room.distances(), {});
  EXPECT_TRUE(matching.matches(Beams(scan), area_about({{2.1, 1.4}, 0.0}), 12.0).empty());
}

TEST(EndMatching, RefusesToWorkWithoutWalls)
{
  EXPECT_THROW(EndMatching(nullptr, {}), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_supervisor
