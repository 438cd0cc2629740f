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
#include "child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <thread>

extern char ** environ;

namespace stetro_bringup
{
namespace
{

using std::chrono_literals::operator""ms;

/// posix_spawn's descriptions of the child's files and signals, released again.
class SpawnPlan
{
public:
  explicit SpawnPlan(const std::string & log_file)
  {
    posix_spawn_file_actions_init(&files_);
    posix_spawnattr_init(&attributes_);
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, log_file.c_str(), flags, 0644);
    posix_spawn_file_actions_adddup2(&files_, STDOUT_FILENO, STDERR_FILENO);
    // The caller may have blocked the signals that are to end the child.
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK);
  }
  ~SpawnPlan()
  {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&files_);
  }
  SpawnPlan(const SpawnPlan &) = delete;
  SpawnPlan & operator=(const SpawnPlan &) = delete;

  [[nodiscard]] const posix_spawn_file_actions_t * files() const { return &files_; }
  [[nodiscard]] const posix_spawnattr_t * attributes() const { return &attributes_; }

private:
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string> & command, const std::string & log_file)
: name_(command.at(0))
{
  std::vector<char *> arguments;
  for (const std::string & argument : command) {
    arguments.push_back(const_cast<char *>(argument.c_str()));  // exec's old signature
  }
  arguments.push_back(nullptr);
  const SpawnPlan plan(log_file);
  const int error =
    posix_spawnp(&pid_, name_.c_str(), plan.files(), plan.attributes(), arguments.data(), environ);
  if (error != 0) {
    throw std::system_error(error, std::generic_category(), "starting " + name_);
  }
}

ChildProcess::~ChildProcess() { end(3000ms); }

std::optional<int> ChildProcess::ended()
{
  int status = 0;
  if (!status_ && waitpid(pid_, &status, WNOHANG) == pid_) {
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  return status_;
}

void ChildProcess::end(std::chrono::milliseconds patience)
{
  if (ended()) {
    return;
  }
  kill(pid_, SIGTERM);
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (!ended() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(10ms);
  }
  if (!ended()) {
    kill(pid_, SIGKILL);
    int status = 0;
    waitpid(pid_, &status, 0);
    status_ = 128 + SIGKILL;
  }
}

}  // namespace stetro_bringup
