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

#include "emulator/emulated_robot.hpp"

namespace stetro_driver::emulator
{
namespace
{

constexpr double kTickSeconds = 0.01;

/// The devices measure when they are asked to; the world's own rhythm would only add to theirs.
SimOptions for_devices(SimOptions options)
{
  options.ranges_at_once = true;
  options.lidar = false;
  return options;
}

}  // namespace

EmulatedRobot::EmulatedRobot(
  const BuildingShape & building, const BodyShape & body, const SimOptions & options,
  const linux_io::Devices & listed, const linux_io::TofLimits & limits, double rate)
: world_(building, body, for_devices(options)),
  clock_(options.origin, rate),
  emulated_(listed, clock_),
  mechanics_(listed.chassis),
  robot_(emulated_.devices(), limits, clock_, emulated_.doors())
{
  world_.configure();
  tick();  // before anybody looks
  thread_ = std::thread{[this] { run(); }};
}

EmulatedRobot::~EmulatedRobot()
{
  robot_.make_safe();
  stop_ = true;
  thread_.join();
}

void EmulatedRobot::run()
{
  while (!stop_) {
    const Time due = world_.time() + SteppedWorld::kTick;
    const Time left = due - clock_.now();
    if (left > Time::zero()) {
      std::this_thread::sleep_for(clock_.real(left));
      continue;
    }
    tick();
  }
}

void EmulatedRobot::tick()
{
  const auto before = world_.read(world_.time());
  world_.step(mechanics_.follow(emulated_.drives(), before.value().blocks, kTickSeconds));
  const SensorFrame frame = world_.read(world_.time()).value();
  emulated_.turn(mechanics_.shafts_after(frame, kTickSeconds));
  const GroundTruth truth = world_.truth();
  emulated_.show(frame, truth.yaw_rad);
  const std::lock_guard<std::mutex> lock{mutex_};
  truth_ = truth;
}

GroundTruth EmulatedRobot::truth() const
{
  const std::lock_guard<std::mutex> lock{mutex_};
  return truth_;
}

}  // namespace stetro_driver::emulator
