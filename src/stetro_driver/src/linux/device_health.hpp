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

#ifndef LINUX__DEVICE_HEALTH_HPP_
#define LINUX__DEVICE_HEALTH_HPP_

#include <cstdint>
#include <optional>
#include <string>

#include "stetro_driver/result.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// How long a lost device is left alone before it is opened again: doubled with every failure.
struct BackOff
{
  Time first = std::chrono::milliseconds{100};
  Time longest = std::chrono::seconds{2};
};

/// What a device has done since the start.
struct DeviceCounts
{
  std::uint64_t good = 0;
  std::uint64_t timeouts = 0;     ///< faults but kBadAnswer: nothing came, or the device is gone
  std::uint64_t bad_answers = 0;  ///< faults of kBadAnswer
  std::uint64_t reopens = 0;      ///< opened again after it had been closed
};

/// How one device is doing, and when it may be opened again.
/**
 *   open   --answered()-->  open     the fault is over, the next back-off is the shortest again
 *   open   --failed()---->  open     faulty since the first of them in a row
 *   open   --closed()---->  closed   for the back-off, which doubles
 *   closed --opened()---->  open     still faulty: only an answer ends that
 *
 * What cannot be opened is failed() and closed() again. Reads no clock: all times are given.
 * Not thread safe: its device guards it.
 */
class DeviceHealth
{
public:
  /// \param device how diagnostics call it
  explicit DeviceHealth(std::string device, const BackOff & back_off = {});

  void answered() noexcept;
  void failed(Time now, IoFault fault);
  void closed(Time now) noexcept;
  void opened() noexcept;

  [[nodiscard]] const std::string & device() const noexcept { return device_; }
  [[nodiscard]] const DeviceCounts & counts() const noexcept { return counts_; }
  [[nodiscard]] bool faulty() const noexcept { return faulty_since_.has_value(); }
  /// Of the first failure in a row; nothing while it is well.
  [[nodiscard]] std::optional<Time> faulty_since() const noexcept { return faulty_since_; }
  /// Failures since the last answer.
  [[nodiscard]] std::uint64_t failures_in_a_row() const noexcept { return failures_in_a_row_; }
  /// The newest ever, over or not.
  [[nodiscard]] const std::optional<IoFault> & last_fault() const noexcept { return last_fault_; }
  [[nodiscard]] bool is_closed() const noexcept { return open_at_.has_value(); }
  /// Whether a closed device has been left alone for long enough.
  [[nodiscard]] bool may_open(Time now) const noexcept { return open_at_ && now >= *open_at_; }
  /// When it may be opened; nothing while it is open.
  [[nodiscard]] std::optional<Time> open_at() const noexcept { return open_at_; }

private:
  std::string device_;
  BackOff back_off_;
  DeviceCounts counts_{};
  std::optional<Time> faulty_since_{};
  std::uint64_t failures_in_a_row_ = 0;
  std::optional<IoFault> last_fault_{};
  std::optional<Time> open_at_{};
  Time next_wait_;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__DEVICE_HEALTH_HPP_
