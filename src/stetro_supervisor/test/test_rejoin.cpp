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

#include <string>

#include "stetro_supervisor/mission.hpp"
#include "stetro_supervisor/rejoin.hpp"
#include "support/toy_robot.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kR = 0.14;
constexpr double kUp = 0.18;

struct Case
{
  const char * name;
  double h1, h2, h3;  ///< heights above the lowest underside [m]
  bool block2_touches;
  State state;  ///< the mission's
  int mission_step;
  int localizer_step;
  std::optional<State> entry;
};

const Case kCases[] = {
  {"floor", 0, 0, 0, true, State::kApproach, 0, 0, State::kSteerToFind},
  {"floor_not_lifted", 0, 0, 0, true, State::kLiftBlock1, 0, 0, State::kSteerToFind},
  {"block1_up_at_riser_1", kUp, 0, 0, true, State::kRollToRiser, 0, 0, State::kLiftBlock1},
  {"block1_on_tread_1", kR, 0, 0, true, State::kLowerBlock1, 0, 0, State::kLowerBlock1},
  {"sweeping", kR, 0, 0, true, State::kSweepLeft, 2, 2, State::kSteerAcross},
  {"sweeping_wrong_step", kR, 0, 0, true, State::kSweepLeft, 2, 3, std::nullopt},
  {"not_lifted_yet", kR, 0, 0, true, State::kLiftBlock2, 2, 2, State::kSteerAcross},
  {"block2_half_up", kR, 0.07, 0, false, State::kLiftBlock2, 2, 2, State::kLiftBlock2},
  {"block2_at_riser_height", kR, kR, 0, false, State::kLiftBlock2, 2, 2, State::kLiftBlock2},
  {"block2_locked", kR, kUp, 0, false, State::kRollBlock3ToRiser, 2, 2, State::kLiftBlock2},
  {"block2_up_counted", kR, kUp, 0, false, State::kLowerBlock2, 2, 3, std::nullopt},
  {"block2_down", kR, kR, 0, true, State::kLowerBlock2, 2, 2, State::kConfirmStep},
  {"block2_down_counted", kR, kR, 0, true, State::kConfirmStep, 2, 3, State::kConfirmStep},
  {"block2_down_twice", kR, kR, 0, true, State::kConfirmStep, 2, 4, std::nullopt},
  {"step_taken", kR, kR, 0, true, State::kLiftBlock3, 3, 3, State::kLiftBlock3},
  {"block3_passes_level", 0, 0, 0, true, State::kLiftBlock3, 3, 3, State::kLiftBlock3},
  {"block3_up", 0, 0, 0.04, true, State::kLiftBlock1, 3, 3, State::kLiftBlock3},
  {"blocks_1_and_3_up", kUp, 0, 0.04, true, State::kRollToRiser, 3, 3, State::kLiftBlock3},
  {"block1_down_again", kR, 0, 0.04, true, State::kLowerBlock3, 3, 3, State::kLiftBlock3},
  {"block3_nearly_down", kR, 0, 0.01, true, State::kLowerBlock3, 3, 3, State::kLowerBlock3},
  {"block3_down_on_top", 0, 0, 0, true, State::kLowerBlock3, 4, 4, State::kLowerBlock3},
  {"sweeping_the_top", 0, 0, 0, true, State::kSweepRight, 4, 4, State::kSteerAcross},
  {"level_in_mid_flight", 0, 0, 0, true, State::kSweepRight, 2, 2, std::nullopt},
  {"stride_on_the_top", kR, 0, 0, true, State::kSweepRight, 4, 4, std::nullopt},
  {"block2_up_while_sweeping", kR, kUp, 0, false, State::kSweepLeft, 2, 2, std::nullopt},
  {"new_on_the_floor", 0, 0, 0, true, State::kIdle, 0, 0, State::kSteerToFind},
  {"new_on_a_tread", kR, 0, 0, true, State::kIdle, 2, 2, State::kSteerAcross},
  {"new_in_mid_lift", kR, kUp, 0, false, State::kIdle, 2, 2, std::nullopt},
};

}  // namespace

class EntryTable : public testing::TestWithParam<Case>
{
};

TEST_P(EntryTable, ChoosesByPostureStepAndMission)
{
  const Case & c = GetParam();
  const ClimbParams params;
  const ClimbGeometry geometry = stairs(4);
  ToyRobot robot{geometry};
  Observation seen = robot.look();
  const double heights[] = {c.h1, c.h2, c.h3};
  for (std::size_t i = 0; i < 3; ++i) {
    seen.blocks->block[i].height_m = heights[i];
    seen.blocks->block[i].at_upper_lock = heights[i] == kUp;
  }
  seen.pose->step = c.localizer_step;
  Memory memory;
  memory.record.state = c.state;
  memory.record.step = c.mission_step;
  for (int i = 0; i < 3; ++i) {
    const double below = c.block2_touches ? 0.036 : 0.15;
    memory.medians[static_cast<std::size_t>(Place::kBlock2Down)].take(
      {robot.now + Time{i}, below, RangeStatus::kValid});
  }
  const auto choice =
    choose_entry({params, geometry, seen, memory, State::kRejoin, robot.now, robot.now});
  EXPECT_EQ(choice.entry, c.entry) << choice.refusal;
  EXPECT_EQ(choice.refusal.empty(), c.entry.has_value());
}

INSTANTIATE_TEST_SUITE_P(
  Rows, EntryTable, testing::ValuesIn(kCases),
  [](const testing::TestParamInfo<Case> & c) { return std::string(c.param.name); });

class Restart : public testing::TestWithParam<State>
{
};

TEST_P(Restart, ComesUpHeldAndGoesOnFromTheRightStep)
{
  ToyRobot robot{stairs(2)};
  Climb before{ClimbParams{}, stairs(2)};
  Mission first{before, flight_of(before.geometry())};
  before.tick(robot.now, robot.look());
  ASSERT_TRUE(first.request({"1", "test", RequestKind::kCleanFlight, "flight"}).accepted);
  ASSERT_TRUE(run_to_state(before, robot, GetParam())) << where(before, robot);

  Climb after{ClimbParams{}, stairs(2)};
  after.restore(decode(encode(before.record())));
  Mission second{after, flight_of(after.geometry())};
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(after.tick(robot.now, robot.look()).moves()) << "before a resume request";
    robot.act(hold(), 0.05);
  }
  EXPECT_EQ(after.state(), State::kHeld);
  EXPECT_EQ(after.record().step, before.record().step);
  EXPECT_TRUE(second.request({"1", "test", RequestKind::kCleanFlight, "flight"}).accepted)
    << "the request that began this mission, sent again";
  after.tick(robot.now, robot.look());
  EXPECT_EQ(after.state(), State::kHeld);
  const auto answer = second.request({"2", "test", RequestKind::kResume, ""});
  ASSERT_TRUE(answer.accepted) << answer.reason;
  ASSERT_TRUE(run_to_state(after, robot, State::kFinished)) << where(after, robot);
  EXPECT_EQ(after.record().step, 2);
  EXPECT_NEAR(robot.z_m[1], 2 * kR, 1e-6);
}

TEST_P(Restart, RefusesToGoOnWithAnotherStep)
{
  ToyRobot robot{stairs(2)};
  Climb before{ClimbParams{}, stairs(2)};
  Mission first{before, flight_of(before.geometry())};
  before.tick(robot.now, robot.look());
  ASSERT_TRUE(first.request({"1", "test", RequestKind::kCleanFlight, "flight"}).accepted);
  ASSERT_TRUE(run_to_state(before, robot, GetParam())) << where(before, robot);

  Climb after{ClimbParams{}, stairs(2)};
  after.restore(before.record());
  Mission second{after, flight_of(after.geometry())};
  robot.meddle = [](Observation & o) { o.pose->step += 2; };
  for (int i = 0; i < 5; ++i) {
    after.tick(robot.now, robot.look());
    robot.act(hold(), 0.05);
  }
  const auto answer = second.request({"2", "test", RequestKind::kResume, ""});
  EXPECT_FALSE(answer.accepted);
  EXPECT_FALSE(answer.reason.empty());
  EXPECT_FALSE(after.tick(robot.now, robot.look()).moves());
}

INSTANTIATE_TEST_SUITE_P(
  States, Restart,
  testing::Values(
    State::kSteerToFind, State::kApproach, State::kLiftBlock1, State::kRollToRiser,
    State::kLowerBlock1, State::kBackOff, State::kSteerAcross, State::kSquare, State::kSteerAlong,
    State::kLiftBlock2, State::kRollBlock3ToRiser, State::kLowerBlock2, State::kConfirmStep,
    State::kLiftBlock3, State::kLowerBlock3, State::kSweepLeft, State::kSweepRight,
    State::kSweepToMiddle, State::kCheckTop),
  [](const testing::TestParamInfo<State> & state) { return std::string(to_string(state.param)); });

}  // namespace stetro_supervisor
