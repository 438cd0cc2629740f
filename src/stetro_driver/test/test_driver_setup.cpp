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

#include "buildings.hpp"
#include "stetro_driver/driver_setup.hpp"

namespace stetro_driver
{
namespace
{

/// The faults of a driver on the papers' stairs.
stetro_config::Faults faults_of(const DriverParams & params)
{
  stetro_config::Faults faults;
  check(
    DriverSetup{params, test::site_of(test::paper_flight()), "stairs", stetro_site::Robot{}},
    faults);
  return faults;
}

TEST(DriverSetup, FitsByDefault) { EXPECT_TRUE(faults_of({}).empty()); }

TEST(DriverSetup, NeedsTheDevicesOfARobotThatHasSome)
{
  DriverParams params;
  params.hardware = "linux";
  const auto faults = faults_of(params);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name, "devices");
  params.sim.start = {-0.5, 5.0, 0.0};
  EXPECT_EQ(faults_of(params).size(), 1u) << "where a simulation would start is nothing to it";
}

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

TEST(DriverSetup, RefusesAKidnapOnAFloorThatNobodyHasDrawn)
{
  DriverParams params;
  params.sim.faults = "kidnap:ground@1";
  const auto faults = faults_of(params);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name, "sim.faults");
  EXPECT_EQ(faults[0].value, "kidnap:ground");
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

TEST(DriverSetup, StartsAtTheFirstFlightOfABuildingUnlessToldOtherwise)
{
  DriverParams params;
  params.site_file = SITES "two_floors.yaml";
  params.robot_file = SITES "../robot/stetro.yaml";
  stetro_config::Faults faults;
  EXPECT_EQ(read_setup(params, faults)->flight_id, "lower");
  params.flight = "upper";
  EXPECT_EQ(read_setup(params, faults)->flight().steps(), 8);
  EXPECT_TRUE(faults.empty());
  params.flight = "middle";
  EXPECT_FALSE(read_setup(params, faults));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name, "flight");
}

TEST(DriverSetup, RefusesAStartBehindTheWallsOfAFloor)
{
  const auto site = stetro_site::load_site(SITES "two_floors.yaml");
  DriverParams params;
  for (const std::vector<double> & start :
       {std::vector<double>{-6.0, 1.0, 0.0}, {-2.5, 2.0, 0.0}, {-4.9, 1.0, 0.0}}) {
    params.sim.start = start;  // outside, in the column, and in the wall
    stetro_config::Faults faults;
    check(DriverSetup{params, site, "lower", stetro_site::Robot{}}, faults);
    ASSERT_EQ(faults.size(), 1u) << start[0];
    EXPECT_NE(faults[0].accepted.find("floor ground"), std::string::npos) << faults[0].accepted;
  }
}

TEST(DriverSetup, SimulatesTheLidarWhereThereIsSomethingToSee)
{
  const stetro_site::Robot robot;
  const auto drawn = stetro_site::load_site(SITES "two_floors.yaml");
  const auto bare = test::site_of(test::paper_flight());
  DriverParams params;
  EXPECT_TRUE(sim_options(DriverSetup{params, drawn, "lower", robot}).lidar);
  EXPECT_FALSE(sim_options(DriverSetup{params, bare, "stairs", robot}).lidar);
  params.sim.lidar = "on";
  EXPECT_TRUE(sim_options(DriverSetup{params, bare, "stairs", robot}).lidar);
  params.sim.lidar = "off";
  EXPECT_FALSE(sim_options(DriverSetup{params, drawn, "lower", robot}).lidar);
}

}  // namespace
}  // namespace stetro_driver
