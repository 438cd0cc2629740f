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
#include "sim/floor_plan.hpp"

namespace stetro_driver::sim
{
namespace
{

/// A room of 4 m by 3 m with a column of 1 m by 1 m in its middle.
FloorPlan room()
{
  FloorShape shape;
  shape.drawn = true;
  shape.walls = {test::rectangle(0.0, 0.0, 4.0, 3.0), test::rectangle(1.5, 1.0, 2.5, 2.0)};
  return FloorPlan{shape};
}

TEST(FloorPlan, KnowsInsideFromOutside)
{
  EXPECT_TRUE(room().inside(0.5, 0.5));
  EXPECT_FALSE(room().inside(2.0, 1.5)) << "in the column";
  EXPECT_FALSE(room().inside(4.5, 1.5));
  EXPECT_EQ(room().walls().size(), 8u);
  EXPECT_EQ(room().max_x_m(), 4.0);
  EXPECT_EQ(room().max_y_m(), 3.0);
}

TEST(FloorPlan, MeasuresToTheNearestWall)
{
  EXPECT_NEAR(room().wall_distance_m(0.7, 1.5), 0.7, 1e-12);
  EXPECT_NEAR(room().wall_distance_m(1.2, 0.6), 0.5, 1e-12);  // to the column's corner: 3, 4, 5
}

TEST(FloorPlan, WithoutADrawingIsOpen)
{
  const FloorPlan plan{FloorShape{}};
  EXPECT_FALSE(plan.drawn());
  EXPECT_TRUE(plan.inside(100.0, -100.0));
  EXPECT_TRUE(std::isinf(plan.wall_distance_m(0.0, 0.0)));
}

}  // namespace
}  // namespace stetro_driver::sim
