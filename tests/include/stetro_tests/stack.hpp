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

#ifndef STETRO_TESTS__STACK_HPP_
#define STETRO_TESTS__STACK_HPP_

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "stetro_tests/loopback_domain.hpp"
#include "stetro_tests/process.hpp"

namespace stetro_tests
{

/// A folder below the temporary folder, removed with all that is in it.
class TemporaryFolder
{
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder & operator=(const TemporaryFolder &) = delete;

  [[nodiscard]] const std::filesystem::path & path() const { return path_; }

private:
  std::filesystem::path path_;
};

/// The four narrow steps that tests climb; `tests/data/site/short_flight.yaml`.
std::string short_flight();
/// The papers' 16 steps and their robot, as stetro_bringup ships them.
std::string papers_staircase();
std::string papers_robot();

/// Parameters by name, their values in YAML.
using Parameters = std::map<std::string, std::string>;

/// What to start the three processes with.
struct StackOptions
{
  std::string site = short_flight();
  double speed = 4.0;  ///< simulated seconds per second
  std::uint64_t seed = 7;
  std::string ros_distro{};      ///< empty: the default
  Parameters driver_extra{};     ///< further parameters, such as sim.faults
  Parameters localizer_extra{};  ///< likewise, such as estimator
};

/// An installed executable and the parameters to start it with.
std::vector<std::string> command_of(const std::string & executable, const Parameters & parameters);

/// The parameters that name the site and the papers' robot.
Parameters building_parameters(const std::string & site);

/// Driver (simulated), localizer and supervisor as processes, their files in a folder of their own.
class Stack
{
public:
  /// Starts all three.
  Stack(const LoopbackDomain & domain, StackOptions options);

  [[nodiscard]] Process & driver() { return *driver_; }
  [[nodiscard]] Process & localizer() { return *localizer_; }
  [[nodiscard]] Process & supervisor() { return *supervisor_; }

  /// Starts one (again), with the same arguments; the one before it is killed if it still runs.
  void start_driver();
  void start_localizer();
  void start_supervisor();

  /// The last lines of all three, for the message of a failure.
  [[nodiscard]] std::string tails() const;

private:
  [[nodiscard]] Process::Environment environment() const;
  [[nodiscard]] std::unique_ptr<Process> start(
    const std::string & name, Parameters parameters) const;

  const LoopbackDomain & domain_;
  const StackOptions options_;
  TemporaryFolder folder_;
  std::unique_ptr<Process> driver_;
  std::unique_ptr<Process> localizer_;
  std::unique_ptr<Process> supervisor_;
};

}  // namespace stetro_tests

#endif  // STETRO_TESTS__STACK_HPP_
