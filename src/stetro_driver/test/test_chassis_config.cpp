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

#include <string>

#include "linux/motion/chassis_config.hpp"

namespace stetro_driver::linux_io
{
namespace
{

ChassisConfig wired()
{
  ChassisConfig config;
  config.bus.port.path = "/dev/serial/by-id/servos";
  return config;
}

std::string faults_of(const ChassisConfig & config)
{
  stetro_config::Faults faults;
  check(config, faults);
  std::string text;
  for (const stetro_config::Fault & fault : faults) {
    text += to_string(fault) + "\n";
  }
  return text;
}

TEST(ChassisConfig, DefaultsNeedOnlyAPath)
{
  EXPECT_EQ(faults_of(wired()), "");
  EXPECT_NE(faults_of({}).find("bus.path"), std::string::npos);
}

TEST(ChassisConfig, DeclaresEveryNumberOnce)
{
  ChassisConfig config;
  EXPECT_EQ(stetro_config::fields_of(config).size(), 5U + 2 + 4 * 4 + 1 + 2 * 3 + 3 + 2 * 3);
}

TEST(ChassisConfig, NamesIdsThatAreUsedTwice)
{
  ChassisConfig config = wired();
  config.lifts.joints[1].id = config.wheels.wheels[0].id;
  const std::string text = faults_of(config);
  EXPECT_NE(text.find("lifts.rear.id"), std::string::npos) << text;
  EXPECT_NE(text.find("wheels.front_left.id"), std::string::npos) << text;
}

TEST(ChassisConfig, RefusesALineThatIsTooSlowForItsPeriod)
{
  ChassisConfig config = wired();
  config.bus.port.baud = 115'200;  // 8 x 35 + 40 bytes are 27.8 ms
  EXPECT_NE(faults_of(config).find("period_s"), std::string::npos);
  config.period_s = 0.04;
  EXPECT_EQ(faults_of(config), "");
}

TEST(ChassisConfig, RefusesPatienceThatHidesASilentServo)
{
  ChassisConfig config = wired();
  config.bus.reply_timeout_s = 0.011;
  EXPECT_NE(faults_of(config).find("bus.reply_timeout_s"), std::string::npos);
}

TEST(ChassisConfig, RefusesALiftWhoseWayItsServoCannotTurn)
{
  ChassisConfig config = wired();
  config.lifts.m_per_rad = 0.03;  // 0.18 m are 6 rad
  const std::string text = faults_of(config);
  EXPECT_NE(text.find("lifts.front.zero_rad"), std::string::npos) << text;
  EXPECT_NE(text.find("lifts.rear.zero_rad"), std::string::npos) << text;
}

TEST(ChassisConfig, AcceptsFewerWheelsButNotNone)
{
  ChassisConfig config = wired();
  config.wheels.wheels[1].id = -1;
  config.wheels.wheels[3].id = -1;
  EXPECT_EQ(faults_of(config), "");
  config.wheels.wheels[0].id = -1;
  config.wheels.wheels[2].id = -1;
  EXPECT_NE(faults_of(config).find("wheels"), std::string::npos);
}

}  // namespace
}  // namespace stetro_driver::linux_io
