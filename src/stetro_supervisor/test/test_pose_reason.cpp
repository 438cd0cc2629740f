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

#include <cstdint>
#include <string>

#include "stetro_supervisor/mission.hpp"
#include "stetro_supervisor/pose_reason.hpp"
#include "support/toy_robot.hpp"

namespace stetro_supervisor
{

TEST(PoseReason, EveryBitOfTheWireHasItsWords)
{
  const char * const words[] = {
    "no side range",
    "no front reference",
    "step uncertain",
    "not initialised",
    "input silent",
    "state file damaged",
    "closure violated",
    "sensor stuck",
    "sensor dead",
    "profile disagrees",
    "protection exceeded",
    "clock jump",
    "contact conflict",
    "slip",
    "sensor calibration beyond trust",
    "heading conflict",
    "off the tread",
    "contact closure too large"};
  for (std::uint32_t bit = 0; bit < 18; ++bit) {
    EXPECT_EQ(reasons_in_words(1u << bit), words[bit]);
  }
}

TEST(PoseReason, SeveralAreAListAndUnknownOnesAreNotHidden)
{
  EXPECT_EQ(reasons_in_words(1 | 4096), "no side range, contact conflict");
  EXPECT_EQ(reasons_in_words(8192 | 262144), "slip, reason 262144 without a name");
  EXPECT_EQ(reasons_in_words(0), "no reason given");
}

TEST(PoseReason, TheDetailOfTheStatusNamesThemAndFollowsThem)
{
  ToyRobot robot{stairs(2)};
  Climb climb{ClimbParams{}, stairs(2)};
  Mission mission{climb, flight_of(climb.geometry())};
  climb.tick(robot.now, robot.look());
  ASSERT_TRUE(mission.request({"1", "test", RequestKind::kCleanFlight, "flight"}).accepted);
  ASSERT_TRUE(run_to_state(climb, robot, State::kSquare)) << where(climb, robot);
  std::uint32_t reasons = kNoSideRange | kContactConflict;
  robot.meddle = [&reasons](Observation & o) {
    o.pose->integrity = Integrity::kDegraded;
    o.pose->reasons = reasons;
  };
  ASSERT_TRUE(run_to_state(climb, robot, State::kWaitPose, 1.0)) << where(climb, robot);
  EXPECT_EQ(
    mission.status().detail,
    "integrity is DEGRADED: no side range, contact conflict; accepted: OK");
  reasons = kNoSideRange;
  climb.tick(robot.now, robot.look());
  EXPECT_EQ(mission.status().detail, "integrity is DEGRADED: no side range; accepted: OK");
}

}  // namespace stetro_supervisor
