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

#include "buildings.hpp"
#include "sim/clutter.hpp"

namespace stetro_driver::sim
{
namespace
{

using Eigen::Vector3d;

constexpr std::size_t kGround = 0;

Clutter drawn(const Building & building, int boxes, int people, std::uint64_t seed)
{
  return {building, boxes, people, seed, kGround, Vector3d{4.5, 1.0, 0.0}};
}

TEST(Disc, IsMetWhereARayComesIn)
{
  EXPECT_NEAR(distance_along(Disc{3.0, 0.0, 0.5}, 0.0, 0.0, 1.0, 0.0), 2.5, 1e-12);
  EXPECT_NEAR(distance_along(Disc{3.0, 0.3, 0.5}, 0.0, 0.0, 1.0, 0.0), 2.6, 1e-12);  // 3, 4, 5
  EXPECT_TRUE(std::isinf(distance_along(Disc{3.0, 0.6, 0.5}, 0.0, 0.0, 1.0, 0.0)));
  EXPECT_TRUE(std::isinf(distance_along(Disc{-3.0, 0.0, 0.5}, 0.0, 0.0, 1.0, 0.0)));
}

TEST(Clutter, IsAsMuchAsAskedForAndOutOfTheWay)
{
  const Building building{test::two_floors(), nullptr, 1};
  const Storey & ground = building.floor(kGround);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Clutter clutter = drawn(building, 2, 2, seed);
    for (double time_s = 0.0; time_s < 60.0; time_s += 0.5) {
      clutter.look(kGround, 1000.0 + time_s, 4.5, 1.0);
      ASSERT_EQ(clutter.walls().size(), 8u);
      ASSERT_EQ(clutter.people().size(), 2u);
      for (const Disc & person : clutter.people()) {
        EXPECT_TRUE(ground.plan.inside(person.x_m, person.y_m));
        EXPECT_GE(ground.plan.wall_distance_m(person.x_m, person.y_m), person.radius_m);
        EXPECT_GE(
          building.stairs_distance_m(kGround, Vector3d{person.x_m, person.y_m, 0.0}),
          1.0 + person.radius_m - 0.01);
      }
    }
    for (const Wall & side : clutter.walls()) {
      EXPECT_TRUE(ground.plan.inside(side.from_x_m, side.from_y_m));
      EXPECT_GE(
        building.stairs_distance_m(kGround, Vector3d{side.from_x_m, side.from_y_m, 0.0}), 1.0);
    }
  }
}

TEST(Clutter, MakesRoomForTheRobot)
{
  const Building building{test::two_floors(), nullptr, 1};
  Clutter clutter = drawn(building, 1, 1, 5);
  clutter.look(kGround, 1000.0, 4.5, 1.0);
  ASSERT_EQ(clutter.walls().size(), 4u);
  const Disc person = clutter.people().front();
  const Wall side = clutter.walls().front();
  clutter.look(kGround, 1000.0, side.from_x_m, side.from_y_m);
  EXPECT_TRUE(clutter.walls().empty()) << "somebody took the box away";
  clutter.look(kGround, 1000.0, person.x_m + 0.1, person.y_m);
  EXPECT_LT(clutter.people().front().x_m, person.x_m) << "stepped aside";
  EXPECT_NEAR(person.x_m + 0.1 - clutter.people().front().x_m, 0.3 + person.radius_m, 1e-12);
}

TEST(Clutter, IsTheSameForTheSameSeed)
{
  const Building building{test::two_floors(), nullptr, 1};
  Clutter a = drawn(building, 3, 2, 9);
  Clutter b = drawn(building, 3, 2, 9);
  Clutter c = drawn(building, 3, 2, 10);
  for (Clutter * one : {&a, &b, &c}) {
    one->look(kGround, 1012.0, 4.5, 1.0);
  }
  EXPECT_EQ(a.people()[1].x_m, b.people()[1].x_m);
  EXPECT_EQ(a.walls()[5].to_y_m, b.walls()[5].to_y_m);
  EXPECT_NE(a.walls()[5].to_y_m, c.walls()[5].to_y_m);
}

}  // namespace
}  // namespace stetro_driver::sim
