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

#ifndef EMULATOR__EMULATED_TOF_HPP_
#define EMULATOR__EMULATED_TOF_HPP_

#include <sys/types.h>

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>

#include "linux/device_clock.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::emulator
{

/// What is wrong with a range sensor, and what the kernel's driver then gives to who reads it.
enum class TofTrouble {
  kNone,
  kSilent,   ///< never ready: ETIMEDOUT after 100 ms
  kNoReply,  ///< its wires are off: EREMOTEIO, at once
  kBadBus,   ///< somebody holds the bus: EIO, at once
  kGarbled,  ///< texts that are no distance
  kSlow,     ///< a measurement takes 90 ms
};

/// A VL53L0X behind the kernel's IIO driver: one read is one measurement, and waits for it.
/** Thread safe; as in the kernel nothing keeps two readers apart, which is counted. */
class EmulatedTof
{
public:
  explicit EmulatedTof(const linux_io::DeviceClock & clock);

  /// What it sees from now on [mm]; a measurement gives what it saw half-way.
  void see(int millimetres);
  /// Ends a measurement that is under way if the wires are off now.
  void set_trouble(TofTrouble trouble);
  /// Whether the kernel knows it; if not, reads give ENODEV.
  void set_bound(bool bound);

  /// Reads `in_distance_raw`: blocks 33 ms of device time. \return bytes, or -errno
  [[nodiscard]] ssize_t read(char * to, std::size_t room) noexcept;

  [[nodiscard]] std::uint64_t reads() const;
  /// Reads that began while another was under way.
  [[nodiscard]] std::uint64_t overlaps() const;

private:
  using Lock = std::unique_lock<std::mutex>;
  /// \return 0, or -errno
  [[nodiscard]] int measure(Lock & lock, int & millimetres);
  /// Sleeps unless it is lost meanwhile. \return 0, or -errno
  [[nodiscard]] int last(Lock & lock, Time duration);
  [[nodiscard]] int error() const noexcept;
  [[nodiscard]] ssize_t print(int millimetres, char * to, std::size_t room) noexcept;

  linux_io::DeviceClock clock_;
  mutable std::mutex mutex_{};
  std::condition_variable changed_{};
  int millimetres_ = 8190;
  TofTrouble trouble_ = TofTrouble::kNone;
  bool bound_ = true;
  int readers_ = 0;
  std::uint64_t reads_ = 0;
  std::uint64_t overlaps_ = 0;
  std::uint64_t garbled_ = 0;
};

}  // namespace stetro_driver::emulator

#endif  // EMULATOR__EMULATED_TOF_HPP_
