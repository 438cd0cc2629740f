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
#ifndef STETRO_TESTS__DEMO_RUN_HPP_
#define STETRO_TESTS__DEMO_RUN_HPP_

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "stetro_tests/loopback_domain.hpp"
#include "stetro_tests/process.hpp"
#include "stetro_tests/stack.hpp"

namespace stetro_tests
{

/// `stetro_demo`, running, with its results in a folder of its own.
class DemoRun
{
public:
  /// \param arguments beside --out
  explicit DemoRun(const std::vector<std::string> & arguments);

  /// Waits for its end. \return exit status, or -1 if it has not ended by then
  int wait(std::chrono::nanoseconds limit);

  /// What it printed last.
  [[nodiscard]] std::string tail() const;

  /// A file it left, whole; empty if there is none.
  [[nodiscard]] std::string file(const std::string & name) const;

private:
  LoopbackDomain domain_;
  TemporaryFolder folder_;
  std::unique_ptr<Process> process_;
};

}  // namespace stetro_tests

#endif  // STETRO_TESTS__DEMO_RUN_HPP_
