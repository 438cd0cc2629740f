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

#ifndef LINUX__LINES__CONTACT_LINES_HPP_
#define LINUX__LINES__CONTACT_LINES_HPP_

#include <array>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "latest_value.hpp"
#include "linux/device_clock.hpp"
#include "linux/device_health.hpp"
#include "linux/lines/contact_debounce.hpp"
#include "linux/lines/contact_lines_config.hpp"
#include "linux/lines/line_port.hpp"
#include "stetro_driver/result.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// All switches at one time.
struct ContactLatest
{
  std::array<ContactReading, kContactPlaces> contacts{};
  bool emergency_stop_latched = true;  ///< until somebody has looked at the button
  /// Why nothing of it is to be used; nothing: the lines are read. Words: ContactReport::health.
  std::optional<IoFaultKind> fault{IoFaultKind::kNotConfigured};
  Time read{0};  ///< when the levels were read last
};

/// The port's health, and what each contact did.
struct ContactReport
{
  DeviceHealth health;
  std::array<ContactTrouble, kContactPlaces> troubles{};
  std::array<ContactStatistics, kContactPlaces> statistics{};
};

/// Bumpers, riser switches and the emergency stop, watched by a thread of their own.
/**
 *   watching --(lines are gone)---------------> waiting    all contacts faulty, the stop latches
 *   waiting  --(back-off over, opened again)--> watching
 *
 *   released --(button pressed, or its line lost)-------------> latched
 *   latched  --(reset_emergency_stop(), button released)------> released
 *
 * After the edges are drained the levels are read again: the kernel's queue drops the newest edge
 * of a line that bounces, and says nothing. A press between two looks still counts, by its edge.
 */
class ContactLines
{
public:
  /// \param port outlives this
  /// \throws HardwareError if the emergency stop is not fitted, or two contacts share a line
  ContactLines(const ContactLinesConfig & config, LinePort & port, const DeviceClock & clock);
  ~ContactLines();
  ContactLines(const ContactLines &) = delete;
  ContactLines & operator=(const ContactLines &) = delete;

  /// Requests the lines, looks at each, and begins to watch.
  /**
   * A bumper or riser switch that is closed now is faulty until it was seen open. A pressed
   * emergency stop is latched, and one that was latched before still is.
   * \throws HardwareError if the lines cannot be had, or if all bumpers and switches are closed:
   *   no stairs press them all, a cable does
   */
  void start();

  /// Stops watching and gives the lines back; may be started again.
  void stop() noexcept;

  /// The newest state as of `now`; waits for nothing, allocates nothing. From one thread.
  [[nodiscard]] ContactLatest latest(Time now);

  /// Ends a latched emergency stop. \return why not: it is pressed, or cannot be read
  [[nodiscard]] std::optional<IoFault> reset_emergency_stop();

  /// For diagnostics, from any thread.
  [[nodiscard]] ContactReport report() const;

private:
  using Lock = std::lock_guard<std::mutex>;

  void run();
  void watch();
  void reopen();
  void take(const LineLevels & levels);
  void lose(const IoFault & fault);
  /// \return what is closed that must not all be; empty: nothing
  [[nodiscard]] std::string begin(const LineLevels & levels);
  void publish(Time now, std::optional<IoFaultKind> fault);
  void rest(Time duration);
  [[nodiscard]] Time patience() const;
  [[nodiscard]] bool stopping() const;

  LinePort & port_;
  DeviceClock clock_;
  Time poll_;
  DebounceLimits limits_;
  std::vector<LineRequest> requests_{};  // of what is fitted
  std::vector<std::size_t> places_{};    // of each of them
  std::vector<LineEdge> edges_{};        // the thread's
  LatestValue<ContactLatest> box_{};
  std::atomic<bool> latched_{false};

  mutable std::mutex mutex_{};  // guards what follows
  std::condition_variable changed_{};
  bool stopping_ = false;
  std::array<ContactDebounce, kContactPlaces> contacts_{};
  DeviceHealth health_;

  std::thread thread_{};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__LINES__CONTACT_LINES_HPP_
