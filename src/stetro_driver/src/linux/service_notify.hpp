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

#ifndef LINUX__SERVICE_NOTIFY_HPP_
#define LINUX__SERVICE_NOTIFY_HPP_

#include <sys/socket.h>
#include <sys/un.h>

#include <optional>
#include <string>
#include <string_view>

#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// Tells systemd how the service is: one datagram of `NAME=value` to the socket it names.
/**
 * The protocol of sd_notify(3), which needs no library. Without a socket nobody asked, and nothing
 * is sent. A service manager that does not listen never makes the caller wait.
 *
 * One thread.
 */
class ServiceNotify
{
public:
  /// What systemd put into the environment: NOTIFY_SOCKET, WATCHDOG_USEC, WATCHDOG_PID.
  /** \throws std::invalid_argument naming the variable, its value and what is accepted */
  [[nodiscard]] static ServiceNotify from_environment();

  /// \param socket path, or `@` and an abstract name; empty: nobody asked
  /// \param watchdog the service is ended if it is silent for so long; nothing: it is not watched
  /** \throws std::invalid_argument naming what is wrong with the socket */
  explicit ServiceNotify(const std::string & socket, std::optional<Time> watchdog = std::nullopt);
  ~ServiceNotify();
  ServiceNotify(const ServiceNotify &) = delete;
  ServiceNotify & operator=(const ServiceNotify &) = delete;

  /// The service has started. \return whether it was sent; false also if nobody asked
  bool ready();
  bool stopping();
  /// One line that `systemctl status` shows. Line breaks would start another assignment: blanks.
  bool status(std::string_view words);

  /// Feeds the watchdog. Called by the loop in each cycle in which its health holds, only then.
  /**
   * Sends once in half the watchdog's period, so that one lost datagram is no death. Neither waits
   * nor allocates. \param now of the steady clock
   */
  void alive(Time now);

  [[nodiscard]] bool asked() const { return fd_ >= 0; }
  [[nodiscard]] std::optional<Time> watchdog() const { return watchdog_; }

private:
  bool send(std::string_view message) const;

  int fd_ = -1;
  sockaddr_un to_{};
  socklen_t to_size_ = 0;
  std::optional<Time> watchdog_;
  std::optional<Time> fed_{};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__SERVICE_NOTIFY_HPP_
