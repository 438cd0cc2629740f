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

#ifndef LINUX__TOF__TOF_READER_HPP_
#define LINUX__TOF__TOF_READER_HPP_

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "latest_value.hpp"
#include "linux/device_clock.hpp"
#include "linux/device_health.hpp"
#include "linux/tof/vl53l0x_channel.hpp"
#include "linux/tof/vl53l0x_reading.hpp"
#include "stetro_driver/result.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// When a sensor is too slow to be believed, and how it is opened again.
struct TofTiming
{
  Time period = std::chrono::milliseconds{35};   ///< a measurement usually takes so long
  Time longest = std::chrono::milliseconds{70};  ///< beyond it, nobody knows when the light was out
  BackOff back_off{};

  /// Without an answer for so long the sensor is silent.
  [[nodiscard]] Time patience() const noexcept { return 3 * period; }
};

/// The newest a sensor says.
struct TofLatest
{
  RangeReading reading{};
  std::uint64_t number = 0;   ///< of the measurement; the same number is the same measurement
  std::uint32_t repeats = 0;  ///< readings in a row of exactly this millimetre, this one included
  /// Why the reading is not to be used; nothing: the sensor is well. Words: TofReport::health.
  std::optional<IoFaultKind> fault{IoFaultKind::kNotConfigured};
  Time answered{0};  ///< when a measurement ended last
};

/// What a sensor's measurements were, for diagnostics.
struct TofStatistics
{
  std::uint64_t valid = 0;
  std::uint64_t weak = 0;  ///< beyond the reliable range
  std::uint64_t too_near = 0;
  std::uint64_t no_target = 0;
  std::uint64_t slow = 0;             ///< took longer than TofTiming::longest
  std::uint32_t longest_repeats = 0;  ///< of one millimetre in a row, see TofLatest::repeats
  Time longest{0};                    ///< measurement
  Time total{0};                      ///< time of all measurements

  /// Adds a measurement that is `reading`.
  void add(const RangeReading & reading, const TofMeasurement & measurement, std::uint32_t repeats);
};

/// A sensor's health and statistics at one time.
struct TofReport
{
  DeviceHealth health;
  TofStatistics statistics;
};

/// Reads one sensor on a thread of its own, and opens it again when it was lost.
/**
 *   measuring --(no answer, or a bad one)--------> measuring    fault, reading is kFault
 *   measuring --(three of them in a row, gone)---> waiting      closed, for the back-off
 *   measuring --(took longer than `longest`)-----> measuring    fault, reading is kStale
 *   waiting   --(back-off over, found again)-----> measuring    still faulty until it answers
 *
 * A target that keeps still gives the same millimetre now and then, a stuck sensor gives it always:
 * repeats are counted here, and judged where it is known whether the robot moves.
 */
class TofReader
{
public:
  TofReader(
    std::string place, Vl53l0xChannel channel, const TofLimits & limits, const TofTiming & timing,
    const DeviceClock & clock);
  ~TofReader();
  TofReader(const TofReader &) = delete;
  TofReader & operator=(const TofReader &) = delete;

  /// Opens the sensor; before start(). \return why it cannot be
  [[nodiscard]] std::optional<IoFault> open();
  /// Begins to read; \pre not started
  void start();
  /// Asks the thread to stop and does not wait for it.
  void request_stop() noexcept;
  /// Stops reading and closes. Waits for a measurement that is under way: 100 ms, if the bus works.
  void stop() noexcept;

  /// Waits until it has answered well since start(), at most for `patience` of the machine's time.
  /** \return the last fault if it has not */
  [[nodiscard]] std::optional<IoFault> wait_for_answer(Time patience);

  /// The newest reading as of `now`; waits for nothing and allocates nothing. From one thread.
  [[nodiscard]] TofLatest latest(Time now);
  /// For diagnostics, from any thread.
  [[nodiscard]] TofReport report() const;
  /// Real path of the sensor's directory; between open() and start().
  [[nodiscard]] const std::string & directory() const noexcept { return channel_.directory(); }

private:
  void run();
  void reopen();
  void measure();
  void publish(const TofMeasurement & measurement);
  void publish_fault(IoFault fault);
  /// Sleeps for a duration of device time, or until stop().
  void rest(Time duration);
  [[nodiscard]] bool stopping() const;

  std::string place_;
  Vl53l0xChannel channel_;  // the thread's while it runs
  TofLimits limits_;
  TofTiming timing_;
  DeviceClock clock_;
  TofLatest newest_{};  // the thread's
  int last_mm_ = -1;    // the thread's
  LatestValue<TofLatest> box_{};

  mutable std::mutex mutex_{};  // guards what follows
  std::condition_variable changed_{};
  bool stopping_ = false;
  bool answered_ = false;
  DeviceHealth health_;
  TofStatistics statistics_{};

  std::thread thread_{};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__TOF__TOF_READER_HPP_
