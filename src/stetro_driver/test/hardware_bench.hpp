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

#ifndef HARDWARE_BENCH_HPP_
#define HARDWARE_BENCH_HPP_

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "emulator/emulated_robot.hpp"
#include "linux/devices_file.hpp"
#include "pilot.hpp"
#include "stetro_driver/driver_hardware.hpp"
#include "stetro_driver/sim_robot.hpp"

namespace stetro_driver::test
{

/// A robot on a bench, whatever it is: time passes for it, and commands are renewed each cycle.
class HardwareBench
{
public:
  explicit HardwareBench(DriverHardware hardware) : hardware_(std::move(hardware)) {}

  [[nodiscard]] HardwareInterface & robot() { return *hardware_.robot; }
  [[nodiscard]] Time now() const { return hardware_.world->time(); }
  [[nodiscard]] GroundTruth truth() const { return hardware_.world->truth(); }

  void switch_on()
  {
    robot().configure();
    robot().activate();
  }

  /// One cycle of 10 ms: a stepped world is told to go on, another is waited for.
  void cycle()
  {
    if (hardware_.stepped != nullptr) {
      hardware_.stepped->step();
      return;
    }
    const Time until = now() + SteppedWorld::kTick;
    while (now() < until) {
      std::this_thread::sleep_for(std::chrono::microseconds{200});
    }
  }

  [[nodiscard]] SensorFrame read()
  {
    auto frame = robot().read(now());
    EXPECT_TRUE(frame.ok()) << (frame.ok() ? "" : frame.fault().detail);
    return frame.ok() ? frame.value() : SensorFrame{};
  }

  /// Commands and lets time pass until `done(frame)`. \return whether it came true in time
  template <class Done>
  bool until(const JointCommand & command, double limit_s, Done && done)
  {
    const Time end = now() + seconds_to_time(limit_s);
    while (now() < end) {
      refused_ = robot().write(command);
      cycle();
      if (done(read())) {
        return true;
      }
    }
    return false;
  }

  /// The same with nothing commanded: motors may be without power.
  template <class Done>
  bool wait(double limit_s, Done && done)
  {
    const Time end = now() + seconds_to_time(limit_s);
    while (now() < end) {
      cycle();
      if (done(read())) {
        return true;
      }
    }
    return false;
  }

  void during(const JointCommand & command, double seconds)
  {
    until(command, seconds, [](const SensorFrame &) { return false; });
  }
  void rest(double seconds)
  {
    wait(seconds, [](const SensorFrame &) { return false; });
  }

  bool steer(double angle_rad)
  {
    JointCommand command;
    command.kind = MotionKind::kSteer;
    command.steering_rad = angle_rad;
    return until(command, 5.0, [&](const SensorFrame & frame) {
      return std::abs(frame.steering.angle_rad - angle_rad) < 0.01 && !frame.steering.moving;
    });
  }

  /// What the last write answered.
  [[nodiscard]] const std::optional<IoFault> & refused() const { return refused_; }

private:
  DriverHardware hardware_;
  std::optional<IoFault> refused_{};
};

/// Makes a robot on the papers' stairs, not yet configured.
using MakeHardware = DriverHardware (*)(const SimOptions &);

inline DriverHardware make_sim_robot(const SimOptions & options)
{
  auto robot = std::make_unique<SimRobot>(paper_stairs(), BodyShape{}, options);
  SimRobot & simulated = *robot;
  return {std::move(robot), &simulated, &simulated};
}

/// The devices that the shipped robot file lists.
inline linux_io::Devices shipped_devices()
{
  stetro_config::Faults faults;
  auto devices = linux_io::read_devices(stetro_site::load_robot(ROBOTS "stetro.yaml"), faults);
  faults.throw_if_any();
  return std::move(devices).value();
}

/// Patience with emulated servos and sensors: of a computer that tests share, not of a robot.
inline linux_io::Devices patient(linux_io::Devices devices)
{
  devices.chassis.bus.reply_timeout_s = 0.1;
  devices.imu.silent_periods = 10;
  return devices;
}

/// \param rate share of their real speed at which devices and world run
inline std::unique_ptr<emulator::EmulatedRobot> emulated_robot(
  SimOptions options, const linux_io::Devices & devices, double rate = 1.0)
{
  // Without a trace of noise a sensor is rightly taken for stuck.
  options.errors.tof_white_std_m = std::max(options.errors.tof_white_std_m, 0.0015);
  return std::make_unique<emulator::EmulatedRobot>(
    building_of(paper_stairs()), BodyShape{}, options, devices, linux_io::TofLimits{}, rate);
}

inline DriverHardware make_emulated_robot(const SimOptions & options)
{
  auto robot = emulated_robot(options, patient(shipped_devices()));
  SimulatedWorld & world = *robot;
  return {std::move(robot), &world, nullptr};
}

}  // namespace stetro_driver::test

#endif  // HARDWARE_BENCH_HPP_
