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
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "stetro_site/floor_raster.hpp"
#include "stetro_site/free_space.hpp"

namespace stetro_site
{
namespace
{

// An L of 4 x 1 and 1 x 2 more, with a column of 0.4 x 0.4 in its foot.
PolygonWalls ell()
{
  return {
    {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}},
    {{{2.0, 0.3}, {2.4, 0.3}, {2.4, 0.7}, {2.0, 0.7}}}};
}

TEST(PolygonFreeSpace, IsInsideAndOutsideItsObstacles)
{
  const PolygonFreeSpace space{ell()};
  EXPECT_TRUE(space.is_free({0.5, 2.5}));
  EXPECT_TRUE(space.is_free({3.0, 0.5}));
  EXPECT_FALSE(space.is_free({2.0, 2.0})) << "in the corner that the L leaves out";
  EXPECT_FALSE(space.is_free({2.2, 0.5})) << "in the column";
  EXPECT_FALSE(space.is_free({-1.0, 0.5}));
  EXPECT_FALSE(space.is_free({0.0, 0.5})) << "on a wall";
}

TEST(PolygonFreeSpace, IsExactAboutItsWalls)
{
  const PolygonFreeSpace space{ell()};
  EXPECT_NEAR(space.clearance_m({0.3, 2.5}), 0.3, 1e-12);
  EXPECT_NEAR(space.clearance_m({2.7, 0.5}), 0.3, 1e-12) << "from the column";
  EXPECT_NEAR(space.clearance_m({0.7, 0.7}), std::hypot(0.3, 0.3), 1e-12) << "from the corner";
  EXPECT_EQ(space.clearance_m({2.2, 0.5}), 0.0);
  EXPECT_EQ(space.clearance_m({2.0, 2.0}), 0.0);
}

TEST(GridFreeSpace, IsWhatIsKnownToBeFree)
{
  const auto grid = std::make_shared<const OccupancyGrid>(
    GridFrame{4, 1, 1.0, {0.0, 0.0}, 0.0},
    std::vector<Cell>{Cell::kFree, Cell::kFree, Cell::kUnknown, Cell::kOccupied});
  const GridFreeSpace to_drive{grid};
  EXPECT_TRUE(to_drive.is_free({1.5, 0.5}));
  EXPECT_FALSE(to_drive.is_free({2.5, 0.5}));
  EXPECT_FALSE(to_drive.is_free({3.5, 0.5}));
  EXPECT_FALSE(to_drive.is_free({-0.5, 0.5}));
  EXPECT_NEAR(to_drive.clearance_m({1.5, 0.5}), 0.5, 1e-6);
  const GridFreeSpace to_compare{grid, Unknown::kFree};
  EXPECT_TRUE(to_compare.is_free({2.5, 0.5}));
  EXPECT_FALSE(to_compare.is_free({4.5, 0.5})) << "no floor any more";
  EXPECT_FALSE(to_compare.is_free({std::numeric_limits<double>::quiet_NaN(), 0.5}));
  EXPECT_NEAR(to_compare.clearance_m({1.5, 0.5}), 1.5, 1e-6);
}

TEST(FreeSpace, IsThatOfTheDrawing)
{
  EXPECT_EQ(free_space_of(FloorDrawing{}), nullptr);
  EXPECT_TRUE(free_space_of(ell())->is_free({0.5, 2.5}));
  const auto grid = std::make_shared<const OccupancyGrid>(rasterise(ell(), 0.05));
  EXPECT_TRUE(free_space_of(GridMapFile{"ell.yaml", grid})->is_free({0.5, 2.5}));
  EXPECT_THROW(free_space_of(GridMapFile{"ell.yaml", nullptr}), std::invalid_argument);
}

// Property: a floor drawn as a grid promises no room that its walls do not leave, and takes away
// less than the cells that walls touch (1.42) and the way between centres (1.5).
TEST(FreeSpace, OfAGridIsWithinThatOfItsWalls)
{
  constexpr double kCell = 0.05;
  const PolygonFreeSpace exact{ell()};
  const GridFreeSpace drawn{std::make_shared<const OccupancyGrid>(rasterise(ell(), kCell))};
  std::mt19937 random{20250403};
  std::uniform_real_distribution<double> x{-0.5, 4.5};
  std::uniform_real_distribution<double> y{-0.5, 3.5};
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector2d at(x(random), y(random));
    const double exact_m = exact.clearance_m(at);
    ASSERT_TRUE(exact.is_free(at) || !drawn.is_free(at)) << at.transpose();
    ASSERT_LE(drawn.clearance_m(at), exact_m + 1e-6) << at.transpose();
    ASSERT_GE(drawn.clearance_m(at), exact_m - (1.42 + 1.5) * kCell) << at.transpose();
  }
}

}  // namespace
}  // namespace stetro_site
