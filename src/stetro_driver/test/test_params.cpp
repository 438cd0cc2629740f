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

#include "stetro_config/loader.hpp"
#include "stetro_config/report.hpp"
#include "stetro_driver/params.hpp"

namespace stetro_driver
{
namespace
{

/// The faults of parameters written as YAML text.
stetro_config::Faults faults_in(const std::string & text)
{
  stetro_config::Loader<DriverParams> loader;
  loader.read_map(YAML::Load(text), "driver.yaml");
  stetro_config::Faults faults;
  static_cast<void>(loader.finish(faults));
  return faults;
}

TEST(DriverParams, DefaultsNeedOnlyTheirFiles)
{
  EXPECT_TRUE(faults_in("{site_file: s.yaml, robot_file: r.yaml}").empty());
  EXPECT_EQ(faults_in("{}").size(), 2u);
}

TEST(DriverParams, EveryFaultIsReportedWithItsLine)
{
  const auto faults = faults_in(
    "site_file: s.yaml\nrobot_file: r.yaml\nsim:\n  sped: 3\n  errors:\n    calibration: maybe\n");
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].line, 4);
  EXPECT_EQ(faults[0].name, "sim.sped");
  EXPECT_EQ(faults[1].line, 6);
}

TEST(DriverParams, RefusesFaultsThatAreNone)
{
  const auto faults = faults_in("{site_file: s, robot_file: r, sim: {faults: 'melt@3'}}");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name, "sim.faults");
  EXPECT_NE(faults[0].accepted.find("kidnap"), std::string::npos) << "the list is given";
}

TEST(DriverParams, EmulatedDevicesRunNoSlowerThanRealOnesAndAreNotResumed)
{
  const auto faults = faults_in(
    "{site_file: s, robot_file: r, hardware: emulated, sim: {speed: 0.5, snapshot_file: w}}");
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].name, "sim.speed");
  EXPECT_EQ(faults[1].name, "sim.snapshot_file");
  EXPECT_TRUE(faults_in("{site_file: s, robot_file: r, hardware: emulated}").empty());
}

TEST(DriverParams, ReachTheSimulation)
{
  DriverParams params;
  params.sim.seed = 7;
  params.sim.world = "site";
  params.sim.start = {1.0, 2.0, 0.1};
  params.sim.faults = "slip@3";
  params.sim.people = 2;
  params.sim.unmapped_boxes = 3;
  const SimOptions options = sim_options(params);
  EXPECT_EQ(options.seed, 7u);
  EXPECT_FALSE(options.as_built);
  ASSERT_TRUE(options.start);
  EXPECT_EQ(options.start->y_m, 2.0);
  EXPECT_EQ(options.faults.size(), 1u);
  EXPECT_EQ(options.people, 2);
  EXPECT_EQ(options.unmapped_boxes, 3);
  EXPECT_FALSE(options.lidar);
  EXPECT_EQ(gate_limits(params).max_valid_for, std::chrono::milliseconds{200});
}

TEST(DriverParams, DocumentThemselves)
{
  const std::string table = stetro_config::reference_table<DriverParams>();
  EXPECT_NE(table.find("sim.errors.tof_gain_std"), std::string::npos);
}

}  // namespace
}  // namespace stetro_driver
