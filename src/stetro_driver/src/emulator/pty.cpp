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

#include "emulator/pty.hpp"

#include <fcntl.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "linux/baud_rate.hpp"

namespace stetro_driver::emulator
{
namespace
{

[[noreturn]] void fail(const std::string & what)
{
  throw std::system_error(errno, std::generic_category(), what);
}

void prepare(int fd)
{
  fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) | O_NONBLOCK);
  fcntl(fd, F_SETFD, FD_CLOEXEC);
}

}  // namespace

Pty::Pty(std::string link) : link_(std::move(link)) { plug(); }

Pty::~Pty() { unplug(); }

void Pty::plug()
{
  if (plugged()) {
    return;
  }
  termios raw{};
  cfmakeraw(&raw);
  raw.c_cflag |= CREAD | CLOCAL;
  cfsetspeed(&raw, B115200);
  raw.c_cc[VMIN] = 1;
  std::array<char, 128> name{};
  if (openpty(&master_, &slave_, name.data(), &raw, nullptr) != 0) {
    fail("no pseudo-terminal for " + link_);
  }
  prepare(master_);
  prepare(slave_);
  unlink(link_.c_str());
  if (symlink(name.data(), link_.c_str()) != 0) {
    const int error = errno;
    unplug();
    errno = error;
    fail(link_);
  }
}

void Pty::unplug() noexcept
{
  if (!plugged()) {
    return;
  }
  unlink(link_.c_str());
  close(slave_);
  close(master_);
  slave_ = -1;
  master_ = -1;
}

std::uint32_t Pty::baud() const { return plugged() ? linux_io::baud_rate(slave_) : 0; }

std::size_t Pty::read(std::uint8_t * to, std::size_t room)
{
  const ssize_t count = plugged() ? ::read(master_, to, room) : 0;
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

void Pty::write(const std::uint8_t * from, std::size_t size)
{
  while (plugged() && size > 0) {
    const ssize_t count = ::write(master_, from, size);
    if (count <= 0) {
      return;
    }
    from += count;
    size -= static_cast<std::size_t>(count);
  }
}

}  // namespace stetro_driver::emulator
