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

#include "stetro_tests/process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "stetro_tests/deadline.hpp"

namespace stetro_tests
{

namespace
{

/// What a child may know of our environment. All that could lead DDS elsewhere is left out.
constexpr const char * kKept[] = {
  "PATH",         "HOME",         "TMPDIR",        "LD_LIBRARY_PATH", "AMENT_PREFIX_PATH",
  "ASAN_OPTIONS", "LSAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS",    "STETRO_TEST_TIME_FACTOR"};

std::vector<std::string> scrubbed(const Process::Environment & added)
{
  std::vector<std::string> result;
  for (const char * name : kKept) {
    const char * value = std::getenv(name);
    if (value != nullptr && added.count(name) == 0) {
      result.push_back(std::string(name) + "=" + value);
    }
  }
  for (const auto & [name, value] : added) {
    result.push_back(name + "=" + value);
  }
  return result;
}

std::vector<char *> pointers(std::vector<std::string> & strings)
{
  std::vector<char *> result;
  for (std::string & text : strings) {
    result.push_back(text.data());
  }
  result.push_back(nullptr);
  return result;
}

[[noreturn]] void fail(const std::string & what)
{
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

/// The first of `paths` that exists below a prefix of the workspace.
std::string find_below_prefixes(const std::vector<std::string> & paths)
{
  const char * prefixes = std::getenv("AMENT_PREFIX_PATH");
  std::istringstream list(prefixes != nullptr ? prefixes : "");
  for (std::string prefix; std::getline(list, prefix, ':');) {
    for (const std::string & path : paths) {
      const std::filesystem::path candidate = std::filesystem::path(prefix) / path;
      if (std::filesystem::exists(candidate)) {
        return candidate.string();
      }
    }
  }
  throw std::runtime_error(
    "no " + paths.front() + " below AMENT_PREFIX_PATH (" + list.str() +
    "): source the workspace's setup file");
}

}  // namespace

Process::Process(std::vector<std::string> command, const Environment & environment)
: command_(std::move(command)), output_(memfd_create("output", MFD_CLOEXEC))
{
  if (output_ < 0) {
    fail("memfd_create");
  }
  start(environment);
}

void Process::start(const Environment & environment)
{
  std::vector<std::string> variables = scrubbed(environment);
  const std::vector<char *> envp = pointers(variables);
  std::vector<std::string> words = command_;
  const std::vector<char *> argv = pointers(words);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0) {
    fail("fork");
  }
  if (pid_ > 0) {
    return;
  }
  // In the child, between fork and exec: only what is safe in a copy of a process with threads.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) {
    _exit(127);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  dup2(output_, STDOUT_FILENO);
  dup2(output_, STDERR_FILENO);
  execve(argv[0], argv.data(), envp.data());
  dprintf(STDERR_FILENO, "cannot start %s: errno %d\n", argv[0], errno);
  _exit(127);
}

Process::~Process()
{
  kill_hard();
  close(output_);
}

void Process::reap(int options)
{
  int status = 0;
  if (!ending_ && waitpid(pid_, &status, options) == pid_) {
    if (WIFEXITED(status)) {
      ending_ = Ending{WEXITSTATUS(status), 0};
    } else if (WIFSIGNALED(status)) {
      ending_ = Ending{-1, WTERMSIG(status)};
    }
  }
}

bool Process::running()
{
  reap(WNOHANG);
  return !ending_;
}

void Process::signal(int number)
{
  if (running() && kill(pid_, number) != 0) {
    fail("kill");
  }
}

void Process::pause()
{
  signal(SIGSTOP);
  siginfo_t info{};
  if (waitid(P_PID, static_cast<id_t>(pid_), &info, WSTOPPED | WEXITED | WNOWAIT) != 0) {
    fail("waitid");
  }
}

void Process::go_on() { signal(SIGCONT); }

void Process::kill_hard()
{
  signal(SIGKILL);
  reap(0);
}

std::optional<Ending> Process::wait(std::chrono::nanoseconds limit)
{
  poll_until([this] { return !running(); }, limit);
  return ending_;
}

std::string Process::output() const
{
  struct stat status
  {
  };
  fstat(output_, &status);
  std::string text(static_cast<std::size_t>(status.st_size), '\0');
  const ssize_t count = pread(output_, text.data(), text.size(), 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return text;
}

std::string Process::tail(std::size_t lines) const
{
  const std::string text = output();
  std::size_t from = text.size();
  for (std::size_t seen = 0; from > 0; --from) {
    if (text[from - 1] == '\n' && seen++ == lines) {
      break;
    }
  }
  return "--- " + command_.front() + " printed:\n" + text.substr(from);
}

std::string find_executable(const std::string & name)
{
  return find_below_prefixes({"bin/" + name, "lib/" + name + "/" + name});
}

std::string find_share(const std::string & package, const std::string & path)
{
  return find_below_prefixes({"share/" + package + "/" + path});
}

}  // namespace stetro_tests
