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

// The real robot's driver in mid-climb, and what goes wrong with its devices: one of each kind,
// twice in a row. What a device can do wrong by itself is in its own tests.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "device_bench.hpp"
#include "hardware_bench.hpp"

namespace stetro_driver
{
namespace
{

using emulator::EmulatedDevices;
using std::chrono::milliseconds;
using test::HardwareBench;
using test::Pilot;

/// Three periods of the slowest device, and what a computer that tests share may be late by.
constexpr double kKnownWithin_s = 0.105 + 0.25;
constexpr double kWellAgainWithin_s = 8.0;  // back-off, opening, and trust
constexpr double kStandsStill_m = 0.002;    // a leg of the lifts that was under way is finished

struct Trouble
{
  const char * name;
  std::function<void(EmulatedDevices &)> strike;
  std::function<void(EmulatedDevices &)> end;
  IoFaultKind kind;
  bool latches = false;  ///< a person has to reset the emergency stop
};

void PrintTo(const Trouble & trouble, std::ostream * out) { *out << trouble.name; }

std::string name_of(const ::testing::TestParamInfo<Trouble> & info) { return info.param.name; }

const RangePlace kPlace = RangePlace::kFrontLeft;

std::vector<Trouble> troubles()
{
  return {
    {"range_sensor_unplugged",
     [](EmulatedDevices & d) { d.tree().unplug(d.sensor(kPlace)->i2c_name); },
     [](EmulatedDevices & d) { d.tree().plug(*d.sensor(kPlace)); }, IoFaultKind::kSilent},
    {"range_sensor_garbled",
     [](EmulatedDevices & d) { d.tof(kPlace)->set_trouble(emulator::TofTrouble::kGarbled); },
     [](EmulatedDevices & d) { d.tof(kPlace)->set_trouble(emulator::TofTrouble::kNone); },
     IoFaultKind::kBadAnswer},
    {"imu_unplugged", [](EmulatedDevices & d) { d.imu().unplug(); },
     [](EmulatedDevices & d) { d.imu().plug(); }, IoFaultKind::kSilent},
    {"servo_line_unplugged", [](EmulatedDevices & d) { d.servos().unplug(); },
     [](EmulatedDevices & d) { d.servos().plug(); }, IoFaultKind::kSilent},
    {"servo_silent",
     [](EmulatedDevices & d) {
       emulator::HerkulexFaults faults;
       faults.silent = {7};
       d.servos().set_faults(faults);
     },
     [](EmulatedDevices & d) { d.servos().set_faults({}); }, IoFaultKind::kSilent},
    {"lines_unplugged", [](EmulatedDevices & d) { d.lines().set_plugged("gpiochip0", false); },
     [](EmulatedDevices & d) { d.lines().set_plugged("gpiochip0", true); },
     IoFaultKind::kEmergencyStop, true},
  };
}

class InMidClimb : public ::testing::TestWithParam<Trouble>
{
protected:
  InMidClimb()
  {
    SimOptions options = test::perfect();
    options.start = SimStart{0.235, 1.025, 0.0};  // blocks 2 and 3 on tread 1, block 1 on tread 2
    auto robot = test::emulated_robot(options, test::patient(test::shipped_devices()));
    devices_ = &robot->emulated();
    SimulatedWorld & world = *robot;
    bench_.emplace(DriverHardware{std::move(robot), &world, nullptr});
    bench_->switch_on();
  }

  [[nodiscard]] double height_m() const { return bench_->truth().block_heights_m[1]; }

  /// Lifts block 2 until something is so. \return whether it came true
  template <class Done>
  bool lift(double limit_s, Done && done)
  {
    return bench_->until(
      Pilot::vertical(MotionKind::kLift, 2), limit_s, [&](const SensorFrame &) { return done(); });
  }

  EmulatedDevices * devices_ = nullptr;
  std::optional<HardwareBench> bench_;
};

TEST_P(InMidClimb, HoldsSaysWhyAndGoesOnTwice)
{
  const Trouble & trouble = GetParam();
  const double floor_m = height_m();
  ASSERT_TRUE(lift(4.0, [&] { return height_m() > floor_m + 0.02; }));
  const OpenResources before;
  for (int time = 1; time <= 2; ++time) {
    SCOPED_TRACE(time);
    trouble.strike(*devices_);
    const Time struck = bench_->now();
    ASSERT_TRUE(lift(2.0, [&] { return bench_->refused().has_value(); }));
    EXPECT_LT(time_to_seconds(bench_->now() - struck), kKnownWithin_s);
    EXPECT_EQ(bench_->refused()->kind, trouble.kind) << bench_->refused()->detail;
    const double held_m = height_m();
    lift(0.5, [] { return false; });
    EXPECT_NEAR(height_m(), held_m, kStandsStill_m);
    EXPECT_TRUE(bench_->refused());
    trouble.end(*devices_);
    if (trouble.latches) {
      bench_->rest(3.0);
      bench_->robot().reset_emergency_stop();
    }
    ASSERT_TRUE(lift(kWellAgainWithin_s, [&] { return !bench_->refused(); }))
      << bench_->refused()->detail;
    ASSERT_TRUE(lift(3.0, [&] { return height_m() > held_m + 0.02; })) << "it goes on";
  }
  EXPECT_TRUE(OpenResources{} == before);
  EXPECT_FALSE(bench_->truth().fallen);
}

INSTANTIATE_TEST_SUITE_P(Troubles, InMidClimb, ::testing::ValuesIn(troubles()), name_of);

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
