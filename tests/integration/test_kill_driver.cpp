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

// The driver dies in mid-climb, and with it the simulated world: it comes back where it was,
// standing, and nothing moves until someone asks.

#include <gtest/gtest.h>
#include <signal.h>

#include <string>

#include "integration/simulated_time.hpp"

namespace stetro_tests
{

class DriverLost : public testing::TestWithParam<Moment>
{
protected:
  RobotRun run_;
};

TEST_P(DriverLost, WorldResumesStandingAndWaitsToBeAsked)
{
  ASSERT_EQ(run_.start_climb(), "");
  ASSERT_EQ(wait_moment(run_, GetParam()), "");
  const std::size_t first_truth = run_.truth.count() - 1;
  run_.stack.driver().kill_hard();
  const auto before = run_.truth.last();

  run_.truth.forget();
  run_.stack.start_driver();
  const auto after = run_.truth.wait_next(kPatience);
  ASSERT_TRUE(after) << run_.stack.tails();
  EXPECT_EQ(after->step_index(), before->step_index());
  EXPECT_LT(between(*before, *after).position_m, 0.03)
    << "before " << to_string(*before) << ", after " << to_string(*after);
  EXPECT_LT(between(*before, *after).blocks_m, 0.03);

  const std::size_t first_after = run_.truth.count() - 1;
  ASSERT_TRUE(let_pass(run_, 4s));
  const Truths waiting = run_.truth.samples(first_after);
  EXPECT_EQ(last_motion(waiting).count(), 0)
    << "nothing may move before it is asked to, but from " << to_string(waiting.front().message)
    << " at " << time_of(waiting.front().message).count() << " ns it came to "
    << to_string(waiting.back().message) << "\n"
    << run_.stack.tails();

  ASSERT_EQ(run_.operators.resume(kPatience), "") << run_.stack.tails();
  EXPECT_EQ(wait_moment(run_, {"sweep_left", GetParam().step + 1}), "");
  EXPECT_EQ(contradicted_step(run_, first_truth), "");
}

INSTANTIATE_TEST_SUITE_P(
  InMidClimb, DriverLost,
  testing::Values(
    Moment{"sweep_left", 1}, Moment{"roll_block3_to_riser", 2}, Moment{"lower_block2", 1}),
  testing::PrintToStringParamName());

}  // namespace stetro_tests
