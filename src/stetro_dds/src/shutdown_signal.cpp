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

#include "stetro_dds/shutdown_signal.hpp"

#include <poll.h>
#include <signal.h>
#include <spdlog/spdlog.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <functional>
#include <system_error>
#include <thread>
#include <utility>

namespace stetro_dds
{

namespace
{

sigset_t shutdown_signals()
{
  sigset_t set;
  ::sigemptyset(&set);
  ::sigaddset(&set, SIGINT);
  ::sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

ShutdownSignal::ShutdownSignal(std::function<void()> on_signal, std::chrono::milliseconds limit)
: on_signal_(std::move(on_signal)), limit_(limit)
{
  const sigset_t set = shutdown_signals();
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
  signals_ = ::signalfd(-1, &set, SFD_CLOEXEC);
  leave_ = ::eventfd(0, EFD_CLOEXEC);
  if (signals_ < 0 || leave_ < 0) {
    throw std::system_error(errno, std::generic_category(), "waiting for signals");
  }
  watcher_ = std::thread([this] { watch(); });
}

ShutdownSignal::~ShutdownSignal()
{
  const std::uint64_t one = 1;
  if (::write(leave_, &one, sizeof(one)) == sizeof(one)) {
    watcher_.join();
  } else {
    watcher_.detach();
  }
  ::close(signals_);
  ::close(leave_);
}

void ShutdownSignal::watch()
{
  const int first = next_signal(std::chrono::milliseconds(-1));
  if (first == 0) {
    return;
  }
  received_ = first;
  spdlog::info("{}: shutting down", ::strsignal(first));
  on_signal_();
  constexpr int kTimeIsUp = -1;
  const int second = next_signal(limit_);
  if (second == 0) {
    return;
  }
  spdlog::critical(second == kTimeIsUp ? "not down in time, leaving at once" : "leaving at once");
  ::_exit(128 + first);
}

/// \return the signal, 0 if this object is being destroyed, -1 when the time is up
int ShutdownSignal::next_signal(std::chrono::milliseconds timeout)
{
  std::array<pollfd, 2> files{{{signals_, POLLIN, 0}, {leave_, POLLIN, 0}}};
  const int ready =
    ::poll(files.data(), static_cast<nfds_t>(files.size()), static_cast<int>(timeout.count()));
  if (ready == 0) {
    return -1;
  }
  if ((files[1].revents & POLLIN) != 0) {
    return 0;
  }
  signalfd_siginfo info{};
  const auto size = ::read(signals_, &info, sizeof(info));
  return size == sizeof(info) ? static_cast<int>(info.ssi_signo) : -1;
}

}  // namespace stetro_dds
