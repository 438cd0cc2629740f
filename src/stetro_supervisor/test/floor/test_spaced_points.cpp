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
#include <random>
#include <vector>

#include "stetro_supervisor/floor/spaced_points.hpp"

namespace stetro_supervisor
{

// The plain way: each point against all that were taken.
TEST(SpacedPoints, AreThoseOfAComparisonWithAll)
{
  std::mt19937 random{20260310};
  std::uniform_real_distribution<double> anywhere{-2.0, 2.0};
  constexpr double kSpacing_m = 0.25;
  SpacedPoints spaced{kSpacing_m};
  std::vector<Eigen::Vector2d> taken;
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector2d point{anywhere(random), anywhere(random)};
    const bool near = std::any_of(taken.begin(), taken.end(), [&](const Eigen::Vector2d & other) {
      return (other - point).norm() < kSpacing_m;
    });
    ASSERT_EQ(spaced.take(point), !near) << "point " << i;
    if (!near) {
      taken.push_back(point);
    }
  }
  EXPECT_GT(taken.size(), 150u);
}

}  // namespace stetro_supervisor
