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

#ifndef FRAME_QUEUE_HPP_
#define FRAME_QUEUE_HPP_

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "stetro_driver/sensor_frame.hpp"

namespace stetro_driver
{

/// Sensor frames on their way from the control loop to the thread that tells them.
/**
 * Frames that find no room are dropped and counted; the next one that does then says what they
 * would have said: that a cycle of ranges was complete. One writer, one reader, no lock.
 */
class FrameQueue
{
public:
  void put(const SensorFrame & frame)
  {
    ranges_owed_ = ranges_owed_ || frame.ranges_complete;
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (tail - head_.load(std::memory_order_acquire) == kRoom) {
      dropped_.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    SensorFrame & slot = frames_[tail % kRoom];
    slot = frame;
    slot.ranges_complete = ranges_owed_;
    ranges_owed_ = false;
    tail_.store(tail + 1, std::memory_order_release);
  }

  /// Takes the oldest frame out. \return whether there was one
  [[nodiscard]] bool take(SensorFrame & frame)
  {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    if (head == tail_.load(std::memory_order_acquire)) {
      return false;
    }
    frame = frames_[head % kRoom];
    head_.store(head + 1, std::memory_order_release);
    return true;
  }

  [[nodiscard]] std::uint64_t dropped() const { return dropped_.load(std::memory_order_relaxed); }

private:
  static constexpr std::size_t kRoom = 32;  // a third of a second at 100 Hz

  std::array<SensorFrame, kRoom> frames_{};
  bool ranges_owed_ = false;  // the writer's
  std::atomic<std::size_t> head_{0};
  std::atomic<std::size_t> tail_{0};
  std::atomic<std::uint64_t> dropped_{0};
};

}  // namespace stetro_driver

#endif  // FRAME_QUEUE_HPP_
