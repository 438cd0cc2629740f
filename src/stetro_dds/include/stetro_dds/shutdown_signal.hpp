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

#ifndef STETRO_DDS__SHUTDOWN_SIGNAL_HPP_
#define STETRO_DDS__SHUTDOWN_SIGNAL_HPP_

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace stetro_dds
{

/// Turns SIGINT and SIGTERM into an orderly end.
/**
 * Construct it first in `main`, before any thread: it blocks both signals in all of them. The
 * first signal calls `on_signal` from a thread of its own; if this object still lives when
 * `limit` has passed, or on a second signal, the process ends at once with 128 + signal.
 */
class ShutdownSignal
{
public:
  explicit ShutdownSignal(
    std::function<void()> on_signal, std::chrono::milliseconds limit = std::chrono::seconds(3));
  ~ShutdownSignal();
  ShutdownSignal(const ShutdownSignal &) = delete;
  ShutdownSignal & operator=(const ShutdownSignal &) = delete;

  /// The signal that arrived, or 0.
  [[nodiscard]] int received() const { return received_; }

private:
  void watch();
  int next_signal(std::chrono::milliseconds timeout);

  std::function<void()> on_signal_;
  const std::chrono::milliseconds limit_;
  int signals_ = -1;  ///< signalfd
  int leave_ = -1;    ///< eventfd: the object is being destroyed
  std::atomic<int> received_{0};
  std::thread watcher_;
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__SHUTDOWN_SIGNAL_HPP_
