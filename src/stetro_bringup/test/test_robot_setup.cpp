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

#include <fstream>
#include <string>

#include "accuracy/robot_setup.hpp"
#include "stetro_config/fault.hpp"

namespace stetro_bringup
{
namespace
{

std::string written(const std::string & name, const std::string & text)
{
  const std::string path = testing::TempDir() + name;
  std::ofstream(path) << text;
  return path;
}

TEST(RobotSetup, TakesTheLocalizersParametersAndTheSimulatorsErrors)
{
  const SetupFiles files{STETRO_SITE_FILE, STETRO_ROBOT_FILE};
  const RobotSetup defaults = read_robot_setup(files);
  SetupFiles others = files;
  others.localizer = written("risk.yaml", "fused:\n  integrity_risk: 0.01\nsite_file: elsewhere\n");
  others.errors = written("grey.yaml", "tof_gain_std: 0.04\n");
  const RobotSetup setup = read_robot_setup(others);
  EXPECT_EQ(setup.localizer.params.fused.integrity_risk, 0.01);
  EXPECT_EQ(setup.localizer.params.site_file, STETRO_SITE_FILE) << "the command line's";
  EXPECT_EQ(setup.driver.params.sim.errors.tof_gain_std, 0.04);
  EXPECT_EQ(
    setup.driver.params.sim.errors.slip_max_m, defaults.driver.params.sim.errors.slip_max_m);
}

TEST(RobotSetup, RefusesWhatNoFileOfParametersKnows)
{
  SetupFiles files{STETRO_SITE_FILE, STETRO_ROBOT_FILE};
  files.errors = written("unknown.yaml", "tof_gian_std: 0.04\n");
  files.localizer = written("beyond.yaml", "fused:\n  integrity_risk: 2.0\n");
  try {
    static_cast<void>(read_robot_setup(files));
    FAIL() << "two faults";
  } catch (const stetro_config::ConfigError & error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("tof_gian_std"), std::string::npos) << what;
    EXPECT_NE(what.find("fused.integrity_risk"), std::string::npos) << what;
  }
}

}  // namespace
}  // namespace stetro_bringup
