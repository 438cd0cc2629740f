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

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <vector>

#include "stetro_supervisor/profile/profile_moments.hpp"

namespace stetro_supervisor
{
namespace
{

using Eigen::Vector2d;

const std::vector<Vector2d> kTriangle{{0.0, 0.0}, {6.0, 0.0}, {0.0, 3.0}};

TEST(ProfileMoments, TriangleBalancesAtAThirdOfItsHeight)
{
  const auto moments = profile_moments(kTriangle);
  ASSERT_TRUE(moments);
  EXPECT_NEAR(moments->area_m2, 9.0, 1e-12);  // 6 * 3 / 2
  EXPECT_NEAR(moments->centroid_m.x(), 2.0, 1e-12);
  EXPECT_NEAR(moments->centroid_m.y(), 1.0, 1e-12);
}

TEST(ProfileMoments, LastPointJoinsTheFirst)
{
  // Without the closing edge, x = 0 from (0, 3) to the first point, an outline that does not begin
  // at the origin would lose a triangle. The same outline begun at another corner:
  const auto moments = profile_moments({{6.0, 1.0}, {0.0, 4.0}, {0.0, 1.0}});
  ASSERT_TRUE(moments);
  EXPECT_NEAR(moments->area_m2, 9.0, 1e-12);
  EXPECT_NEAR(moments->centroid_m.x(), 2.0, 1e-12);
  EXPECT_NEAR(moments->centroid_m.y(), 2.0, 1e-12);
}

TEST(ProfileMoments, ClockwiseIsTheSamePlate)
{
  const auto moments = profile_moments({kTriangle.rbegin(), kTriangle.rend()});
  ASSERT_TRUE(moments);
  EXPECT_NEAR(moments->area_m2, 9.0, 1e-12);
  EXPECT_NEAR(moments->centroid_m.x(), 2.0, 1e-12);
}

TEST(ProfileMoments, MovesAndTurnsWithTheOutline)
{
  const Vector2d shift(-40.0, 17.0);
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const Eigen::Matrix2d turn = (Eigen::Matrix2d() << c, -s, s, c).finished();
  std::vector<Vector2d> moved;
  for (const Vector2d & p : kTriangle) {
    moved.emplace_back(turn * p + shift);
  }
  const auto moments = profile_moments(moved);
  ASSERT_TRUE(moments);
  EXPECT_NEAR((moments->centroid_m - (turn * Vector2d(2.0, 1.0) + shift)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(moments->area_m2, 9.0, 1e-12);
}

TEST(ProfileMoments, NoAreaHasNoCentre)
{
  EXPECT_FALSE(profile_moments({})) << "no point";
  EXPECT_FALSE(profile_moments({{0.0, 0.0}, {1.0, 1.0}})) << "two points";
  EXPECT_FALSE(profile_moments({{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}})) << "a line";
  EXPECT_FALSE(profile_moments({{0.0, 0.0}, {1.0, 0.0}, {0.5, 1e-12}})) << "nearly a line";
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(profile_moments({{0.0, 0.0}, {1.0, 0.0}, {0.0, infinity}})) << "open";
}

}  // namespace
}  // namespace stetro_supervisor
