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

#include "linux/serial_port.hpp"

#include <fcntl.h>
#include <linux/serial.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include "linux/baud_rate.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using Steady = std::chrono::steady_clock;

enum class Wake { kReady, kTimeOut, kGone };

// Waits for `events` until `deadline`; a signal does not shorten it.
Wake wait_for(int fd, std::int16_t events, Steady::time_point deadline)
{
  while (true) {
    const Time left = std::max<Time>(deadline - Steady::now(), Time::zero());
    timespec span{};
    span.tv_sec = left.count() / 1'000'000'000;
    span.tv_nsec = left.count() % 1'000'000'000;
    pollfd line{fd, events, 0};
    const int woken = ppoll(&line, 1, &span, nullptr);
    if (woken > 0) {
      // What came before a hang-up can still be read.
      return (line.revents & events) != 0 ? Wake::kReady : Wake::kGone;
    }
    if (woken == 0) {
      return Wake::kTimeOut;
    }
    if (errno != EINTR) {
      return Wake::kGone;
    }
  }
}

[[noreturn]] void refuse(const std::string & device, const std::string & what)
{
  throw HardwareError(device + ": " + what);
}

bool ask_low_latency(int fd)
{
  serial_struct line{};
  if (ioctl(fd, TIOCGSERIAL, &line) != 0) {
    return false;
  }
  line.flags |= ASYNC_LOW_LATENCY;
  return ioctl(fd, TIOCSSERIAL, &line) == 0;
}

}  // namespace

SerialPort::SerialPort(std::string device, const SerialPortConfig & config)
: device_(std::move(device))
{
  fd_ = open(config.path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (fd_ < 0) {
    refuse(
      device_, "cannot open '" + config.path + "': " + std::strerror(errno) +
                 "; accepted: the path of a serial device this user may open");
  }
  try {
    claim(config.path);
    set_raw(config);
  } catch (...) {
    close(fd_);
    throw;
  }
  low_latency_ = ask_low_latency(fd_);
}

SerialPort::~SerialPort()
{
  ioctl(fd_, TIOCNXCL);  // a pty whose other end lives on would stay ours for ever
  close(fd_);
}

void SerialPort::claim(const std::string & path)
{
  if (isatty(fd_) == 0) {
    refuse(device_, "'" + path + "' is not a serial device");
  }
  // The lock as well, because the kernel lets root open a port that is exclusive.
  if (flock(fd_, LOCK_EX | LOCK_NB) != 0) {
    refuse(device_, "'" + path + "' is in use; accepted: a port nobody else has open");
  }
  ioctl(fd_, TIOCEXCL);
}

void SerialPort::set_raw(const SerialPortConfig & config)
{
  termios line{};
  if (tcgetattr(fd_, &line) != 0) {
    refuse(device_, "'" + config.path + "' has no settings: " + std::strerror(errno));
  }
  cfmakeraw(&line);
  line.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
  line.c_cflag |= CREAD | CLOCAL;
  line.c_iflag &= ~static_cast<tcflag_t>(IXOFF | IXANY | INPCK);
  line.c_cc[VMIN] = 1;  // with 0, "nothing yet" would read as 0 bytes, as a hang-up does
  line.c_cc[VTIME] = 0;
  const auto baud = static_cast<std::uint32_t>(config.baud);
  if (tcsetattr(fd_, TCSANOW, &line) != 0 || !set_baud_rate(fd_, baud)) {
    refuse(
      device_, "'" + config.path + "' refuses " + std::to_string(config.baud) +
                 " bit/s: " + std::strerror(errno) + "; accepted: a speed of the adapter");
  }
  tcflush(fd_, TCIOFLUSH);
}

IoFault SerialPort::gone(const char * what) const
{
  return IoFault{IoFaultKind::kSilent, device_ + ": " + what};
}

Result<std::size_t> SerialPort::read(std::uint8_t * to, std::size_t room, Time patience)
{
  const auto deadline = Steady::now() + patience;
  while (true) {
    const Wake wake = wait_for(fd_, POLLIN, deadline);
    if (wake == Wake::kTimeOut) {
      return std::size_t{0};
    }
    if (wake == Wake::kGone) {
      return gone("unplugged");
    }
    const ssize_t count = ::read(fd_, to, room);
    if (count > 0) {
      return static_cast<std::size_t>(count);
    }
    if (count == 0) {
      return gone("unplugged");
    }
    if (errno != EAGAIN && errno != EINTR) {
      return gone(errno == EIO ? "unplugged" : "cannot be read");
    }
  }
}

std::optional<IoFault> SerialPort::write(const std::uint8_t * from, std::size_t size, Time patience)
{
  const auto deadline = Steady::now() + patience;
  while (size > 0) {
    const ssize_t count = ::write(fd_, from, size);
    if (count >= 0) {
      from += count;
      size -= static_cast<std::size_t>(count);
      continue;
    }
    if (errno != EAGAIN && errno != EINTR) {
      return gone(errno == EIO ? "unplugged" : "cannot be written");
    }
    switch (wait_for(fd_, POLLOUT, deadline)) {
      case Wake::kReady:
        break;
      case Wake::kTimeOut:
        return gone("takes no more bytes");
      case Wake::kGone:
        return gone("unplugged");
    }
  }
  return std::nullopt;
}

void SerialPort::drop_input() noexcept { tcflush(fd_, TCIFLUSH); }

}  // namespace stetro_driver::linux_io
