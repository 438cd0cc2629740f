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

#ifndef LOOPBACK_HPP_
#define LOOPBACK_HPP_

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "stetro_dds/context.hpp"

namespace stetro_driver::test
{

/// A domain that no other test process of this computer uses; ROS_DOMAIN_ID, if set, decides.
inline std::uint32_t free_domain()
{
  if (std::getenv("ROS_DOMAIN_ID") != nullptr) {
    return stetro_dds::ContextOptions::from_environment().domain_id;
  }
  constexpr std::uint32_t kFirst = 10;
  constexpr std::uint32_t kCount = 90;
  const auto start = static_cast<std::uint32_t>(::getpid());
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const std::uint32_t id = kFirst + (start + i) % kCount;
    const auto path = std::filesystem::temp_directory_path() /
                      ("stetro_test_domain_" + std::to_string(id) + ".lock");
    const int file = ::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0) {
      return id;  // the lock ends with the process
    }
    ::close(file);
  }
  throw std::runtime_error("no free domain id between 10 and 99");
}

/// Loopback only, on that domain, without a network between nodes of this process.
inline stetro_dds::ContextOptions loopback()
{
  static const std::uint32_t domain = free_domain();
  stetro_dds::ContextOptions options;
  options.domain_id = domain;
  return options;
}

}  // namespace stetro_driver::test

#endif  // LOOPBACK_HPP_
