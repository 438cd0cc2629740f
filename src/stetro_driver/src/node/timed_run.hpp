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

#ifndef NODE__TIMED_RUN_HPP_
#define NODE__TIMED_RUN_HPP_

#include <cstdint>
#include <functional>

#include "control_loop.hpp"
#include "node/driver_front.hpp"
#include "stetro_dds/executor.hpp"

namespace stetro_driver
{

/// The driver of a robot whose time passes by itself: the real one, or an emulated one.
/**
 * The control loop has a thread of its own. The executor's thread tells what it sensed and hands it
 * the commands, each with its end. Whichever of the two stalls, the robot stands: the loop knows
 * when a command is over, and this thread makes the hardware safe when no frame has come for a while.
 */
class TimedRun
{
public:
  /// \param hardware outlives the run
  TimedRun(
    stetro_dds::Context & context, stetro_dds::NodeOptions options, const DriverSetup & setup,
    const DriverHardware & hardware);

  void start();

  /// Runs the loop until `stop()` says so, giving the executor its turns in between.
  /** \throws HardwareError when the loop ends by itself; the hardware is safe then, too */
  void run(stetro_dds::Executor & executor, const std::function<bool()> & stop);

  [[nodiscard]] stetro_dds::Node & node() { return front_.node(); }

private:
  [[nodiscard]] RobotAccess access();
  [[nodiscard]] Time now();
  [[nodiscard]] bool tell_realtime();
  void tell_frames();
  void pass_command();
  void note_fault();
  void watch_loop();
  void report();

  HardwareInterface & robot_;
  SimulatedWorld * const world_;
  const double speed_;  // of the robot's time against the steady clock
  ControlLoop loop_;
  DriverFront front_;
  bool powered_ = false;
  std::uint64_t accepted_ = 0;  // commands, the last of which is in force
  Time heard_{0};               // steady time of the last frame
  Time truth_told_{0};
  bool silent_ = false;  // the loop is, and the hardware has been made safe
};

}  // namespace stetro_driver

#endif  // NODE__TIMED_RUN_HPP_
