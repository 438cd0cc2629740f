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

// The localizer dies in mid-climb: the robot stops, and goes on by itself once the pose is sound.

#include <gtest/gtest.h>

#include <string>

#include "integration/simulated_time.hpp"

namespace stetro_tests
{

class LocalizerLost : public testing::TestWithParam<Moment>
{
protected:
  RobotRun run_;
};

TEST_P(LocalizerLost, RobotStopsAndGoesOnByItself)
{
  using namespace stetro_msgs::msg;  // NOLINT(build/namespaces)
  ASSERT_EQ(run_.start_climb(), "");
  ASSERT_EQ(wait_moment(run_, GetParam()), "");
  const std::size_t first_truth = run_.truth.count() - 1;
  const auto killed = now_simulated(run_);
  run_.stack.localizer().kill_hard();

  ASSERT_TRUE(let_pass(run_, 3s));
  const auto stopped = last_motion(run_.truth.samples(first_truth));
  EXPECT_LE(stopped - killed, 1s) << "the supervisor must miss it within a second";
  const auto held = now_simulated(run_);

  run_.pose.forget();
  run_.stack.start_localizer();
  const auto sound = run_.pose.wait_for(
    [](const StairPose & pose) { return pose.integrity() == StairPose_Constants::INTEGRITY_OK; },
    kPatience);
  ASSERT_TRUE(sound) << run_.stack.tails();
  EXPECT_EQ(sound->step_index(), run_.truth.last()->step_index());
  ASSERT_TRUE(let_pass(run_, 5s));
  EXPECT_NE(last_motion(truths_after(run_, first_truth, held)).count(), 0)
    << "the climb goes on within 5 s\n"
    << run_.stack.tails();
  EXPECT_EQ(wait_moment(run_, {"sweep_left", GetParam().step + 1}), "");
  EXPECT_EQ(contradicted_step(run_, first_truth), "");
}

INSTANTIATE_TEST_SUITE_P(
  InMidClimb, LocalizerLost,
  testing::Values(
    Moment{"sweep_right", 1}, Moment{"roll_block3_to_riser", 2}, Moment{"roll_to_riser", 1}),
  testing::PrintToStringParamName());

}  // namespace stetro_tests
