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

#include "stetro_tests/loopback_domain.hpp"

#include <fcntl.h>
#include <net/if.h>
#include <sched.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace stetro_tests
{

namespace
{

constexpr std::uint32_t kFirstId = 40;  ///< 0 is where people try things, above 101 is not safe
constexpr std::uint32_t kLastId = 59;

/// Keeps this user's id in a user namespace, so that files stay ours.
void map_own_user(uid_t user, gid_t group)
{
  std::ofstream("/proc/self/setgroups") << "deny";
  std::ofstream("/proc/self/uid_map") << user << " " << user << " 1";
  std::ofstream("/proc/self/gid_map") << group << " " << group << " 1";
}

bool leave_network()
{
  if (unshare(CLONE_NEWNET) == 0) {
    return true;
  }
  const uid_t user = geteuid();
  const gid_t group = getegid();
  if (unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) {
    return false;
  }
  map_own_user(user, group);
  return true;
}

bool raise_loopback()
{
  ifreq request{};
  std::strncpy(request.ifr_name, "lo", IFNAMSIZ - 1);
  request.ifr_flags = IFF_UP | IFF_RUNNING | IFF_LOOPBACK;
  const int any_socket = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const bool raised = any_socket >= 0 && ioctl(any_socket, SIOCSIFFLAGS, &request) == 0;
  close(any_socket);
  return raised;
}

std::string enter_once()
{
  if (!leave_network()) {
    return std::string("no network namespace of its own: ") + std::strerror(errno);
  }
  if (!raise_loopback()) {
    throw std::runtime_error(std::string("the loopback stays down: ") + std::strerror(errno));
  }
  return "";
}

}  // namespace

std::string enter_network_of_its_own()
{
  static const std::string reason = enter_once();
  return reason;
}

LoopbackDomain::LoopbackDomain()
{
  enter_network_of_its_own();
  const auto folder = std::filesystem::temp_directory_path();
  for (id_ = kFirstId; id_ <= kLastId; ++id_) {
    const auto path = folder / ("stetro_tests_domain_" + std::to_string(id_));
    lock_ = open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (lock_ >= 0 && flock(lock_, LOCK_EX | LOCK_NB) == 0) {
      return;
    }
    close(lock_);
  }
  throw std::runtime_error("every domain id from 40 to 59 is in use by another test");
}

LoopbackDomain::~LoopbackDomain() { close(lock_); }

Process::Environment LoopbackDomain::environment() const
{
  return {{"ROS_DOMAIN_ID", std::to_string(id_)}};
}

}  // namespace stetro_tests
