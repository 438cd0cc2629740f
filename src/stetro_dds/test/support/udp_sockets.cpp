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

#include "support/udp_sockets.hpp"

#include <arpa/inet.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace stetro_dds
{

namespace
{

/// Inodes of the sockets this process has open.
std::set<std::string> open_sockets()
{
  std::set<std::string> inodes;
  for (const auto & file : std::filesystem::directory_iterator("/proc/self/fd")) {
    std::error_code gone;
    const std::string target = std::filesystem::read_symlink(file.path(), gone).string();
    if (target.rfind("socket:[", 0) == 0) {
      inodes.insert(target.substr(8, target.size() - 9));
    }
  }
  return inodes;
}

}  // namespace

std::vector<std::string> bound_udp_addresses()
{
  const auto ours = open_sockets();
  std::vector<std::string> addresses;
  std::ifstream table("/proc/self/net/udp");
  std::string line;
  std::getline(table, line);  // the heading
  while (std::getline(table, line)) {
    std::istringstream columns(line);
    std::vector<std::string> words;
    for (std::string word; columns >> word;) {
      words.push_back(word);
    }
    constexpr std::size_t kLocalAddress = 1;
    constexpr std::size_t kInode = 9;
    if (words.size() > kInode && ours.count(words[kInode]) > 0) {
      in_addr address{};
      address.s_addr =
        static_cast<in_addr_t>(std::stoul(words[kLocalAddress].substr(0, 8), nullptr, 16));
      std::array<char, INET_ADDRSTRLEN> text{};
      ::inet_ntop(AF_INET, &address, text.data(), text.size());
      addresses.emplace_back(text.data());
    }
  }
  return addresses;
}

}  // namespace stetro_dds
