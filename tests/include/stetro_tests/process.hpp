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

#ifndef STETRO_TESTS__PROCESS_HPP_
#define STETRO_TESTS__PROCESS_HPP_

#include <sys/types.h>

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace stetro_tests
{

/// How a process ended.
struct Ending
{
  int exit_code = -1;  ///< what it returned; -1 if a signal ended it
  int signal = 0;      ///< what ended it; 0 if it returned
};

/// A child of the test, by its id: nothing else is ever signalled.
/**
 * Its environment holds what is given and a few harmless variables (PATH, library paths, sanitizer
 * options); what it prints is kept. It dies with the test, however the test ends.
 */
class Process
{
public:
  using Environment = std::map<std::string, std::string>;

  /// Starts `command` (program and arguments) with `environment` added to the scrubbed one.
  /** \throws std::runtime_error if it cannot be started */
  explicit Process(std::vector<std::string> command, const Environment & environment = {});
  ~Process();
  Process(const Process &) = delete;
  Process & operator=(const Process &) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  [[nodiscard]] bool running();
  void signal(int number);
  void pause();      ///< SIGSTOP, and waits until it has stopped
  void go_on();      ///< SIGCONT
  void kill_hard();  ///< SIGKILL, and reaps it

  /// Waits for its end. \return nothing if it still runs when the limit has passed
  std::optional<Ending> wait(std::chrono::nanoseconds limit);

  /// Standard output and error so far, in the order written.
  [[nodiscard]] std::string output() const;
  /// The last lines of it, headed by the command: for the message of a failure.
  [[nodiscard]] std::string tail(std::size_t lines = 30) const;

private:
  void start(const Environment & environment);
  void reap(int options);

  std::vector<std::string> command_;
  int output_ = -1;  ///< file without a name
  pid_t pid_ = -1;
  std::optional<Ending> ending_;
};

/// The installed executable: `bin/<name>` or `lib/<name>/<name>` in a prefix of AMENT_PREFIX_PATH.
/** \throws std::runtime_error naming what was looked for and where */
std::string find_executable(const std::string & name);

/// `share/<package>/<path>` in the first prefix of AMENT_PREFIX_PATH that has it.
/** \throws std::runtime_error naming what was looked for and where */
std::string find_share(const std::string & package, const std::string & path);

}  // namespace stetro_tests

#endif  // STETRO_TESTS__PROCESS_HPP_
