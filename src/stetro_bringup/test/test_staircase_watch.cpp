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

#include "accuracy/staircase_watch.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_localizer::ScalarEstimate;

stetro_site::Flight four_steps()
{
  stetro_site::FlightSpec spec;
  spec.id = "stairs";
  spec.steps = stetro_site::equal_steps(4, 0.14, 0.32);
  spec.width_foot_m = spec.width_top_m = 2.0;
  return stetro_site::Flight(spec);
}

/// On a tread 0.325 m deep at mid width, that grows by 2 mm a metre to the left.
stetro_driver::GroundTruth standing(int step, double y_m)
{
  stetro_driver::GroundTruth truth;
  truth.step = step;
  truth.y_m = y_m;
  truth.tread_width_m = 2.004;
  truth.tread_x_m = 0.235;
  truth.riser_ahead_m = 0.090 + 0.002 * (y_m - 1.002);
  return truth;
}

TEST(StaircaseWatch, MeasuresATreadAtMidWidth)
{
  StaircaseWatch watch;
  for (const double y_m : {0.1, 0.9, 1.002, 1.9}) {
    watch.watch(standing(2, y_m));
  }
  const auto score = watch.score(
    {{2, ScalarEstimate{0.326, 1e-6}, ScalarEstimate{2.003, 4e-6}}}, four_steps(), 0.02);
  ASSERT_EQ(score.treads.size(), 1u);
  EXPECT_EQ(score.treads[0].step, 2);
  EXPECT_NEAR(score.treads[0].found_error_m, 0.001, 1e-12);
  EXPECT_NEAR(score.treads[0].sigma_m, 0.001, 1e-12);
  EXPECT_NEAR(score.treads[0].site_error_m, -0.005, 1e-12);
  ASSERT_EQ(score.widths.size(), 1u);
  EXPECT_NEAR(score.widths[0].found_error_m, -0.001, 1e-12);
  EXPECT_NEAR(score.widths[0].site_error_m, -0.004, 1e-12);
  EXPECT_EQ(score.reported, 0u);
}

TEST(StaircaseWatch, CountsWhatIsReported)
{
  StaircaseWatch watch;
  watch.watch(standing(2, 1.0));
  const auto score =
    watch.score({{2, ScalarEstimate{0.36, 1e-6}, std::nullopt}}, four_steps(), 0.02);
  EXPECT_EQ(score.reported, 1u);
}

TEST(StaircaseWatch, HasNoDepthWhereNoRiserIsAhead)
{
  StaircaseWatch watch;
  auto top = standing(4, 1.0);
  top.riser_ahead_m = std::nan("");
  watch.watch(top);
  watch.watch(standing(0, 1.0));
  const auto score = watch.score(
    {{3, ScalarEstimate{0.32, 1e-6}, std::nullopt},
     {4, ScalarEstimate{0.32, 1e-6}, ScalarEstimate{2.0, 1e-6}}},
    four_steps(), 0.02);
  EXPECT_TRUE(score.treads.empty()) << "tread 3 was not stood on";
  EXPECT_EQ(score.widths.size(), 1u);
}

}  // namespace
}  // namespace stetro_bringup
