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

#include "linux/service_notify.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace stetro_driver::linux_io
{
namespace
{

std::string variable(const char * name)
{
  const char * value = std::getenv(name);
  return value ? value : "";
}

std::int64_t whole(const char * name, const std::string & text)
{
  std::int64_t value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end.ec != std::errc{} || end.ptr != text.data() + text.size() || value <= 0) {
    throw std::invalid_argument(
      std::string(name) + " is '" + text + "', accepted: a whole number above 0");
  }
  return value;
}

}  // namespace

ServiceNotify ServiceNotify::from_environment()
{
  const std::string period = variable("WATCHDOG_USEC");
  const std::string pid = variable("WATCHDOG_PID");
  std::optional<Time> watchdog;
  if (!period.empty() && (pid.empty() || whole("WATCHDOG_PID", pid) == getpid())) {
    watchdog = std::chrono::microseconds{whole("WATCHDOG_USEC", period)};
  }
  return ServiceNotify(variable("NOTIFY_SOCKET"), watchdog);
}

ServiceNotify::ServiceNotify(const std::string & socket, std::optional<Time> watchdog)
: watchdog_(watchdog)
{
  if (socket.empty()) {
    return;
  }
  if ((socket[0] != '/' && socket[0] != '@') || socket.size() >= sizeof(to_.sun_path)) {
    throw std::invalid_argument(
      "NOTIFY_SOCKET is '" + socket + "', accepted: an absolute path or @ and a name, at most " +
      std::to_string(sizeof(to_.sun_path) - 1) + " characters");
  }
  to_.sun_family = AF_UNIX;
  std::copy(socket.begin(), socket.end(), to_.sun_path);
  if (socket[0] == '@') {
    to_.sun_path[0] = '\0';  // an abstract name
  }
  to_size_ = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + socket.size());
  fd_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (fd_ < 0) {
    throw std::invalid_argument("NOTIFY_SOCKET: no socket, " + std::string(std::strerror(errno)));
  }
}

ServiceNotify::~ServiceNotify()
{
  if (fd_ >= 0) {
    close(fd_);
  }
}

bool ServiceNotify::ready() { return send("READY=1"); }

bool ServiceNotify::stopping() { return send("STOPPING=1"); }

bool ServiceNotify::status(std::string_view words)
{
  std::string message = "STATUS=" + std::string(words);
  std::replace(message.begin(), message.end(), '\n', ' ');
  return send(message);
}

void ServiceNotify::alive(Time now)
{
  if (!watchdog_ || (fed_ && now - *fed_ < *watchdog_ / 2)) {
    return;
  }
  if (send("WATCHDOG=1")) {
    fed_ = now;
  }
}

bool ServiceNotify::send(std::string_view message) const
{
  const auto * to = reinterpret_cast<const sockaddr *>(&to_);
  return fd_ >= 0 && sendto(fd_, message.data(), message.size(), MSG_NOSIGNAL, to, to_size_) ==
                       static_cast<ssize_t>(message.size());
}

}  // namespace stetro_driver::linux_io
