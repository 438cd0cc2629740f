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

#include <set>
#include <stdexcept>
#include <string>

#include "accuracy/fault_scenario.hpp"
#include "stetro_driver/sim_faults.hpp"

namespace stetro_bringup
{
namespace
{

constexpr int kSteps = 16;

TEST(FaultScenario, EveryOneIsUnderstoodByTheSimulator)
{
  for (const std::string & name : fault_scenarios()) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      const DrawnFaults drawn = draw_faults(name, seed, kSteps);
      const auto faults = stetro_driver::parse_sim_faults(drawn.text);
      ASSERT_FALSE(faults.empty()) << name << ", seed " << seed;
      EXPECT_EQ(drawn.onset.has_value(), name != "steps");
      if (drawn.onset) {
        EXPECT_NEAR(faults.front().from_s, drawn.onset->at_s, 0.01) << drawn.text;
        EXPECT_GE(drawn.onset->at_s, 100.0) << "after the first tread";
        EXPECT_LE(drawn.onset->at_s, 600.0) << "before the end";
      }
    }
  }
}

TEST(FaultScenario, TheSeedDecides)
{
  EXPECT_EQ(draw_faults("stuck", 7, kSteps).text, draw_faults("stuck", 7, kSteps).text);
  EXPECT_NE(draw_faults("stuck", 7, kSteps).text, draw_faults("stuck", 8, kSteps).text);
  EXPECT_NE(draw_faults("stuck", 7, kSteps).onset->at_s, draw_faults("dead", 7, kSteps).onset->at_s)
    << "scenarios do not strike at one time";
}

// Eight range sensors, the gyroscope, six bumpers and two riser switches.
TEST(FaultScenario, DeadAndStuckStrikeEveryDevice)
{
  for (const std::string name : {"dead", "stuck"}) {
    std::set<std::string> struck;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
      const DrawnFaults drawn = draw_faults(name, seed, kSteps);
      struck.insert(stetro_driver::parse_sim_faults(drawn.text).front().device);
    }
    EXPECT_EQ(struck.size(), 17u) << name;
  }
  EXPECT_EQ(draw_faults("stuck:block1_down@1", 1, 1).onset->telling, TellingMotion::kBlock1Rises);
  EXPECT_EQ(draw_faults("dead:block1_down@1", 1, 1).onset->telling, TellingMotion::kAny);
}

// A half of the treads, four kinds: over 100 climbs of 16 steps 200 of each are expected.
TEST(FaultScenario, StepsStrikesWithEveryKind)
{
  int slips = 0;
  int old_treads = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    for (const auto & fault :
         stetro_driver::parse_sim_faults(draw_faults("steps", seed, kSteps).text)) {
      slips += fault.kind == stetro_driver::SimFaultKind::kSlip ? 1 : 0;
      old_treads += fault.kind == stetro_driver::SimFaultKind::kOldTread ? 1 : 0;
    }
  }
  EXPECT_NEAR(slips, 200, 50);
  EXPECT_NEAR(old_treads, 200, 50);
}

TEST(FaultScenario, TheSimulatorsOwnWordsAreOnesOfTheirOwn)
{
  const DrawnFaults drawn = draw_faults("dead:side_left@120", 1, kSteps);
  EXPECT_EQ(drawn.text, "dead:side_left@120");
  EXPECT_EQ(drawn.onset->at_s, 120.0);
  EXPECT_EQ(drawn.onset->telling, TellingMotion::kNearLeftWall);
}

TEST(FaultScenario, AllIsEveryOneAndAnUnknownOneIsRefused)
{
  EXPECT_EQ(chosen_scenarios({"all"}), fault_scenarios());
  EXPECT_EQ(chosen_scenarios({"late", "dead"}).front(), "late");
  EXPECT_TRUE(chosen_scenarios({}).empty());
  EXPECT_THROW(static_cast<void>(chosen_scenarios({"melted"})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(draw_faults("melted", 1, kSteps)), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_bringup
