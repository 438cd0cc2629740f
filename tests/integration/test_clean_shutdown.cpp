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

// SIGINT and SIGTERM end each process in order: exit code 0, soon.

#include <gtest/gtest.h>
#include <signal.h>

#include "stetro_tests/robot_run.hpp"

namespace stetro_tests
{

class CleanShutdown : public testing::TestWithParam<int>
{
};

TEST_P(CleanShutdown, EveryProcessReturnsZeroWithinThreeSeconds)
{
  RobotRun run;
  ASSERT_EQ(run.wait_ready(), "");
  for (Process * process : {&run.stack.supervisor(), &run.stack.localizer(), &run.stack.driver()}) {
    process->signal(GetParam());
    const auto ending = process->wait(3s);
    ASSERT_TRUE(ending) << process->tail();
    EXPECT_EQ(ending->exit_code, 0) << "signal " << ending->signal << "\n" << process->tail();
  }
}

INSTANTIATE_TEST_SUITE_P(Signals, CleanShutdown, testing::Values(SIGINT, SIGTERM));

}  // namespace stetro_tests
