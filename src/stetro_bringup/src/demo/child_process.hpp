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
#ifndef DEMO__CHILD_PROCESS_HPP_
#define DEMO__CHILD_PROCESS_HPP_

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace stetro_bringup
{

/// A program of ours, running, with what it prints going to a file.
/** It is asked to end when this object goes, and made to if it does not; no other process is. */
class ChildProcess
{
public:
  /// \param command program (looked for in PATH) and arguments
  /// \param log_file takes standard output and standard error
  /// \throws std::system_error if it cannot be started or the file not be written
  ChildProcess(const std::vector<std::string> & command, const std::string & log_file);
  ~ChildProcess();
  ChildProcess(const ChildProcess &) = delete;
  ChildProcess & operator=(const ChildProcess &) = delete;

  [[nodiscard]] const std::string & name() const { return name_; }

  /// Exit status, 128 + signal if a signal ended it, nothing while it runs.
  [[nodiscard]] std::optional<int> ended();

private:
  void end(std::chrono::milliseconds patience);

  std::string name_;
  pid_t pid_ = -1;
  std::optional<int> status_;
};

}  // namespace stetro_bringup

#endif  // DEMO__CHILD_PROCESS_HPP_
