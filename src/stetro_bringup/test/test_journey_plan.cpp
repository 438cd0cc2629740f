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
#include <set>
#include <stdexcept>

#include "journey_plan.hpp"

namespace stetro_bringup
{
namespace
{

stetro_site::Deployment two_floors()
{
  return stetro_site::load_deployment(CONFIG "site/two_floors.yaml", CONFIG "robot/stetro.yaml");
}

}  // namespace

TEST(JourneyPlan, StartsAnywhereOnTheFloorBelowClearOfAllThatStandsThere)
{
  const auto deployment = two_floors();
  const auto & flight = deployment.site.flight("lower");
  std::set<int> quarters;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto in_map =
      flight.T_map_flight().to_map(plan_journey(deployment, "lower", "first", seed).start);
    // The body turns within 0.253 m of its middle: walls, column and stairs are farther than that.
    EXPECT_GT(in_map.x_m, 0.253);
    EXPECT_LT(in_map.x_m, 4.5);
    EXPECT_GT(in_map.y_m, 0.253);
    EXPECT_LT(in_map.y_m, 4.0 - 0.253);
    EXPECT_GT(std::hypot(in_map.x_m - 2.5, in_map.y_m - 2.0), 0.2 + 0.253);
    EXPECT_GT(std::hypot(in_map.x_m - 4.5, in_map.y_m - 1.025), 1.5 - 1e-9);
    quarters.insert((in_map.x_m > 2.5 ? 1 : 0) + (in_map.y_m > 2.0 ? 2 : 0));
  }
  EXPECT_GE(quarters.size(), 3u) << "not always in one corner";
}

TEST(JourneyPlan, KnowsTheFloorsOfTheWay)
{
  const auto plan = plan_journey(two_floors(), "lower", "first", 1);
  ASSERT_EQ(plan.floors.size(), 3u);
  EXPECT_EQ(plan.floors[0].floor, "ground");
  EXPECT_EQ(plan.floors[1].floor, "landing");
  EXPECT_EQ(plan.floors[2].floor, "first");
  EXPECT_GT(plan.floors[0].least_s, 1.5 / 0.3);
  // From (10.57, 1.025) to (10.62, 3.575) with 0.3 m/s, after 0.45 m with 0.1 m/s, at least.
  EXPECT_GT(plan.floors[1].least_s, 4.5 + 2.55 / 0.3);
  EXPECT_LT(plan.floors[1].least_s, 4.5 + 4.0 / 0.3) << "nor by a long way round";
  EXPECT_NEAR(plan.floors[2].least_s, 4.5, 1e-9) << "it ends where it has rolled off";
}

TEST(JourneyPlan, SaysWhyThereIsNoWay)
{
  EXPECT_THROW(
    static_cast<void>(plan_journey(two_floors(), "upper", "ground", 1)), std::runtime_error);
}

TEST(KidnapsOnFloors, OneOnEachWhileTheRobotDrivesThere)
{
  const std::vector<FloorDriving> floors{{"ground", 10.0}, {"landing", 20.0}};
  std::set<std::string> different;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto faults = with_kidnaps_on_floors({"dead:side_left@5", "kidnap"}, floors, seed);
    ASSERT_EQ(faults.size(), 3u);
    EXPECT_EQ(faults[0], "dead:side_left@5");
    EXPECT_EQ(faults[1].rfind("kidnap:ground@", 0), 0u) << faults[1];
    EXPECT_EQ(faults[2].rfind("kidnap:landing@", 0), 0u) << faults[2];
    const double moment_s = std::stod(faults[2].substr(15));
    EXPECT_GE(moment_s, 4.0);
    EXPECT_LE(moment_s, 16.0);
    EXPECT_EQ(faults, with_kidnaps_on_floors({"dead:side_left@5", "kidnap"}, floors, seed));
    EXPECT_EQ(floors_of_kidnaps(faults), (std::vector<std::string>{"ground", "landing"}));
    different.insert(faults[2]);
  }
  EXPECT_EQ(different.size(), 10u);
}

}  // namespace stetro_bringup
