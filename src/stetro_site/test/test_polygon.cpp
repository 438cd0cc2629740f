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

#include "stetro_site/polygon.hpp"

namespace stetro_site
{
namespace
{

const Polygon kEll{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};

TEST(Polygon, HasAnAreaWithTheSignOfItsTurn)
{
  EXPECT_NEAR(signed_area_m2(kEll), 6.0, 1e-12);  // 4 x 1 + 1 x 2
  Polygon clockwise = kEll;
  std::reverse(clockwise.begin(), clockwise.end());
  EXPECT_NEAR(signed_area_m2(clockwise), -6.0, 1e-12);
}

TEST(Polygon, EnclosesWhatIsInsideWhicheverWayRound)
{
  Polygon clockwise = kEll;
  std::reverse(clockwise.begin(), clockwise.end());
  for (const Polygon & polygon : {kEll, clockwise}) {
    EXPECT_TRUE(encloses(polygon, {0.5, 2.5}));
    EXPECT_TRUE(encloses(polygon, {3.5, 0.5}));
    EXPECT_FALSE(encloses(polygon, {2.0, 2.0})) << "in the corner that is left out";
    EXPECT_FALSE(encloses(polygon, {-0.5, 1.0})) << "level with two corners";
    EXPECT_TRUE(encloses(polygon, {0.5, 1.0})) << "level with two corners";
    EXPECT_FALSE(encloses(polygon, {5.0, 0.0}));
  }
}

TEST(Polygon, IsAWallWhenItNeverMeetsItself)
{
  EXPECT_EQ(flaw_of(kEll), "");
  EXPECT_EQ(flaw_of({{0, 0}, {1, 0}, {2, 0}, {2, 2}}), "") << "a corner on a straight line";
}

TEST(Polygon, SaysWhatIsWrong)
{
  EXPECT_EQ(flaw_of({{0, 0}, {1, 0}}), "fewer than three corners");
  EXPECT_EQ(flaw_of({{0, 0}, {0.001, 0}, {0, 0.001}}), "no area");
  EXPECT_EQ(
    flaw_of({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), "the edge at corner 0 meets the edge at corner 2");
  EXPECT_NE(flaw_of({{0, 0}, {2, 0}, {1, 0}, {1, 2}}), "") << "folded back";
  EXPECT_NE(flaw_of({{0, 0}, {0, 0}, {1, 0}, {1, 2}}), "") << "a corner twice";
  EXPECT_NE(flaw_of({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}), "") << "a corner on an edge";
}

}  // namespace
}  // namespace stetro_site
