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
#include <string>

#include "./written_file.hpp"
#include "recorded/building_map.hpp"

namespace recorded
{
namespace
{

using stetro_site::Cell;
using stetro_site::WrittenFile;

const std::vector<BuildingLevel> & hotel()
{
  static const auto kLevels = BuildingMap::read(STETRO_RECORDED "/maps/hotel/hotel.building.yaml");
  return kLevels;
}

// A square of 10 x 10 pixels below the middle of the drawing, two pixels to the metre.
TEST(BuildingMap, TurnsPixelsIntoMetres)
{
  const WrittenFile file{
    "coordinate_system: reference_image\n"
    "levels:\n"
    "  L7:\n"
    "    elevation: 21\n"
    "    measurements: [[0, 1, {distance: [3, 5.0]}]]\n"
    "    vertices: [[10, 20, 0, ''], [20, 20, 0, ''], [20, 30, 0, '']]\n"
    "    walls: [[0, 2, {}]]\n"
    "    floors: [{parameters: {}, vertices: [0, 1, 2]}]\n"};
  const auto levels = BuildingMap::read(file.path());
  ASSERT_EQ(levels.size(), 1U);
  EXPECT_EQ(levels[0].name, "L7");
  EXPECT_EQ(levels[0].elevation_m, 21.0);
  ASSERT_EQ(levels[0].walls.size(), 1U);
  EXPECT_TRUE(levels[0].walls[0].from_m.isApprox(Eigen::Vector2d(5.0, -10.0)));
  EXPECT_TRUE(levels[0].walls[0].to_m.isApprox(Eigen::Vector2d(10.0, -15.0)));
  EXPECT_NEAR(stetro_site::signed_area_m2(levels[0].floors[0]), -12.5, 1e-12) << "half of 5 x 5";
}

TEST(BuildingMap, RefusesOtherCoordinates)
{
  const WrittenFile file{"coordinate_system: wgs84\nlevels: {}\n"};
  EXPECT_THROW(BuildingMap::read(file.path()), std::runtime_error);
}

// Scales, lengths and the first corner by a few lines of Python over the YAML.
TEST(BuildingMap, ReadsTheHotel)
{
  ASSERT_EQ(hotel().size(), 3U);
  const auto length_m = [](const BuildingLevel & level) {
    double sum = 0.0;
    for (const auto & wall : level.walls) {
      sum += (wall.to_m - wall.from_m).norm();
    }
    return sum;
  };
  EXPECT_EQ(hotel()[0].name, "L1");
  EXPECT_EQ(hotel()[2].elevation_m, 16.0);
  EXPECT_NEAR(hotel()[0].metres_a_pixel, 0.0556801924, 1e-9);
  EXPECT_EQ(hotel()[0].walls.size(), 56U);
  EXPECT_NEAR(length_m(hotel()[0]), 203.944149, 1e-5);
  EXPECT_TRUE(
    hotel()[0].walls[0].from_m.isApprox(Eigen::Vector2d(7.119380763, -30.656010588), 1e-9));
  EXPECT_EQ(hotel()[1].walls.size(), 99U);
  EXPECT_NEAR(length_m(hotel()[1]), 312.613046, 1e-5);
}

// The floors of L1 have 83.39 + 162.72 + 433.46 m^2 by the same lines, less the walls' cells.
TEST(BuildingMap, DrawsTheHotelAsAGrid)
{
  const auto grid = rasterise(hotel()[0], 0.05);
  const auto free = std::count(grid.cells().begin(), grid.cells().end(), Cell::kFree);
  const double area_m2 = 0.0025 * static_cast<double>(free);
  EXPECT_LT(area_m2, 679.57);
  EXPECT_GT(area_m2, 679.57 - 203.95 * 0.1);
  for (const auto & wall : hotel()[0].walls) {
    EXPECT_EQ(grid.at(grid.cell_at(0.5 * (wall.from_m + wall.to_m))), Cell::kOccupied);
  }
}

}  // namespace
}  // namespace recorded
