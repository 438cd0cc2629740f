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

#ifndef STETRO_TESTS__PROBE_HPP_
#define STETRO_TESTS__PROBE_HPP_

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stetro_dds/stamp.hpp"
#include "stetro_dds/subscription.hpp"
#include "stetro_tests/deadline.hpp"

namespace stetro_tests
{

/// Everything a topic said since the observer listens, and a place reached in it.
/**
 * `wait_for` searches on from that place and leaves it behind what it found, so that consecutive
 * waits find consecutive messages. Safe to use from several threads.
 */
template <class Message>
class Probe
{
public:
  using Predicate = std::function<bool(const Message &)>;
  struct Sample
  {
    Message message;
    std::chrono::nanoseconds steady;  ///< reception, on the steady clock [ns]
  };

  explicit Probe(std::string topic) : topic_(std::move(topic)) {}

  void add(const Message & message, const stetro_dds::Reception & reception)
  {
    {
      const std::lock_guard lock(mutex_);
      samples_.push_back({message, reception.steady});
    }
    arrived_.notify_all();
  }

  /// Waits for a message at or behind the place that fulfils the predicate.
  /** \return nothing if none had come when the limit had passed */
  std::optional<Message> wait_for(const Predicate & predicate, std::chrono::nanoseconds limit)
  {
    const Deadline deadline{limit};
    std::unique_lock lock(mutex_);
    for (;;) {
      for (; place_ < samples_.size(); ++place_) {
        if (predicate(samples_[place_].message)) {
          return samples_[place_++].message;
        }
      }
      if (deadline.passed()) {
        return std::nullopt;
      }
      arrived_.wait_for(lock, std::min<std::chrono::nanoseconds>(deadline.remaining(), 100ms));
    }
  }

  /// Waits for any message behind the place.
  std::optional<Message> wait_next(std::chrono::nanoseconds limit)
  {
    return wait_for([](const Message &) { return true; }, limit);
  }

  /// Moves the place behind all that has come so far.
  void forget()
  {
    const std::lock_guard lock(mutex_);
    place_ = samples_.size();
  }

  [[nodiscard]] std::size_t count() const
  {
    const std::lock_guard lock(mutex_);
    return samples_.size();
  }

  [[nodiscard]] std::optional<Message> last() const
  {
    const std::lock_guard lock(mutex_);
    return samples_.empty() ? std::nullopt : std::optional<Message>(samples_.back().message);
  }

  /// Copies of the samples from number `first` on.
  [[nodiscard]] std::vector<Sample> samples(std::size_t first = 0) const
  {
    const std::lock_guard lock(mutex_);
    return {
      samples_.begin() + static_cast<std::ptrdiff_t>(std::min(first, samples_.size())),
      samples_.end()};
  }

  [[nodiscard]] const std::string & topic() const { return topic_; }

  /// How much was heard, for the message of a failure.
  [[nodiscard]] std::string tail() const
  {
    return topic_ + ": " + std::to_string(count()) + " messages heard";
  }

private:
  const std::string topic_;
  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<Sample> samples_;
  std::size_t place_ = 0;
};

/// The time in a message's header.
template <class Message>
std::chrono::nanoseconds time_of(const Message & message)
{
  return stetro_dds::time_of(message.header().stamp());
}

}  // namespace stetro_tests

#endif  // STETRO_TESTS__PROBE_HPP_
