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

#include <cmath>

#include "stetro_supervisor/four_beams/azimuth.hpp"
#include "stetro_supervisor/four_beams/published_search.hpp"
#include "support/random_room.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::CellIndex;

constexpr double kPi = 3.14159265358979323846;

// No two of its sides, turns or mirror images are alike.
stetro_site::OccupancyGrid asymmetric()
{
  return drawn(
    {"######",  // y = 0 of the paper, row 3 here
     "#..###",  //
     "#....#",  //
     "######"});
}

// x to the right and y down from the top left corner, as a person reads the drawing.
TEST(Azimuth, CellsOfThePaperAreCountedFromTheTop)
{
  const auto grid = asymmetric();
  EXPECT_EQ(from_paper(grid, {2, 1}), (CellIndex{2, 2}));
  EXPECT_EQ(grid.at(from_paper(grid, {2, 1})), stetro_site::Cell::kFree);
  EXPECT_EQ(grid.at(from_paper(grid, {3, 1})), stetro_site::Cell::kOccupied);
  EXPECT_EQ(grid.at(from_paper(grid, {4, 2})), stetro_site::Cell::kFree);
  const PaperCell back = to_paper(grid, from_paper(grid, {4, 2}));
  EXPECT_EQ(back.x, 4);
  EXPECT_EQ(back.y, 2);
}

// From (3, 2), in the drawing: a wall right above, one cell free to the right, a wall right below,
// two cells free to the left.
TEST(Azimuth, DirectionsAreThoseOfTheDrawing)
{
  const auto grid = asymmetric();
  const CellIndex place = from_paper(grid, {3, 2});
  EXPECT_EQ(beam_distance(grid, place, Azimuth::kNorth), 1);
  EXPECT_EQ(beam_distance(grid, place, Azimuth::kEast), 2);
  EXPECT_EQ(beam_distance(grid, place, Azimuth::kSouth), 1);
  EXPECT_EQ(beam_distance(grid, place, Azimuth::kWest), 3);
  const auto found = published_search(grid, {1, 2, 1, 3}, BeamPath::kTracked);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front(), place);
}

// Azimuth is clockwise from north, yaw counter-clockwise from x: north is +90 degrees, east 0.
TEST(Azimuth, YawTurnsTheOtherWay)
{
  EXPECT_NEAR(yaw_rad(Azimuth::kNorth), kPi / 2, 1e-15);
  EXPECT_NEAR(yaw_rad(Azimuth::kEast), 0.0, 1e-15);
  EXPECT_NEAR(yaw_rad(Azimuth::kSouth), -kPi / 2, 1e-15);
  EXPECT_NEAR(yaw_rad(Azimuth::kWest), kPi, 1e-15);
  EXPECT_NEAR(yaw_rad(kPi / 6), kPi / 3, 1e-15);
  for (const Azimuth azimuth : kAzimuths) {
    EXPECT_NEAR(std::cos(yaw_rad(azimuth)), step(azimuth).column, 1e-15);
    EXPECT_NEAR(std::sin(yaw_rad(azimuth)), step(azimuth).row, 1e-15);
  }
}

}  // namespace
}  // namespace stetro_supervisor
