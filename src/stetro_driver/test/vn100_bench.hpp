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

#ifndef VN100_BENCH_HPP_
#define VN100_BENCH_HPP_

#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include "emulator/vn100_emulator.hpp"
#include "linux/imu/vn100.hpp"

namespace stetro_driver
{

/// A directory of its own for the links of emulated ports.
class PortDirectory
{
public:
  PortDirectory()
  {
    std::string name = (std::filesystem::temp_directory_path() / "stetro_imu_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~PortDirectory() { std::filesystem::remove_all(path_); }
  PortDirectory(const PortDirectory &) = delete;
  PortDirectory & operator=(const PortDirectory &) = delete;

  [[nodiscard]] std::string port() const { return (path_ / "imu").string(); }

private:
  std::filesystem::path path_;
};

/// Looks again and again until it is so. \return whether it was, before the deadline
inline bool comes_true(
  const std::function<bool()> & it, std::chrono::milliseconds deadline = std::chrono::seconds{20})
{
  const auto end = std::chrono::steady_clock::now() + deadline;
  while (!it()) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  return true;
}

/// Entries of a directory of /proc/self: `fd` are open files, `task` are threads.
inline std::size_t count_in_proc(const std::string & what)
{
  const auto list = std::filesystem::directory_iterator("/proc/self/" + what);
  return static_cast<std::size_t>(std::distance(begin(list), end(list)));
}

/// An emulated VN-100, and the configuration that finds it.
class Vn100Bench : public testing::Test
{
protected:
  Vn100Bench()
  {
    config_.serial.path = directory_.port();
    config_.rate_hz = 20;  // 150 ms are silence: more than a busy machine lets a thread wait
  }

  PortDirectory directory_;
  linux_io::DeviceClock clock_{std::chrono::seconds{1000}};
  emulator::Vn100EmulatorOptions options_{directory_.port()};
  linux_io::Vn100Config config_;
};

}  // namespace stetro_driver

#endif  // VN100_BENCH_HPP_
