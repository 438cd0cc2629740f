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

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include "linux/devices_file.hpp"

namespace stetro_driver::linux_io
{
namespace
{

std::string shipped()
{
  std::ifstream file{ROBOTS "stetro.yaml"};
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The shipped robot with a piece of its file replaced, named `robot.yaml` in faults.
stetro_site::Robot robot_with(const std::string & piece, const std::string & other)
{
  std::string text = shipped();
  const std::size_t at = text.rfind(piece);
  EXPECT_NE(at, std::string::npos) << piece;
  text.replace(at, piece.size(), other);
  stetro_site::Robot robot;
  robot.devices = YAML::Load(text)["devices"];
  robot.file = "robot.yaml";
  return robot;
}

stetro_config::Faults faults_with(const std::string & piece, const std::string & other)
{
  stetro_config::Faults faults;
  EXPECT_FALSE(read_devices(robot_with(piece, other), faults));
  return faults;
}

/// The line of a piece in the shipped file, counted from 1.
int line_of(const std::string & piece)
{
  const std::string text = shipped();
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(text.rfind(piece));
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

TEST(DevicesFile, IsShippedInFull)
{
  stetro_config::Faults faults;
  const auto devices = read_devices(stetro_site::load_robot(ROBOTS "stetro.yaml"), faults);
  ASSERT_TRUE(devices) << (faults.empty() ? "" : to_string(faults[0]));
  EXPECT_EQ(devices->range_sensors.sensors[2], "i2c:1-0032");
  EXPECT_EQ(devices->contacts.lines[8].line, 26);
  EXPECT_EQ(devices->contacts.lines[8].active, "high") << "a broken wire is a pressed button";
  EXPECT_EQ(devices->chassis.bus.port.baud, 500'000);
  EXPECT_EQ(devices->chassis.lifts.joints[1].id, 8);
  EXPECT_EQ(devices->imu.rate_hz, 100);
}

TEST(DevicesFile, MissingIsAFaultOfTheRobotFile)
{
  stetro_site::Robot robot;
  robot.file = "robot.yaml";
  stetro_config::Faults faults;
  EXPECT_FALSE(read_devices(robot, faults));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name, "devices");
  EXPECT_EQ(faults[0].file, "robot.yaml");
}

TEST(DevicesFile, NamesTheLineOfWhatItRefuses)
{
  const auto faults = faults_with("baud: 115200", "baud: 7");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name, "devices.imu.baud");
  EXPECT_EQ(faults[0].file, "robot.yaml");
  EXPECT_EQ(faults[0].value, "7");
  EXPECT_EQ(faults[0].line, line_of("baud: 115200"));
}

TEST(DevicesFile, KnowsNoOtherNames)
{
  const auto faults = faults_with("silent_periods: 3", "silent_period: 3");
  ASSERT_EQ(faults.size(), 2u);  // one it does not know, one it misses
  EXPECT_EQ(faults[0].name, "devices.imu.silent_period");
  EXPECT_EQ(faults[1].name, "devices.imu.silent_periods");
}

TEST(DevicesFile, RefusesTwoServosOfOneIdWithItsLine)
{
  const auto faults = faults_with("rear: {id: 8,", "rear: {id: 7,");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name, "devices.chassis.lifts.rear.id");
  EXPECT_EQ(faults[0].line, line_of("rear: {id: 8,"));
}

TEST(DevicesFile, RefusesTwoDevicesOnOnePort)
{
  const auto faults = faults_with("path: /dev/stetro_imu", "path: /dev/stetro_servos");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name, "devices.imu.path");
}

}  // namespace
}  // namespace stetro_driver::linux_io
