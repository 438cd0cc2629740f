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

// The real robot's driver with emulated devices, as one thing: starting, telling, ending. What goes
// wrong with devices in mid-climb is in test_fault_matrix.cpp.

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "device_bench.hpp"
#include "hardware_bench.hpp"

namespace stetro_driver
{
namespace
{

using emulator::EmulatedDevices;
using test::HardwareBench;
using test::Pilot;

constexpr double kWellAgainWithin_s = 8.0;  // back-off, opening, and trust
constexpr RangePlace kPlace = RangePlace::kFrontLeft;

TEST(EmulatedRobot, NamesEveryDeviceThatIsMissingAtTheStart)
{
  auto robot = test::emulated_robot(test::perfect(), test::patient(test::shipped_devices()));
  EmulatedDevices & devices = robot->emulated();
  devices.tree().unplug(devices.sensor(kPlace)->i2c_name);
  devices.imu().unplug();
  devices.servos().unplug();
  std::string said;
  try {
    robot->configure();
  } catch (const HardwareError & error) {
    said = error.what();
  }
  EXPECT_NE(said.find("front_left"), std::string::npos) << said;
  EXPECT_NE(said.find("imu"), std::string::npos) << said;
  EXPECT_NE(said.find("servo"), std::string::npos) << said;
  int faulty = 0;
  for (const DeviceStatus & device : robot->devices()) {
    faulty += device.fault ? 1 : 0;
  }
  EXPECT_EQ(faulty, 3) << "the switches are there";
  devices.tree().plug(*devices.sensor(kPlace));
  devices.imu().plug();
  devices.servos().plug();
  robot->configure();  // without a restart
  EXPECT_TRUE(robot->read(robot->time()).ok());
}

TEST(EmulatedRobot, TellsHowItsDevicesAre)
{
  auto robot = test::emulated_robot(test::perfect(), test::patient(test::shipped_devices()));
  robot->configure();
  const auto devices = robot->devices();
  EXPECT_EQ(devices.size(), 8u + 1u + 1u + 8u);  // servos, contacts, imu, range sensors
  bool volts = false;
  for (const DeviceStatus & device : devices) {
    EXPECT_FALSE(device.fault) << device.name;
    for (const auto & [name, value] : device.figures) {
      volts = volts || (name == "voltage" && value == "7.4 V");
    }
  }
  EXPECT_TRUE(volts);
}

TEST(EmulatedRobot, StandsWhenItsServoLineIsCutWhileItRolls)
{
  SimOptions options = test::perfect();
  options.start = SimStart{-1.5, 1.025, 0.0};
  auto robot = test::emulated_robot(options, test::patient(test::shipped_devices()));
  EmulatedDevices & devices = robot->emulated();
  SimulatedWorld & world = *robot;
  HardwareBench bench{DriverHardware{std::move(robot), &world, nullptr}};
  bench.switch_on();
  bench.during(Pilot::twist(0.1, 0.0, 0.0), 1.0);
  devices.servos().unplug();
  bench.during(Pilot::twist(0.1, 0.0, 0.0), 0.5);
  const double stopped_m = bench.truth().x_m;
  bench.during(Pilot::twist(0.1, 0.0, 0.0), 0.5);
  EXPECT_EQ(bench.truth().x_m, stopped_m) << "the relay of the wheels has opened";
  EXPECT_TRUE(bench.refused());
  devices.servos().plug();
  EXPECT_TRUE(bench.until(
    Pilot::twist(0.1, 0.0, 0.0), kWellAgainWithin_s,
    [&](const SensorFrame &) { return bench.truth().x_m > stopped_m + 0.02; }));
}

// A broken switch ends a mission, and a thread that was not run for a moment is no broken switch.
TEST(EmulatedRobot, HoldsForABriefSilenceOfItsSwitchesBeforeTheyAreBroken)
{
  auto robot = test::emulated_robot(test::perfect(), test::patient(test::shipped_devices()));
  EmulatedDevices & devices = robot->emulated();
  SimulatedWorld & world = *robot;
  HardwareBench bench{DriverHardware{std::move(robot), &world, nullptr}};
  bench.switch_on();
  bool broken = false;
  devices.lines().set_hanging(true);
  ASSERT_TRUE(bench.until({}, kWellAgainWithin_s, [&](const SensorFrame & frame) {
    broken = broken || frame.contacts[0].fault;
    return bench.refused().has_value();
  }));
  EXPECT_FALSE(broken);
  EXPECT_TRUE(bench.until(
    {}, kWellAgainWithin_s, [](const SensorFrame & frame) { return frame.contacts[0].fault; }));
  devices.lines().set_hanging(false);
  EXPECT_TRUE(bench.until(
    {}, kWellAgainWithin_s, [](const SensorFrame & frame) { return !frame.contacts[0].fault; }));
}

TEST(EmulatedRobot, LeavesNothingBehind)
{
  const OpenResources before;
  for (int i = 0; i < 2; ++i) {
    auto robot = test::emulated_robot(test::perfect(), test::patient(test::shipped_devices()));
    robot->configure();
    robot->activate();
  }
  EXPECT_TRUE(OpenResources{} == before);
}

}  // namespace
}  // namespace stetro_driver
