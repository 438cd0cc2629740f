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

#ifndef EMULATOR__VN100_EMULATOR_HPP_
#define EMULATOR__VN100_EMULATOR_HPP_

#include <atomic>
#include <cstdint>
#include <mutex>
#include <random>
#include <string>
#include <thread>

#include "emulator/line_pacer.hpp"
#include "emulator/pty.hpp"
#include "emulator/vn100_registers.hpp"
#include "linux/device_clock.hpp"
#include "linux/imu/ned.hpp"
#include "stetro_driver/sensor_frame.hpp"

namespace stetro_driver::emulator
{

/// Which VN-100 it is and how it is screwed to the robot.
struct Vn100EmulatorOptions
{
  std::string link;  ///< path under which the driver opens it
  std::string model = "VN-100T-CR";
  std::string serial_number = "0100012345";
  std::uint32_t baud = 115'200;
  double mounting_roll_rad = 0.0;  ///< as in the driver's configuration
  double mounting_pitch_rad = 0.0;
  double mounting_yaw_rad = 0.0;
  std::uint64_t seed = 1;  ///< of what happens to hurt bytes
};

/// What the robot's body does, in base_link. Errors of the sensor are its owner's to add.
struct ImuMotion
{
  Quaternion base_in_world{};                       ///< world: x east, y north, z up
  linux_io::Axes rate_rad_s{};                      ///< of turn, counter-clockwise positive
  linux_io::Axes acceleration_m_s2{0.0, 0.0, 9.8};  ///< specific force: up at rest
};

/// What is wrong with it.
struct Vn100Trouble
{
  bool silent = false;         ///< neither measures nor answers
  double slow = 1.0;           ///< measures so many times less often
  double flip_per_byte = 0.0;  ///< probability that one bit of a byte is wrong
  double lose_per_byte = 0.0;  ///< probability that a byte is lost
};

/// A VN-100 on a pseudo-terminal: the other end of the driver's wire.
/**
 * Sends what it was told to, paced at its baud; answers between measurements; output runs from the
 * start, as the factory left it. At another baud than the host's, the host receives garbage and is
 * not understood. Plugging it in again starts it anew: it has forgotten its settings. The rate that
 * a measurement says is the angle turned since the one before it, by their time: no angle is lost.
 *
 * A thread of its own. All members may be called from any thread.
 */
class Vn100Emulator
{
public:
  /// \throws std::system_error when there is no pseudo-terminal
  Vn100Emulator(const Vn100EmulatorOptions & options, const linux_io::DeviceClock & clock);
  ~Vn100Emulator();
  Vn100Emulator(const Vn100Emulator &) = delete;
  Vn100Emulator & operator=(const Vn100Emulator &) = delete;

  /// Moves so from now on.
  void set_motion(const ImuMotion & motion) { set_motion(motion, clock_.now()); }
  /// Moves so since a time, which may be a little ago.
  void set_motion(const ImuMotion & motion, Time since);
  void set_trouble(const Vn100Trouble & trouble);

  void unplug();
  void plug();
  /// Puts another unit in its place; unplugged until plug().
  void replace(const std::string & model, const std::string & serial_number);

  [[nodiscard]] const std::string & link() const { return options_.link; }

private:
  void run();
  void start_anew();
  [[nodiscard]] Time serve(Time now);
  void hear(Time now);
  void measure(Time now);
  void send(const std::string & frame, Time now, std::uint32_t baud);
  void deliver(Time now);
  [[nodiscard]] linux_io::Vn100Sample sample();
  [[nodiscard]] linux_io::Axes turned_rad(Time until) const;  ///< in all
  void begin_interval();
  [[nodiscard]] bool happens(double probability);

  Vn100EmulatorOptions options_;
  const linux_io::DeviceClock clock_;
  const linux_io::ImuMounting mounting_;

  mutable std::mutex mutex_;  // guards what follows
  Pty pty_;
  LinePacer line_;
  Vn100Registers registers_;
  ImuMotion motion_{};
  Time moved_at_{0};                    ///< since when it moves so
  linux_io::Axes turned_before_rad_{};  ///< in all until then
  Vn100Trouble trouble_{};
  std::string heard_;
  Time started_{0};
  Time last_{0};                          ///< measurement
  Time interval_began_{0};                ///< whose mean rate the next one says
  linux_io::Axes turned_at_begin_rad_{};  ///< in all until then
  std::mt19937_64 random_;

  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace stetro_driver::emulator

#endif  // EMULATOR__VN100_EMULATOR_HPP_
