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

#ifndef SUPPORT__CHILD_PROCESS_HPP_
#define SUPPORT__CHILD_PROCESS_HPP_

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace stetro_dds
{

/// A program started by a test, killed at the latest when the test is over.
class ChildProcess
{
public:
  /// Starts it in the test's domain, its stderr going to a file of its own.
  ChildProcess(const std::string & program, const std::vector<std::string> & arguments);
  ~ChildProcess();
  ChildProcess(const ChildProcess &) = delete;
  ChildProcess & operator=(const ChildProcess &) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  void send(int signal) const;

  /// Waits for its end. \return exit code, 128 + signal if it was killed, nothing if it lives on
  std::optional<int> wait(std::chrono::milliseconds timeout);

  /// What it wrote to stderr so far.
  [[nodiscard]] std::string said() const;

private:
  pid_t pid_ = -1;
  std::string log_path_;
  bool ended_ = false;
};

}  // namespace stetro_dds

#endif  // SUPPORT__CHILD_PROCESS_HPP_
