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

#include <filesystem>

#include "stetro_driver/driver_setup.hpp"

namespace stetro_driver
{
namespace
{

/// The faults of a driver on the papers' stairs.
stetro_config::Faults faults_of(const DriverParams & params)
{
  stetro_site::FlightSpec spec;
  spec.id = "stairs";
  spec.steps = stetro_site::equal_steps(16, 0.14, 0.32);
  spec.width_foot_m = 2.05;
  spec.width_top_m = 2.05;
  spec.lower_floor = "ground";
  spec.upper_floor = "first";
  stetro_config::Faults faults;
  check(DriverSetup{params, stetro_site::Flight{spec}, stetro_site::Robot{}}, faults);
  return faults;
}

TEST(DriverSetup, FitsByDefault) { EXPECT_TRUE(faults_of({}).empty()); }

TEST(DriverSetup, RefusesAStartInsideAWall)
{
  DriverParams params;
  params.sim.start = {-0.5, 5.0, 0.0};
  const auto faults = faults_of(params);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name, "sim.start");
  EXPECT_NE(faults[0].value.find("5.0"), std::string::npos) << faults[0].value;
  EXPECT_NE(faults[0].accepted.find("side wall"), std::string::npos) << faults[0].accepted;
}

TEST(DriverSetup, RefusesASnapshotWhereNoFileCanBe)
{
  DriverParams params;
  params.sim.snapshot_file = ::testing::TempDir() + "no_such_directory/world.snapshot";
  const auto faults = faults_of(params);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name, "sim.snapshot_file");
  EXPECT_EQ(faults[0].value, params.sim.snapshot_file);
  params.sim.snapshot_file = ::testing::TempDir();
  EXPECT_EQ(faults_of(params).size(), 1u) << "a directory";
  params.sim.snapshot_file = ::testing::TempDir() + "driver_setup.snapshot";
  EXPECT_TRUE(faults_of(params).empty());
  EXPECT_FALSE(std::filesystem::exists(params.sim.snapshot_file)) << "looking makes nothing";
}

}  // namespace
}  // namespace stetro_driver
