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

#include "stetro_localizer/fused/as_built_record.hpp"
#include "support/standing_robot.hpp"

namespace stetro_localizer
{
namespace
{

StepAsBuilt found(int step, double tread_m, double sigma)
{
  return {step, ScalarEstimate{tread_m, sigma * sigma}, std::nullopt};
}

class AsBuiltRecordTest : public ::testing::Test
{
protected:
  void leave(const StepAsBuilt & step)
  {
    core.left_behind = step;
    record.follow(core);
  }

  FusedModel model{LocalizerParams{}, stetro_site::RobotGeometry{}, papers_flight()};
  FusedCore core = model.begin();
  AsBuiltRecord record{16};
};

TEST_F(AsBuiltRecordTest, KnowsWhatWasLeftAndWhatIsHere)
{
  EXPECT_TRUE(record.steps(core, {}).empty());
  leave(found(1, 0.321, 0.001));
  leave(found(2, 0.322, 0.001));
  const auto steps = record.steps(core, found(3, 0.323, 0.002));
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps[0].step, 1);
  EXPECT_EQ(steps[1].tread_m->value, 0.322);
  EXPECT_EQ(steps[2].tread_m->value, 0.323);
}

// What a late sample may still change is not in the record, but it is told.
TEST_F(AsBuiltRecordTest, TellsAStepThatWasLeftAMomentAgo)
{
  leave(found(1, 0.321, 0.001));
  FusedCore newest = core;
  newest.left_behind = found(2, 0.322, 0.001);
  EXPECT_EQ(record.steps(newest, found(3, 0.323, 0.002)).size(), 3u);
  EXPECT_EQ(record.steps(core, found(2, 0.330, 0.002)).back().tread_m->value, 0.330)
    << "the change of the step was taken back";
}

TEST_F(AsBuiltRecordTest, KeepsTheBetterOfTwo)
{
  leave(found(4, 0.321, 0.001));
  leave(found(4, 0.320, 0.0024));
  EXPECT_EQ(record.steps(core, {}).front().tread_m->value, 0.321);
  leave(found(4, 0.3215, 0.0008));
  EXPECT_EQ(record.steps(core, {}).front().tread_m->value, 0.3215);
  leave({4, std::nullopt, ScalarEstimate{2.051, 1e-6}});
  EXPECT_EQ(record.steps(core, {}).front().tread_m->value, 0.3215);
  EXPECT_EQ(record.steps(core, {}).front().width_m->value, 2.051);
}

TEST_F(AsBuiltRecordTest, BeginsAnewWithARobotThatIsLocatedAnew)
{
  leave(found(1, 0.321, 0.001));
  FusedCore elsewhere = core;
  model.locate(elsewhere, 7);
  EXPECT_EQ(elsewhere.left_behind.step, 0);
  EXPECT_TRUE(record.steps(elsewhere, {}).empty()) << "at once";
  record.follow(elsewhere);
  EXPECT_TRUE(record.steps(elsewhere, {}).empty()) << "and for good";
}

// A tread of which nothing was learned is not one that was measured.
TEST(AsBuiltHere, IsWhatWasLearned)
{
  StandingRobot robot;
  FusedModel model{LocalizerParams{}, stetro_site::RobotGeometry{}, papers_flight()};
  ASSERT_EQ(robot.core.located_on, 3);
  EXPECT_EQ(model.as_built_here(robot.core).step, 3);
  EXPECT_FALSE(model.as_built_here(robot.core).tread_m);
  ASSERT_TRUE(model.as_built_here(robot.core).width_m);
  EXPECT_EQ(model.as_built_here(robot.core).width_m->value, kWidth);
  robot.know(kStateTreadHere, 0.317, 0.001);
  ASSERT_TRUE(model.as_built_here(robot.core).tread_m);
  EXPECT_EQ(model.as_built_here(robot.core).tread_m->value, 0.317);
  robot.core.located_on = 0;
  EXPECT_EQ(model.as_built_here(robot.core).step, 0) << "the floor is no step";
}

/// The blocks as they stand for sweeping `step`; the steps are told, not counted.
void go_to(StandingRobot & robot, int step)
{
  robot.core.steps.tell(step);
  BlockSample blocks;
  blocks.stamp = robot.core.time + std::chrono::milliseconds(33);
  blocks.blocks[0] = {0.14, 0.33, true, false, false};
  blocks.blocks[1] = blocks.blocks[2] = {0.0, 0.33, true, false, false};
  for (int i = 0; i < 10 && robot.core.located_on != step; ++i) {
    robot.take(blocks);
    blocks.stamp += std::chrono::milliseconds(33);
  }
  ASSERT_EQ(robot.core.located_on, step);
}

TEST(LeavingAStep, KeepsItsTreadAndMovesTheEdge)
{
  StandingRobot robot;
  robot.know(kStateTreadHere, 0.317, 0.001);
  const double edge_m = robot.core.edge_x_m;
  const std::uint32_t jumps = robot.core.jumps;
  go_to(robot, 4);
  ASSERT_EQ(robot.core.jumps, jumps) << "a step, not a jump";
  EXPECT_EQ(robot.core.left_behind.step, 3);
  EXPECT_EQ(robot.core.left_behind.tread_m->value, 0.317);
  EXPECT_NEAR(robot.core.edge_x_m, edge_m + 0.32, 1e-12);
  const double doubt = robot.core.filter.edge_variance();
  EXPECT_NEAR(doubt, 4 * 0.0025 * 0.0025, 1e-12) << "by the site file, the first three treads too";
  go_to(robot, 3);
  EXPECT_EQ(robot.core.left_behind.step, 4);
  EXPECT_NEAR(robot.core.filter.edge_variance(), 3 * 0.0025 * 0.0025, 1e-12);
}

}  // namespace
}  // namespace stetro_localizer
