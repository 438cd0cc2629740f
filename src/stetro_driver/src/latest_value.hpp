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

#ifndef LATEST_VALUE_HPP_
#define LATEST_VALUE_HPP_

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>

namespace stetro_driver
{

/// A box for one value, handed from one thread to another. Neither ever waits for the other.
/**
 * Three slots: one belongs to the writer, one to the reader, one lies between them and is exchanged
 * for either's own. What was not read before the next put() is lost, by design. Copies T, and
 * allocates only if that does. One writer, one reader.
 */
template <class T>
class LatestValue
{
public:
  void put(const T & value)
  {
    slots_[back_] = value;
    back_ = between_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kIndex;
  }

  /// The last value put; nothing before the first.
  [[nodiscard]] std::optional<T> latest()
  {
    if ((between_.load(std::memory_order_relaxed) & kFresh) != 0U) {
      front_ = between_.exchange(front_, std::memory_order_acq_rel) & kIndex;
      filled_ = true;
    }
    return filled_ ? std::optional<T>{slots_[front_]} : std::nullopt;
  }

private:
  static constexpr std::uint8_t kFresh = 4;  // the slot between holds what was not read yet
  static constexpr std::uint8_t kIndex = 3;

  std::array<T, 3> slots_{};
  std::uint8_t back_ = 0;   // the writer's
  std::uint8_t front_ = 1;  // the reader's
  bool filled_ = false;     // the reader's
  std::atomic<std::uint8_t> between_{2};
};

}  // namespace stetro_driver

#endif  // LATEST_VALUE_HPP_
