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

#include "sim/wall.hpp"

namespace stetro_driver::sim
{
namespace
{

constexpr double kNowhere = std::numeric_limits<double>::infinity();

Wall from_to(double from_x, double from_y, double to_x, double to_y)
{
  return {from_x, from_y, to_x, to_y};
}

/// The robot, bumpers pressed in: 45 cm by 22.6 cm.
constexpr Rectangle kBody{-0.225, 0.225, 0.113};

TEST(Wall, IsMetWhereARayCrossesIt)
{
  const Wall wall = from_to(2.0, -1.0, 2.0, 1.0);
  EXPECT_NEAR(distance_along(wall, 0.0, 0.0, 1.0, 0.0), 2.0, 1e-12);
  EXPECT_NEAR(distance_along(wall, 0.0, 0.5, 0.8, -0.6), 2.5, 1e-12);  // at y = 0.5 - 1.5
  EXPECT_EQ(distance_along(wall, 0.0, 0.0, 0.8, 0.6), kNowhere) << "passes its end at y 1.5";
  EXPECT_EQ(distance_along(wall, 0.0, 0.0, -1.0, 0.0), kNowhere) << "behind";
  EXPECT_EQ(distance_along(wall, 2.0, -2.0, 0.0, 1.0), kNowhere) << "edge on";
  EXPECT_NEAR(distance_along(wall, 3.0, 0.0, -1.0, 0.0), 1.0, 1e-12) << "from its other side";
}

TEST(Wall, IsMetByARayOnlyAsHighAsItIs)
{
  Wall wall = from_to(2.0, -1.0, 2.0, 1.0);
  wall.bottom_m = 0.14;
  wall.top_m = 0.28;
  const auto hit = cast(wall, {0.0, 0.0, 0.2}, {1.0, 0.0, 0.0});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance_m, 2.0, 1e-12);
  EXPECT_NEAR(hit->cos_incidence, 1.0, 1e-12);
  EXPECT_FALSE(cast(wall, {0.0, 0.0, 0.1}, {1.0, 0.0, 0.0})) << "under it";
  EXPECT_FALSE(cast(wall, {0.0, 0.0, 0.3}, {1.0, 0.0, 0.0})) << "over it";
  const auto slanted = cast(wall, {0.0, 0.0, 1.7}, {0.8, 0.0, -0.6});
  ASSERT_TRUE(slanted);  // 2 m ahead and 1.5 m down
  EXPECT_NEAR(slanted->distance_m, 2.5, 1e-12);
  EXPECT_NEAR(slanted->cos_incidence, 0.8, 1e-12);
}

TEST(WayOut, IsStraightBackFromAWallAhead)
{
  const auto out = way_out(kBody, from_to(0.22, -3.0, 0.22, 3.0));
  ASSERT_TRUE(out);
  EXPECT_NEAR(out->depth_m, 0.005, 1e-12);
  EXPECT_NEAR(out->x, -1.0, 1e-12);
  EXPECT_NEAR(out->y, 0.0, 1e-12);
  EXPECT_FALSE(way_out(kBody, from_to(0.225, -3.0, 0.225, 3.0))) << "only touches";
  EXPECT_FALSE(way_out(kBody, from_to(0.22, 0.2, 0.22, 3.0))) << "beside the body";
}

TEST(WayOut, OfACornerThatPokesIntoTheSide)
{
  // The end of a wall, half-way along the body: no corner of the body is in anything.
  const auto out = way_out(kBody, from_to(0.05, 0.1, 0.05, 2.0));
  ASSERT_TRUE(out);
  EXPECT_NEAR(out->depth_m, 0.013, 1e-12);
  EXPECT_NEAR(out->y, -1.0, 1e-12);
  EXPECT_NEAR(out->at_x_m, 0.05, 1e-12);
}

TEST(WayOut, IsSquareToASlantedWall)
{
  // x + y = 0.328: the corner (0.225, 0.113) is 0.010 / sqrt 2 behind it.
  const auto out = way_out(kBody, from_to(1.328, -1.0, -0.672, 1.0));
  ASSERT_TRUE(out);
  EXPECT_NEAR(out->depth_m, 0.01 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(out->x, -std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(out->y, -std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(out->at_x_m, 0.225, 1e-12);
  EXPECT_NEAR(out->at_y_m, 0.113, 1e-12);
}

TEST(Beside, IsTheNearestPartAlongAStretch)
{
  const Wall slanted = from_to(-1.0, 0.1, 1.0, 0.3);  // y = 0.2 + 0.1 x
  EXPECT_NEAR(beside_m(slanted, -0.5, 0.5, true), 0.15, 1e-12);
  EXPECT_EQ(beside_m(slanted, -0.5, 0.5, false), kNowhere) << "on the other side";
  EXPECT_EQ(beside_m(slanted, 1.1, 1.2, true), kNowhere) << "not so far";
  EXPECT_LE(beside_m(from_to(0.0, -1.0, 0.0, 1.0), -0.5, 0.5, true), 0.0) << "across";
}

}  // namespace
}  // namespace stetro_driver::sim
