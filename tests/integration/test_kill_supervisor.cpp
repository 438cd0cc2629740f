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

// The supervisor dies in mid-climb: the robot holds on by itself, and goes on only when asked to.

#include <gtest/gtest.h>
#include <signal.h>

#include <string>

#include "integration/simulated_time.hpp"

namespace stetro_tests
{

constexpr auto kHoldWithin = 200ms;  // simulated, after the last valid command

class SupervisorLost : public testing::TestWithParam<Moment>
{
protected:
  void climb_to_moment()
  {
    ASSERT_EQ(run_.start_climb(), "");
    ASSERT_EQ(wait_moment(run_, GetParam()), "");
    first_truth_ = run_.truth.count() - 1;
  }

  /// Nothing moved later than 200 ms after the last command, and nothing moves for a while now.
  void expect_holding()
  {
    ASSERT_TRUE(let_pass(run_, 2s)) << run_.stack.tails();
    const auto last = last_motion(run_.truth.samples(first_truth_));
    const auto command = last_command(run_);
    EXPECT_LE((last - command).count(), std::chrono::nanoseconds(kHoldWithin).count())
      << "moved until " << last.count() << " ns, last command " << command.count() << " ns";
  }

  RobotRun run_;
  std::size_t first_truth_ = 0;
};

TEST_P(SupervisorLost, RobotHoldsAndAFreshSupervisorWaitsToBeAsked)
{
  climb_to_moment();
  run_.stack.supervisor().kill_hard();
  expect_holding();

  run_.operators.status().forget();
  run_.stack.start_supervisor();
  ASSERT_TRUE(run_.operators.status().wait_next(kPatience)) << run_.stack.tails();
  const auto restarted = now_simulated(run_);
  ASSERT_TRUE(let_pass(run_, 3s));
  EXPECT_EQ(last_motion(truths_after(run_, first_truth_, restarted)).count(), 0)
    << "nothing may move before it is asked to";

  ASSERT_EQ(run_.operators.resume(kPatience), "") << run_.stack.tails();
  EXPECT_EQ(wait_moment(run_, {"sweep_left", GetParam().step + 1}), "");
  EXPECT_EQ(contradicted_step(run_, first_truth_), "");
}

TEST_P(SupervisorLost, RobotHoldsWhileTheSupervisorIsFrozen)
{
  climb_to_moment();
  run_.stack.supervisor().pause();
  expect_holding();
  run_.stack.supervisor().go_on();
  ASSERT_TRUE(let_pass(run_, 3s));
  EXPECT_EQ(contradicted_step(run_, first_truth_), "");
  EXPECT_TRUE(run_.stack.supervisor().running()) << run_.stack.tails();
}

INSTANTIATE_TEST_SUITE_P(
  InMidClimb, SupervisorLost,
  testing::Values(Moment{"sweep_left", 1}, Moment{"roll_block3_to_riser", 2}),
  testing::PrintToStringParamName());

}  // namespace stetro_tests
