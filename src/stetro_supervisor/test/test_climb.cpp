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

#include "stetro_supervisor/mission.hpp"
#include "support/toy_robot.hpp"

namespace stetro_supervisor
{

class ClosedLoop : public testing::Test
{
protected:
  void start()
  {
    climb.tick(robot.now, robot.look());
    const auto answer = mission.request({"1", "test", RequestKind::kCleanFlight, "flight"});
    ASSERT_TRUE(answer.accepted) << answer.reason;
  }

  ToyRobot robot{stairs(3)};
  Climb climb{ClimbParams{}, stairs(3)};
  Mission mission{climb, flight_of(climb.geometry())};
};

TEST_F(ClosedLoop, ClimbsThreeStepsAndSweepsEveryTread)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kFinished)) << where(climb, robot);
  EXPECT_EQ(climb.record().step, 3);
  EXPECT_NEAR(robot.z_m[0], 3 * 0.14, 1e-9);
  EXPECT_NEAR(robot.z_m[2], 3 * 0.14, 1e-9);
  for (const double share : mission.status().swept_share) {
    EXPECT_GT(share, 0.99);
  }
  EXPECT_NEAR(robot.y_m, 2.05 / 2, 0.02);
}

TEST_F(ClosedLoop, ClimbsWithAHeadingThatKeepsDrifting)
{
  start();
  robot.turn_disturbance_rps = 0.6 * kRadPerDeg;
  ASSERT_TRUE(run_to_state(climb, robot, State::kFinished, 1200.0)) << where(climb, robot);
}

TEST_F(ClosedLoop, KeepsOneCentimetreFromTheRiserWhileSweeping)
{
  start();
  robot.turn_disturbance_rps = -0.6 * kRadPerDeg;
  double nearest = 1.0;
  double farthest = 0.0;
  const auto done = [&] {
    if (climb.state() == State::kSweepRight && climb.record().step == 1) {
      const double gap = 0.32 - (robot.x_m + 0.075);
      nearest = std::min(nearest, gap);
      farthest = std::max(farthest, gap);
    }
    return climb.record().step == 2;
  };
  ASSERT_TRUE(run_until(climb, robot, 600.0, done)) << where(climb, robot);
  EXPECT_GT(nearest, 0.0);
  EXPECT_LT(farthest, 0.02);
}

TEST_F(ClosedLoop, TrimsWhenASlipTookItOffItsLine)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepRight)) << where(climb, robot);
  robot.x_m -= 0.015;  // unnoticed by the wheels, seen by the front pair
  ASSERT_TRUE(run_to_state(climb, robot, State::kTrimAlong, 20.0)) << where(climb, robot);
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepRight, 20.0)) << where(climb, robot);
  EXPECT_NEAR(0.32 - (robot.x_m + 0.075), 0.010, 0.004);
}

TEST_F(ClosedLoop, SweepsRightFirstWhenTold)  // D1-15
{
  ClimbParams params;
  params.sweep_order = "right_first";
  Climb other{params, stairs(3)};
  Mission orders{other, flight_of(other.geometry())};
  other.tick(robot.now, robot.look());
  ASSERT_TRUE(orders.request({"1", "test", RequestKind::kCleanFlight, "flight"}).accepted);
  ASSERT_TRUE(run_to_state(other, robot, State::kSweepRight)) << where(other, robot);
  ASSERT_TRUE(run_to_state(other, robot, State::kFinished)) << where(other, robot);
}

TEST_F(ClosedLoop, CreepsBeforeAWall)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepLeft)) << where(climb, robot);
  double last_vy = 1.0;
  run_until(climb, robot, 60.0, [&] {
    if (climb.state() == State::kSweepLeft) {
      last_vy = climb.tick(robot.now, robot.look()).vy_mps;
    }
    return climb.state() != State::kSweepLeft;
  });
  EXPECT_LT(last_vy, 1.5 * climb.params().creep_speed_mps);
}

}  // namespace stetro_supervisor
