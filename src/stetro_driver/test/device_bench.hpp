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

#ifndef DEVICE_BENCH_HPP_
#define DEVICE_BENCH_HPP_

#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "stetro_driver/time.hpp"

namespace stetro_driver
{

/// A directory of a test's own, gone with it.
class TempDirectory
{
public:
  TempDirectory()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "stetro_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw std::runtime_error("no temporary directory at " + pattern);
    }
    path_ = pattern;
  }
  ~TempDirectory()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TempDirectory(const TempDirectory &) = delete;
  TempDirectory & operator=(const TempDirectory &) = delete;

  [[nodiscard]] const std::filesystem::path & path() const { return path_; }

private:
  std::filesystem::path path_;
};

/// What leaks when a device is opened again and again: descriptors and threads of this program.
struct OpenResources
{
  std::ptrdiff_t descriptors = count("/proc/self/fd");
  std::ptrdiff_t threads = count("/proc/self/task");

  bool operator==(const OpenResources & other) const
  {
    return descriptors == other.descriptors && threads == other.threads;
  }

private:
  static std::ptrdiff_t count(const char * directory)
  {
    return std::distance(
      std::filesystem::directory_iterator{directory}, std::filesystem::directory_iterator{});
  }
};

/// Waits until a condition holds. \return whether it did before the deadline
template <class Condition>
[[nodiscard]] bool eventually(
  Condition holds, std::chrono::milliseconds deadline = std::chrono::seconds{20})
{
  const auto give_up = std::chrono::steady_clock::now() + deadline;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > give_up) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  return true;
}

/// Polls a device as the control loop does until what it tells is faulty.
/** \param age of what it tells now, which is believed; nothing: it is faulty
 * \return how old the oldest was that was believed; nothing if it always was */
template <class Age>
[[nodiscard]] std::optional<Time> believed_for(Age age)
{
  Time believed{0};
  const bool noticed = eventually([&] {
    const std::optional<Time> now = age();
    believed = std::max(believed, now.value_or(Time{0}));
    return !now;
  });
  return noticed ? std::optional<Time>{believed} : std::nullopt;
}

}  // namespace stetro_driver

#endif  // DEVICE_BENCH_HPP_
