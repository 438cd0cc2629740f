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

#include "stetro_localizer/staircase_as_built.hpp"
#include "support/stair_robot.hpp"

namespace stetro_localizer
{
namespace
{

ScalarEstimate known(double value, double sigma) { return {value, sigma * sigma}; }

// The papers' treads are 0.32 m deep and 2.05 m wide.
TEST(StaircaseAsBuilt, StandsBesideTheSiteFile)
{
  const auto all = deviations(
    {{3, known(0.324, 0.001), known(2.048, 0.002)}, {4, std::nullopt, known(2.05, 0.002)}},
    papers_flight());
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].step, 3);
  EXPECT_EQ(all[0].measure, StepMeasure::kTread);
  EXPECT_NEAR(all[0].by_m(), 0.004, 1e-12);
  EXPECT_EQ(all[1].measure, StepMeasure::kWidth);
  EXPECT_NEAR(all[1].by_m(), -0.002, 1e-12);
  EXPECT_EQ(all[2].step, 4);
}

TEST(StaircaseAsBuilt, ADeviationExceedsItsBoundOnlyWhereItIsSure)
{
  const auto off_by = [](double by_m, double sigma) {
    return Deviation{7, StepMeasure::kTread, known(0.32 + by_m, sigma), 0.32};
  };
  EXPECT_TRUE(off_by(0.04, 0.001).exceeds(0.02));
  EXPECT_TRUE(off_by(-0.04, 0.001).exceeds(0.02));
  EXPECT_FALSE(off_by(0.019, 0.001).exceeds(0.02)) << "within the bound";
  EXPECT_FALSE(off_by(0.04, 0.015).exceeds(0.02)) << "2.7 standard deviations";
}

TEST(StaircaseAsBuilt, WidthsBelongToTheMiddleOfTheTread)
{
  stetro_site::FlightSpec spec = papers_flight().spec();
  spec.width_top_m = 2.15;
  const auto all = deviations({{8, std::nullopt, known(2.0, 0.001)}}, stetro_site::Flight(spec));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(all[0].site_m, 2.05 + 0.1 * 7.5 / 16.0, 1e-12);
}

}  // namespace
}  // namespace stetro_localizer
