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
#include <vector>

#include "stetro_supervisor/profile/determination.hpp"
#include "support/wall_caster.hpp"

namespace stetro_supervisor
{
namespace
{

using Eigen::Vector2d;
using stetro_site::Segment;

/// A wall along x in steps of a cell, as a map of cells draws a wall that is not along its axes.
void add_staircase(std::vector<Segment> & walls, double y_m, double slope)
{
  constexpr double kCell = 0.05;
  for (double x = -30.0; x < 30.0; x += kCell / slope) {
    const double next = x + kCell / slope;
    const double y = y_m + std::floor(x * slope / kCell) * kCell;
    walls.push_back({{x, y}, {next, y}});
    walls.push_back({{next, y}, {next, y + kCell}});
  }
}

TEST(Determination, RoomIsDeterminedAsItsWallsAllow)
{
  const WallCaster room(rectangle({0.0, 0.0}, {4.0, 4.0}));
  DeterminationParams params;
  params.noise = {0.02, 0.01, 4.0};  // each wall one error of 1 cm, and hardly any of the beams
  const auto told = determination(room, {2.0, 2.0}, params);
  // Two walls across either direction, each with less than one error's worth (beams share by the
  // wall's length at their own spacing): a centimetre by the root of two, or a little better.
  EXPECT_LT(told.worst_sigma_m, 0.009);
  EXPECT_GT(told.worst_sigma_m, 0.004);
}

TEST(Determination, CorridorHasAFreeDirection)
{
  const WallCaster corridor(rectangle({-40.0, 0.0}, {40.0, 2.0}));
  const auto told = determination(corridor, {0.0, 0.8}, {});
  EXPECT_TRUE(std::isinf(told.worst_sigma_m)) << told.worst_sigma_m;
  EXPECT_GT(std::abs(told.worst_direction.x()), 0.999);
}

TEST(Determination, StepsOfCellsTellNothingLengthwise)
{
  std::vector<Segment> walls;
  add_staircase(walls, 0.0, 0.07);  // a corridor 4 degrees off the cells' axes
  add_staircase(walls, 2.0, 0.07);
  const auto told = determination(WallCaster(walls), {0.0, 1.0}, {});
  EXPECT_GT(told.worst_sigma_m, 0.1);
  EXPECT_GT(std::abs(told.worst_direction.x()), 0.95);
}

TEST(Determination, LegsOfFurnitureAreNoWalls)
{
  std::vector<Segment> walls = rectangle({-40.0, 0.0}, {40.0, 2.0});
  for (double x = -5.0; x < 5.5; x += 1.0) {
    for (const Segment & side : rectangle({x, 0.5}, {x + 0.05, 0.55})) {
      walls.push_back(side);
    }
  }
  EXPECT_GT(determination(WallCaster(walls), {0.4, 1.2}, {}).worst_sigma_m, 0.1);
}

TEST(Determination, WidensACovarianceAlongWhatTheMapDoesNotTell)
{
  const Eigen::Matrix3d sure = Eigen::Vector3d(1e-6, 4e-6, 1e-6).asDiagonal();
  Determination told;
  told.worst_direction = Eigen::Vector2d(0.6, 0.8);
  told.worst_sigma_m = 0.01;
  EXPECT_EQ(widened(sure, told, 0.0125), sure) << "the map promises it";
  told.worst_sigma_m = 0.5;
  const Eigen::Matrix3d wide = widened(sure, told, 0.0125);
  const Eigen::Vector2d across(-0.8, 0.6);
  const Eigen::Matrix2d position = wide.topLeftCorner<2, 2>();
  EXPECT_NEAR(told.worst_direction.dot(position * told.worst_direction), 0.25, 1e-12);
  // 0.64 of the 1 mm along x and 0.36 of the 2 mm along y, as before
  EXPECT_NEAR(across.dot(position * across), 0.64e-6 + 0.36 * 4e-6, 1e-12);
  told.worst_sigma_m = INFINITY;
  EXPECT_TRUE(widened(sure, told, 0.0125).allFinite());
}

TEST(Determination, StretchesACovarianceToTheShapeOfTheBound)
{
  Determination told;
  told.worst_direction = Eigen::Vector2d(0.6, 0.8);
  const Eigen::Vector2d across(-0.8, 0.6);
  told.worst_sigma_m = 0.03;
  told.covariance = 0.03 * 0.03 * told.worst_direction * told.worst_direction.transpose() +
                    0.01 * 0.01 * across * across.transpose();
  const Eigen::Matrix3d round = Eigen::Vector3d(0.0025, 0.0025, 1e-4).asDiagonal();  // 5 cm
  const Eigen::Matrix3d wide = stretched(round, told);
  const Eigen::Matrix2d position = wide.topLeftCorner<2, 2>();
  EXPECT_NEAR(across.dot(position * across), 0.0025, 1e-12);
  EXPECT_NEAR(told.worst_direction.dot(position * told.worst_direction), 9 * 0.0025, 1e-12)
    << "three times as bad, as on the map";
  EXPECT_EQ(wide(2, 2), 1e-4);
  EXPECT_TRUE(stretched(wide, told).isApprox(wide)) << "it has that shape";
  told.worst_sigma_m = INFINITY;
  EXPECT_TRUE(stretched(round, told).allFinite());
}

}  // namespace
}  // namespace stetro_supervisor
