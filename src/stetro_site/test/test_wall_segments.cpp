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

#include "stetro_site/wall_segments.hpp"

namespace stetro_site
{
namespace
{

TEST(WallSegments, AreTheEdgesInTheirOrder)
{
  const PolygonWalls walls{{{0, 0}, {4, 0}, {4, 3}}, {{{1, 1}, {2, 1}, {2, 1.5}}}};
  const auto segments = wall_segments(walls);
  ASSERT_EQ(segments.size(), 6U);
  EXPECT_EQ(segments[2].from_m, Eigen::Vector2d(4, 3));
  EXPECT_EQ(segments[2].to_m, Eigen::Vector2d(0, 0)) << "the last corner joins the first";
  EXPECT_EQ(segments[3].from_m, Eigen::Vector2d(1, 1));
}

TEST(WallSegments, AreAsFarAsTheirNearestPoint)
{
  const Segment wall{{1, 1}, {4, 5}};  // five long, its direction (0.6, 0.8)
  EXPECT_NEAR(distance_m(wall, {1 + 0.6 - 1.6, 1 + 0.8 + 1.2}), 2.0, 1e-12) << "beside";
  EXPECT_NEAR(distance_m(wall, {1 - 0.6, 1 - 0.8}), 1.0, 1e-12) << "before its beginning";
  EXPECT_NEAR(distance_m(wall, {7, 9}), 5.0, 1e-12) << "beyond its end";
  EXPECT_NEAR(distance_m(Segment{{1, 1}, {1, 1}}, {4, 5}), 5.0, 1e-12) << "a point";
  EXPECT_NEAR(distance_m({wall, {{0, 0}, {1, 0}}}, {0.5, -0.25}), 0.25, 1e-12);
  EXPECT_EQ(distance_m(std::vector<Segment>{}, {0, 0}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace stetro_site
