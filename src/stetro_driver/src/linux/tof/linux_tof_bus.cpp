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

#include "linux/tof/linux_tof_bus.hpp"

#include <fcntl.h>
#include <gpiod.h>
#include <linux/i2c-dev.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <thread>

#include "stetro_driver/result.hpp"

namespace stetro_driver::linux_io
{
namespace
{

namespace fs = std::filesystem;

const char * const kConsumer = "stetro_tof_addresses";
constexpr std::chrono::seconds kBindPatience{2};  // the kernel may have to load its driver

[[noreturn]] void refuse(const std::string & what)
{
  const int error = errno;
  throw HardwareError(what + ": " + std::generic_category().message(error));
}

std::string hex4(int address)
{
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "%04x", static_cast<unsigned int>(address));
  return text.data();
}

}  // namespace

LinuxTofBus::LinuxTofBus(int number, std::string sysfs_root)
: number_(number),
  sysfs_root_(std::move(sysfs_root)),
  fd_(::open(("/dev/i2c-" + std::to_string(number)).c_str(), O_RDWR | O_CLOEXEC))
{
  if (fd_ < 0) {
    refuse("/dev/i2c-" + std::to_string(number) + " cannot be opened (`modprobe i2c-dev`?)");
  }
}

LinuxTofBus::~LinuxTofBus() { ::close(fd_); }

void LinuxTofBus::CloseChip::operator()(gpiod_chip * chip) const noexcept
{
  gpiod_chip_close(chip);
}

gpiod_chip * LinuxTofBus::chip(const std::string & name)
{
  auto & chip = chips_[name];
  if (!chip) {
    chip.reset(gpiod_chip_open_lookup(name.c_str()));
    if (!chip) {
      refuse("chip " + name + " cannot be opened");
    }
  }
  return chip.get();
}

void LinuxTofBus::hold_low(const XshutLine & line)
{
  gpiod_line * const xshut = gpiod_chip_get_line(chip(line.chip), line.offset);
  if (xshut == nullptr || gpiod_line_request_output(xshut, kConsumer, 0) != 0) {
    refuse("line " + to_string(line) + " cannot be requested");
  }
}

void LinuxTofBus::let_go(const XshutLine & line)
{
  // Given back as an output a line would keep its level on some chips, and lose it on others.
  gpiod_line * const xshut = gpiod_chip_get_line(chip(line.chip), line.offset);
  if (xshut == nullptr) {
    refuse("line " + to_string(line) + " cannot be found");
  }
  gpiod_line_release(xshut);
  if (gpiod_line_request_input(xshut, kConsumer) != 0) {
    refuse("line " + to_string(line) + " cannot be made an input");
  }
}

void LinuxTofBus::wait(Time duration) { std::this_thread::sleep_for(duration); }

void LinuxTofBus::select(int address)
{
  if (::ioctl(fd_, I2C_SLAVE, static_cast<long>(address)) != 0) {  // NOLINT(runtime/int): ioctl's
    refuse("address " + hex4(address) + " cannot be used (a driver of the kernel has it?)");
  }
}

std::optional<std::uint8_t> LinuxTofBus::read_register(int address, std::uint8_t index)
{
  select(address);
  std::uint8_t value = 0;
  if (::write(fd_, &index, 1) != 1 || ::read(fd_, &value, 1) != 1) {
    return std::nullopt;
  }
  return value;
}

void LinuxTofBus::write_register(int address, std::uint8_t index, std::uint8_t value)
{
  select(address);
  const std::array<std::uint8_t, 2> bytes{index, value};
  if (::write(fd_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
    refuse("address " + hex4(address) + " takes no register");
  }
}

std::string LinuxTofBus::device(int address) const
{
  return sysfs_root_ + "/bus/i2c/devices/" + std::to_string(number_) + "-" + hex4(address);
}

void LinuxTofBus::tell_kernel(const std::string & attribute, const std::string & text)
{
  const std::string path =
    sysfs_root_ + "/bus/i2c/devices/i2c-" + std::to_string(number_) + "/" + attribute;
  const int fd = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (fd < 0) {
    refuse(path + " cannot be opened");
  }
  const ssize_t size = ::write(fd, text.data(), text.size());
  const int error = errno;
  ::close(fd);
  if (size != static_cast<ssize_t>(text.size())) {
    errno = error;
    refuse(path + " does not take '" + text + "'");
  }
}

void LinuxTofBus::forget(int address)
{
  if (fs::exists(device(address))) {
    tell_kernel("delete_device", "0x" + hex4(address));
  }
}

void LinuxTofBus::bind(int address)
{
  tell_kernel("new_device", "vl53l0x 0x" + hex4(address));
  const auto give_up = std::chrono::steady_clock::now() + kBindPatience;
  while (!fs::exists(device(address) + "/driver")) {
    if (std::chrono::steady_clock::now() > give_up) {
      throw HardwareError(
        device(address) + ": no driver took it, accepted: vl53l0x (`modprobe vl53l0x-i2c`?)");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
  }
}

}  // namespace stetro_driver::linux_io
