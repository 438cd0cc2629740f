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
#include <random>
#include <vector>

#include "profiles/grid_scanner.hpp"
#include "profiles/roughened.hpp"
#include "stetro_site/grid_caster.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_site::Cell;
using stetro_site::OccupancyGrid;

/// 40 x 30 cells of 0.1 m, walls all round and two cells thick on the right, some cells inside.
OccupancyGrid arena()
{
  std::vector<Cell> cells(40 * 30, Cell::kFree);
  for (std::size_t row = 0; row < 30; ++row) {
    for (std::size_t column = 0; column < 40; ++column) {
      if (row == 0 || row == 29 || column == 0 || column >= 38 || (row == 12 && column % 9 == 4)) {
        cells[row * 40 + column] = Cell::kOccupied;
      }
    }
  }
  return OccupancyGrid{{40, 30, 0.1, {-1.0, -1.0}, 0.0}, cells};
}

TEST(GridScanner, ReadsTheFacesOfTheWalls)
{
  const auto scan = scanned(arena(), {{0.05, 0.05}, 0.0}, 4, 12.0);
  EXPECT_NEAR(scan.ranges_m[0], 2.75, 1e-9);  // from 0.05 to the face at 2.8
  EXPECT_NEAR(scan.ranges_m[1], 1.85, 1e-9);  // to 1.9
  EXPECT_NEAR(scan.ranges_m[2], 0.95, 1e-9);  // to -0.9
  EXPECT_NEAR(scan.ranges_m[3], 0.95, 1e-9);  // to -0.9
}

TEST(GridScanner, AgreesWithTheCasterWithoutSharingCode)
{
  const auto grid = arena();
  const stetro_site::GridCaster caster(grid, stetro_site::Unknown::kFree);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> x(-0.85, 2.7);
  for (int i = 0; i < 30; ++i) {
    const Eigen::Vector2d at(x(random), 0.4);
    const auto scan = scanned(grid, {at, 0.3}, 720, 12.0);
    std::vector<double> model;
    caster.cast(at, {0.3, scan.fan.step_rad, 720}, 12.0, model);
    for (std::size_t beam = 0; beam < 720; ++beam) {
      EXPECT_NEAR(scan.ranges_m[beam], model[beam], 1e-6) << "place " << i << ", beam " << beam;
    }
  }
}

TEST(Roughened, ChangesFacesAndOpensNoWall)
{
  const auto grid = arena();
  std::mt19937_64 random(3);
  const auto rough = roughened(grid, 0.5, random);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < grid.cells().size(); ++i) {
    changed += grid.cells()[i] != rough.cells()[i] ? 1 : 0;
  }
  EXPECT_GT(changed, 20u);
  const auto scan = scanned(rough, {{0.05, 0.55}, 0.0}, 360, 12.0);
  for (double range : scan.ranges_m) {
    EXPECT_TRUE(std::isfinite(range));
  }
}

}  // namespace
}  // namespace stetro_bringup
