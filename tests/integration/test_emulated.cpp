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

// The real robot's driver, its devices emulated at the other end of their wires.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "nlohmann/json.hpp"
#include "stetro_tests/deadline.hpp"
#include "stetro_tests/demo_run.hpp"
#include "stetro_tests/stack.hpp"

namespace stetro_tests
{

TEST(EmulatedDevices, CarryAClimb)
{
  DemoRun demo({"--hardware", "emulated", "--site", short_flight(), "--no-plots", "--seed", "5"});
  ASSERT_EQ(demo.wait(600s), 0) << demo.tail();
  const auto summary = nlohmann::json::parse(demo.file("summary.json"));
  EXPECT_EQ(summary["final_step"], 4);
  EXPECT_EQ(summary["integrity"], "OK");
  EXPECT_LT(summary["y_rmse_m"], 0.015);
  EXPECT_LT(summary["heading_rmse_rad"], 0.01);
}

/// A driver alone, and a hand on it.
class Jog : public testing::Test
{
protected:
  Jog()
  {
    Parameters parameters = building_parameters(papers_staircase());
    parameters["hardware"] = "emulated";
    driver_ =
      std::make_unique<Process>(command_of("stetro_driver", parameters), domain_.environment());
  }

  /// \return exit status of `stetro_jog`, whose words are in `said_`
  /** A computer that stands still has the robot made safe: a person resets that and asks again. */
  int jog(const std::vector<std::string> & what)
  {
    const int status = jog_once(what);
    if (said_.find("refused: the hardware has a fault") == std::string::npos) {
      return status;
    }
    EXPECT_EQ(jog_once({"reset"}), 0) << said_;
    return jog_once(what);
  }

  LoopbackDomain domain_;
  std::unique_ptr<Process> driver_;
  std::string said_;

private:
  int jog_once(const std::vector<std::string> & what)
  {
    std::vector<std::string> command{find_executable("stetro_jog")};
    command.insert(command.end(), what.begin(), what.end());
    command.insert(command.end(), {"--ros-args", "-p", "use_sim_time:=true"});
    Process hand{command, domain_.environment()};
    const auto ending = hand.wait(30s);
    said_ = hand.tail() + driver_->tail();
    return ending ? ending->exit_code : -1;
  }
};

TEST_F(Jog, MovesOnePartAfterTheOther)
{
  EXPECT_EQ(jog({"lift", "--block", "1"}), 0) << said_;
  EXPECT_EQ(jog({"lower", "--block", "1"}), 0) << said_;
  EXPECT_EQ(jog({"steer", "--angle", "90"}), 0) << said_;
  EXPECT_EQ(jog({"roll", "--vy", "0.05", "--seconds", "0.5"}), 0) << said_;
  EXPECT_EQ(jog({"reset"}), 0) << said_;
}

TEST_F(Jog, SaysWhyItIsRefused)
{
  ASSERT_EQ(jog({"lift", "--block", "1"}), 0) << said_;
  EXPECT_EQ(jog({"lift", "--block", "2"}), 1);
  EXPECT_NE(said_.find("only while 1 and 3 stand"), std::string::npos) << said_;
  EXPECT_EQ(jog({"roll", "--vy", "0.05"}), 1);
  EXPECT_NE(said_.find("wheels at"), std::string::npos) << said_;
}

}  // namespace stetro_tests
