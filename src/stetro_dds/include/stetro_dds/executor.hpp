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

#ifndef STETRO_DDS__EXECUTOR_HPP_
#define STETRO_DDS__EXECUTOR_HPP_

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <vector>

namespace stetro_dds
{

class Node;
class WaitSet;

/// One thread that takes every sample and fires every timer of its nodes.
/**
 * A round visits the subscriptions in a fixed order (nodes as added, subscriptions as created),
 * each emptied in order of arrival, then the timers that are due in the same order. Handlers and
 * timers therefore never run at the same time, and need no locks.
 */
class Executor
{
public:
  Executor();
  ~Executor();
  Executor(const Executor &) = delete;
  Executor & operator=(const Executor &) = delete;

  /// \throws std::invalid_argument if the node already belongs to an executor
  void add(Node & node);
  void remove(Node & node);

  /// Rounds until `stop()`, sleeping between them until a sample or a timer is due.
  void spin();

  /// Waits at most `timeout` for something to do, then makes one round.
  /** \return samples taken and timers fired */
  std::size_t spin_some(std::chrono::nanoseconds timeout);

  /// Rounds, without waiting, until one finds nothing to do: all queues are empty then.
  /**
   * With intra-process delivery a message written before or during the call has been handled when
   * it returns, so a run fed by hand is repeatable.
   *
   * \param max_rounds guards against two handlers that answer each other for ever
   * \return samples taken and timers fired
   */
  std::size_t drain(std::size_t max_rounds = 1000);

  /// Makes `spin()` return; from any thread.
  void stop();
  [[nodiscard]] bool stopped() const { return stopped_; }

private:
  std::size_t round();
  void attach_new_subscriptions();
  [[nodiscard]] std::chrono::nanoseconds until_next_timer() const;

  std::vector<Node *> nodes_;
  std::unique_ptr<WaitSet> wait_set_;
  std::atomic<bool> stopped_{false};
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__EXECUTOR_HPP_
