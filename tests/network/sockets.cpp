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

#include "network/sockets.hpp"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace stetro_tests
{

namespace
{

namespace fs = std::filesystem;

std::set<std::string> socket_inodes_of(pid_t pid)
{
  std::set<std::string> result;
  for (const auto & entry : fs::directory_iterator("/proc/" + std::to_string(pid) + "/fd")) {
    std::error_code gone;
    const std::string target = fs::read_symlink(entry.path(), gone).string();
    if (target.rfind("socket:[", 0) == 0) {
      result.insert(target.substr(8, target.size() - 9));
    }
  }
  return result;
}

/// "0100007F" is 127.0.0.1: the bytes are in the host's order, lowest first.
std::string dotted(const std::string & hex)
{
  if (hex.size() != 8) {
    return hex;
  }
  std::ostringstream text;
  for (std::size_t i = 0; i < 4; ++i) {
    text << (i > 0 ? "." : "") << std::stoi(hex.substr(6 - 2 * i, 2), nullptr, 16);
  }
  return text.str();
}

/// One line of /proc/net/udp and its like: slot, local address, remote, state, ..., inode (tenth).
void add_listed(
  const std::string & protocol, const std::string & line, const std::set<std::string> & inodes,
  std::vector<OpenSocket> & found)
{
  std::istringstream fields(line);
  std::string slot;
  std::string local;
  std::string other;
  fields >> slot >> local;
  for (int i = 0; i < 8; ++i) {
    fields >> other;
  }
  const auto colon = local.find(':');
  if (colon != std::string::npos && inodes.count(other) > 0) {
    found.push_back(
      {protocol, dotted(local.substr(0, colon)), std::stoi(local.substr(colon + 1), nullptr, 16)});
  }
}

}  // namespace

std::vector<OpenSocket> sockets_of(pid_t pid)
{
  const std::set<std::string> inodes = socket_inodes_of(pid);
  const std::string net = "/proc/" + std::to_string(pid) + "/net/";
  std::vector<OpenSocket> found;
  for (const char * protocol : {"udp", "udp6", "tcp", "tcp6", "raw", "raw6"}) {
    std::ifstream list(net + protocol);
    std::string line;
    std::getline(list, line);  // the heading
    while (std::getline(list, line)) {
      add_listed(protocol, line, inodes, found);
    }
  }
  std::ifstream packets(net + "packet");
  std::string line;
  while (std::getline(packets, line)) {
    const std::string inode = line.substr(line.find_last_of(' ') + 1);
    if (inodes.count(inode) > 0) {
      found.push_back({"packet", "any", 0});
    }
  }
  return found;
}

}  // namespace stetro_tests
