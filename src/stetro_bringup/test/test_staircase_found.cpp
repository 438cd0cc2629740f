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

#include "stetro_bringup/staircase_found.hpp"

namespace stetro_bringup
{

// As the localizer writes them, see staircase_report.hpp there.
TEST(StaircaseFound, ReadsWhatTheLocalizerSays)
{
  StaircaseFound found;
  note(found, "steps measured", "2");
  note(found, "largest deviation [m]", "0.041204");
  note(found, "largest deviation of", "tread of step 7");
  note(found, "step 6: tread, sigma, width, sigma [m]", "0.321000 0.001100 2.051310 0.001806");
  note(found, "step 7: tread, sigma, width, sigma [m]", "0.361204 0.001125 nan nan");
  note(found, "step 7: tread, sigma, site file [m]", "0.361204 0.001125 0.320000");
  EXPECT_NEAR(found.largest_deviation_m, 0.041204, 1e-12);
  EXPECT_EQ(found.largest_deviation_of, "tread of step 7");
  ASSERT_EQ(found.steps.size(), 2u);
  EXPECT_EQ(found.steps[0].step, 6);
  EXPECT_NEAR(found.steps[0].tread_m, 0.321, 1e-12);
  EXPECT_NEAR(found.steps[0].width_sigma_m, 0.001806, 1e-12);
  EXPECT_TRUE(std::isnan(found.steps[1].width_m));
  EXPECT_EQ(found.treads_measured(), 2u);
  ASSERT_EQ(found.deviations.size(), 1u);
  EXPECT_EQ(found.deviations[0].step, 7);
  EXPECT_EQ(found.deviations[0].measure, "tread");
  EXPECT_NEAR(found.deviations[0].site_m, 0.32, 1e-12);
}

TEST(StaircaseFound, PassesOverWhatIsNoMeasure)
{
  StaircaseFound found;
  note(found, "step", "3");
  note(found, "step x: tread, sigma, width, sigma [m]", "1 2 3 4");
  note(found, "step 3: tread, sigma, width, sigma [m]", "0.32 0.001 2.05");
  note(found, "step 3: tread, sigma, width, sigma [m]", "0.32 0.001 2.05 0.001 more");
  note(found, "step 3: tread, sigma, site file [m]", "deep");
  note(found, "largest deviation [m]", "unknown");
  EXPECT_TRUE(found.steps.empty());
  EXPECT_TRUE(found.deviations.empty());
  EXPECT_TRUE(std::isnan(found.largest_deviation_m));
}

}  // namespace stetro_bringup
