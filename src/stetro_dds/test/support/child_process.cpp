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

#include "support/child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "support/test_domain.hpp"

namespace stetro_dds
{

ChildProcess::ChildProcess(const std::string & program, const std::vector<std::string> & arguments)
{
  static int count = 0;
  const auto name =
    "stetro_child_" + std::to_string(::getpid()) + "_" + std::to_string(++count) + ".log";
  log_path_ = (std::filesystem::temp_directory_path() / name).string();
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char *> argv;
  for (auto & word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  ::setenv("ROS_DOMAIN_ID", std::to_string(test_domain_id()).c_str(), 1);
  pid_ = ::fork();
  if (pid_ == 0) {
    const int log = ::open(log_path_.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
    ::dup2(log, STDERR_FILENO);
    ::execv(program.c_str(), argv.data());
    ::_exit(127);
  }
}

ChildProcess::~ChildProcess()
{
  if (!ended_) {
    send(SIGKILL);
    wait(std::chrono::seconds(5));
  }
  std::filesystem::remove(log_path_);
}

void ChildProcess::send(int signal) const { ::kill(pid_, signal); }

std::optional<int> ChildProcess::wait(std::chrono::milliseconds timeout)
{
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  int status = 0;
  while (::waitpid(pid_, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > deadline) {
      return std::nullopt;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ended_ = true;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string ChildProcess::said() const
{
  std::ostringstream text;
  text << std::ifstream(log_path_).rdbuf();
  return text.str();
}

}  // namespace stetro_dds
