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

#ifndef LINUX__MOTION__CHASSIS_HPP_
#define LINUX__MOTION__CHASSIS_HPP_

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "linux/motion/chassis_config.hpp"
#include "linux/motion/kept_blocks.hpp"
#include "linux/motion/lifts.hpp"
#include "linux/motion/steering.hpp"
#include "linux/motion/wheel_odometry.hpp"
#include "linux/motion/wheel_speed.hpp"
#include "linux/servo/servo_bank.hpp"
#include "stetro_driver/joint_command.hpp"
#include "stetro_driver/sensor_frame.hpp"

namespace stetro_driver::linux_io
{

/// What wheels, steering and lifts say of the same round over the servos.
struct ChassisReading
{
  Time stamp{0};  ///< of the round's end; zero when there never was one
  std::array<BlockReading, kBlocks> blocks{};
  SteeringReading steering{};
  OdometryReading odometry{};
  std::optional<IoFault> fault{};  ///< while there is one, everything holds
};

/// How one servo is doing.
struct ServoDiagnostics
{
  std::string name;
  DeviceCounts counts{};
  bool faulty = false;
  std::optional<IoFault> last_fault{};  ///< the newest ever
  ServoState state{};
};

/// Wheels, steering and lifts: takes joint commands, gives readings, and owns the servos' thread.
/**
 *   (made)   --configure()--->  braked    every servo is found and set up, its state is read
 *   braked   --activate()---->  powered   it stands and holds, and moves as command() says
 *   powered  --deactivate()-->  braked
 *   powered  --make_safe()--->  powered   it holds whatever it is told, until activate()
 *
 * A thread asks and tells all servos once in a period. command() and reading() only pass through
 * a box and never wait for a servo. Whatever is wrong with a servo or their line, all of them hold,
 * wheels without power, steering and lifts where their goals are; when it is over they obey the
 * next command. A command is good for command_timeout_s.
 *
 * Latched errors of servos and jammed lifts are cleared by activate() and by nothing else.
 */
class Chassis
{
public:
  Chassis(const ChassisConfig & config, DeviceClock clock);
  ~Chassis();
  Chassis(const Chassis &) = delete;
  Chassis & operator=(const Chassis &) = delete;

  /// \throws HardwareError naming port or servos, what happened and what is accepted
  void configure();

  /// \throws HardwareError naming the servo that cannot be powered, and why
  void activate();

  /// \return what kept a servo from being braked; the others are
  std::optional<IoFault> deactivate();

  /// What to do from now on; nothing: it went well.
  [[nodiscard]] std::optional<IoFault> command(const JointCommand & command);

  [[nodiscard]] ChassisReading reading() const;
  [[nodiscard]] std::vector<ServoDiagnostics> diagnostics() const;
  [[nodiscard]] DeviceCounts line_counts() const;
  /// Why it is not kept what the blocks stand on; empty: it is.
  [[nodiscard]] std::string blocks_trouble() const { return kept_.trouble(); }
  /// Rounds that took longer than the period.
  [[nodiscard]] std::uint64_t overruns() const { return overruns_; }

  /// Stops and holds at once, past the thread; in any state, from any thread, twice.
  void make_safe() noexcept;

private:
  void run();
  void round(Time now);
  void change_power();
  void measure(Time now);
  void obey(const JointCommand & command, Time now);
  void tell(bool holding);
  void publish(Time now);
  [[nodiscard]] std::optional<IoFault> ask_power(Torque torque);
  void set_goals(bool holding);
  void stop_thread();

  ChassisConfig config_;
  DeviceClock clock_;
  TwistToWheels geometry_;

  // The thread's own.
  ServoBank bank_;
  WheelOdometry odometry_;
  Steering steering_;
  KeptBlocks kept_;
  Lifts lifts_;
  std::array<WheelSpeed, kWheels> speeds_{};
  WheelValues wanted_rad_s_{};
  WheelValues told_rad_s_{};
  std::vector<ServoGoal> goals_{};  // a member so that no round allocates
  std::optional<IoFault> fault_{};
  bool powered_ = false;
  Time round_at_{0};
  double dt_s_ = 0.0;  // since the round before

  // Shared with whoever commands and reads.
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool stop_ = false;
  std::optional<Torque> power_asked_{};
  std::optional<IoFault> power_fault_{};
  JointCommand command_{};
  Time commanded_at_{0};
  ChassisReading reading_{};
  std::vector<ServoDiagnostics> diagnostics_{};
  DeviceCounts line_counts_{};
  std::optional<HerkulexBytes> hold_wire_{};  // wheels off, the rest where it is told to be
  std::atomic<bool> safe_{false};
  std::atomic<std::uint64_t> overruns_{0};
  std::thread thread_;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__MOTION__CHASSIS_HPP_
