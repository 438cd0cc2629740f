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

#ifndef LINUX__IMU__VN100_HPP_
#define LINUX__IMU__VN100_HPP_

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "linux/device_clock.hpp"
#include "linux/device_health.hpp"
#include "linux/imu/mean_rate.hpp"
#include "linux/imu/ned.hpp"
#include "linux/imu/sample_timeline.hpp"
#include "linux/imu/vn100_config.hpp"
#include "linux/imu/vn100_session.hpp"
#include "stetro_driver/result.hpp"
#include "stetro_driver/sensor_frame.hpp"

namespace stetro_driver::linux_io
{

/// What diagnostics print of a VN-100.
struct Vn100Statistics
{
  Vn100Identity identity;  ///< of the one that was accepted last
  DeviceCounts counts;
  std::uint64_t bad_checksums = 0;  ///< of the present connection
  std::uint64_t lost_bytes = 0;     ///< of the present connection, that belong to no frame
};

/// The robot's inertial sensor, a VN-100 on a serial port, in base_link and REP 103.
/**
 *   Trusted  --(no measurement for `silent_periods`)---------->  Faulty
 *   Faulty   --(kTrustAfter measurements in time)-------------->   Trusted
 *   Faulty   --(hang-up, or half a second faulty)-------------->   Closed    port released
 *   Closed   --(back-off over, the same unit answers)---------->   Faulty    configured again
 *
 * Silence, garbage, a slow or another sensor are all "no measurement in time"; which of them it
 * was is in the words of the fault. What has come back is asked for model and serial number before
 * it is believed: another unit may be screwed on in another way.
 *
 * A thread of its own reads. The rest may be called from any thread and waits for nothing.
 */
class Vn100
{
public:
  static constexpr int kTrustAfter = 3;

  /// Opens the port, checks who answers, configures it and awaits the first measurements.
  /** \throws HardwareError naming the sensor, what happened and what is accepted */
  Vn100(const Vn100Config & config, const DeviceClock & clock);
  ~Vn100();
  Vn100(const Vn100 &) = delete;
  Vn100 & operator=(const Vn100 &) = delete;

  /// The latest measurement with its time, and the mean rate of turn since the reading before.
  /**
   * Without a new measurement it is the reading before once more. Its `fault` says that it is not
   * to be used. For one reader, who misses the angles that another has taken. No memory is
   * allocated. \param now device time
   */
  [[nodiscard]] GyroReading reading(Time now);

  /// What is wrong now; nothing: all is well.
  [[nodiscard]] std::optional<IoFault> fault(Time now) const;

  [[nodiscard]] Vn100Statistics statistics() const;

private:
  void run();
  void converse();
  void open();
  /// \return whether it was called off
  bool wait_until(Time then);
  void take(const Vn100Frame & frame, Time arrival);
  void believe(const Vn100Sample & sample, Time stamp, Time lasted);
  void complain(const IoFault & fault);
  void close();
  [[nodiscard]] std::optional<Vn100Sample> sample_in(const Vn100Frame & frame);
  [[nodiscard]] IoFault silence(Time age) const;
  void await_first();
  void stop();

  const Vn100Config config_;
  const DeviceClock clock_;
  const ImuMounting mounting_;
  const Time limit_;  ///< a measurement may be so old

  // The reader's own.
  std::unique_ptr<Vn100Session> session_{};
  SampleTimeline timeline_{};
  std::optional<Time> uptime_{};
  Time opened_at_{0};
  Time stamp_{0};                  ///< of the newest measurement, believed or not
  int in_time_ = 0;                ///< measurements in a row without a gap
  std::uint64_t hurt_before_ = 0;  ///< bytes lost until the newest measurement

  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  GyroReading reading_{};  ///< but for the rate, which is in turning_ until it is asked for
  MeanRate turning_{};
  Vn100Identity identity_{};
  DeviceHealth health_;
  StreamCounts stream_{};

  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__IMU__VN100_HPP_
