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

#ifndef CONTROL_LOOP_HPP_
#define CONTROL_LOOP_HPP_

#include <semaphore.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "frame_queue.hpp"
#include "latest_value.hpp"
#include "linux/loop_statistics.hpp"
#include "linux/service_notify.hpp"
#include "stetro_driver/hardware_interface.hpp"
#include "stetro_driver/joint_command.hpp"
#include "stetro_driver/realtime.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver
{

/// A command on its way to the motors, and how long it may act.
struct TimedCommand
{
  bool powered = false;  ///< else nothing is written
  JointCommand command{};
  Time until{0};             ///< on the steady clock; the robot holds from then on
  std::uint64_t number = 0;  ///< the caller's, to know it again
};

/// What went wrong in a cycle, and which command it carried out.
struct LoopFault
{
  IoFault fault;
  std::uint64_t command = 0;  ///< its number; zero before the first
};

/// Reads sensors and writes motors at a fixed rate, in a thread of its own.
/**
 * Each cycle begins at an absolute deadline of the steady clock, reads the hardware into a queue,
 * and writes the command in force, or `hold` once its time is over: whoever commands may die or
 * stall, the robot stands within a cycle of that. It neither blocks nor allocates while the
 * hardware does not; faults are the exception, their words are copied.
 *
 * A late cycle is counted and run at once; whole periods that were missed are counted and left
 * out. Whenever the loop ends, also by an exception, the hardware has been made safe.
 *
 * Started by systemd, it says when it is ready, and feeds the watchdog while it runs and whoever
 * commands it shows itself.
 */
class ControlLoop
{
public:
  /// Time on the robot's clock; called in the loop's thread.
  using RobotClock = std::function<Time()>;

  /// \param robot configured, and not to be touched but by alone() while the loop runs
  /// \throws std::invalid_argument unless the period is above zero
  ControlLoop(
    HardwareInterface & robot, RobotClock clock, Time period,
    const linux_io::RealtimeConfig & realtime = {});
  ~ControlLoop();
  ControlLoop(const ControlLoop &) = delete;
  ControlLoop & operator=(const ControlLoop &) = delete;

  void start();
  /// Ends the thread. The hardware is safe afterwards.
  void stop() noexcept;

  /// What the motors shall do from the next cycle on; also a sign that its caller lives.
  void command(const TimedCommand & command);

  /// Waits until a frame may be there. \return false: patience has ended
  bool wait(Time patience);
  /// The oldest frame that nobody has taken. \return whether there was one
  [[nodiscard]] bool take(SensorFrame & frame) { return frames_.take(frame); }

  /// What stands between us and the hardware as of the last cycle; nothing: all is well.
  [[nodiscard]] std::optional<LoopFault> fault();

  /// Runs an action on the hardware between two cycles. What it throws, this throws.
  void alone(const std::function<void()> & action);

  /// False once the thread has ended, whatever ended it.
  [[nodiscard]] bool alive() const { return alive_; }
  /// Why the thread ended before it was told to; empty otherwise. Only when it is not alive.
  [[nodiscard]] const std::string & death() const { return death_; }

  /// How well it keeps its time, a second ago at most; zeroes before its first second.
  [[nodiscard]] linux_io::LoopSummary summary() { return summary_.latest().value_or(kNoSummary); }
  [[nodiscard]] std::uint64_t missed() const { return missed_; }  ///< periods that were left out
  /// What the kernel granted; nothing until the loop has asked.
  [[nodiscard]] std::optional<linux_io::RealtimeReport> realtime() { return granted_.latest(); }
  [[nodiscard]] std::uint64_t dropped_frames() const { return frames_.dropped(); }

private:
  static constexpr linux_io::LoopSummary kNoSummary{};

  void run() noexcept;
  void work();
  void cycle(Time now);
  void account(Time begun);
  void tell(std::optional<LoopFault> fault);

  HardwareInterface & robot_;
  const RobotClock clock_;
  const Time period_;
  const linux_io::RealtimeConfig wishes_;
  linux_io::ServiceNotify service_;      // the loop's
  linux_io::LoopStatistics statistics_;  // the loop's
  LatestValue<linux_io::LoopSummary> summary_;
  LatestValue<linux_io::RealtimeReport> granted_;
  std::thread thread_;
  std::mutex hardware_;  // held through a cycle, and through alone()
  LatestValue<TimedCommand> command_;
  FrameQueue frames_;
  LatestValue<std::optional<LoopFault>> faults_;
  Time summed_{0};                 // the loop's: when it summed up last
  std::optional<LoopFault> told_;  // the loop's: what it put last
  sem_t arrived_{};
  std::string death_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> alive_{false};
  std::atomic<Time> commanded_{Time::zero()};  // steady time of the last command()
  std::atomic<std::uint64_t> missed_{0};
};

}  // namespace stetro_driver

#endif  // CONTROL_LOOP_HPP_
