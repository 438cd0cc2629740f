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

#include <limits>
#include <string>

#include "stetro_site/standing_place.hpp"

namespace stetro_site
{
namespace
{

// The papers' steps: tread i spans x in [(i - 1) 0.32, i 0.32] at z = i 0.14.
Flight four_steps()
{
  FlightSpec spec;
  spec.id = "stairs";
  spec.steps = equal_steps(4, 0.14, 0.32);
  spec.width_foot_m = 2.05;
  spec.width_top_m = 2.05;
  return Flight(spec);
}

std::string why(const Pose & pose) { return misplaced(pose, four_steps()).value_or(""); }

TEST(StandingPlace, IsAnyBetweenTheWallsAtTheHeightOfItsStep)
{
  EXPECT_EQ(why({-0.6, 1.0, 0.0, 0.0}), "");
  EXPECT_EQ(why({0.8, 1.0, 3 * 0.14, 0.2}), "");
  EXPECT_EQ(why({0.8, 1.0, 3 * 0.14 + 0.069, 0.2}), "") << "half a riser is allowed";
  EXPECT_EQ(why({2.0, 0.0, 4 * 0.14, 0.0}), "") << "the landing, which goes on from the last tread";
}

TEST(StandingPlace, RefusesAnotherHeightAndSaysWhichStepItWouldBe)
{
  const std::string floor_height = why({0.8, 1.0, 0.0, 0.0});  // x 0.8 lies on tread 3
  EXPECT_NE(floor_height.find("z 0.000 m"), std::string::npos) << floor_height;
  EXPECT_NE(floor_height.find("step 3"), std::string::npos) << floor_height;
  EXPECT_NE(floor_height.find("0.350 m to 0.490 m"), std::string::npos) << floor_height;
}

TEST(StandingPlace, RefusesAPlaceInAWallOrNoPlaceAtAll)
{
  EXPECT_NE(why({0.8, 2.06, 3 * 0.14, 0.0}).find("0.000 m to 2.050 m"), std::string::npos);
  EXPECT_NE(why({0.8, -0.01, 3 * 0.14, 0.0}).find("between the walls"), std::string::npos);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const Pose & pose :
       {Pose{kNan, 1.0, 0.0, 0.0}, Pose{0.0, kNan, 0.0, 0.0}, Pose{0.0, 1.0, kNan, 0.0},
        Pose{0.0, 1.0, 0.0, kNan}}) {
    EXPECT_NE(why(pose).find("finite"), std::string::npos);
  }
}

}  // namespace
}  // namespace stetro_site
