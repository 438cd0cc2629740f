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

#include "stetro_tests/stack.hpp"

#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace stetro_tests
{

namespace
{

std::string decimal(double value)
{
  std::ostringstream text;
  text << std::showpoint << value;  // "4." is no integer for YAML
  return text.str();
}

}  // namespace

TemporaryFolder::TemporaryFolder()
{
  std::string pattern = (std::filesystem::temp_directory_path() / "stetro_tests_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) {
    throw std::runtime_error("no temporary folder " + pattern);
  }
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string short_flight() { return STETRO_TESTS_DATA "/site/short_flight.yaml"; }

std::string papers_staircase()
{
  return find_share("stetro_bringup", "config/site/papers_staircase.yaml");
}

std::string papers_robot() { return find_share("stetro_bringup", "config/robot/stetro.yaml"); }

std::vector<std::string> command_of(const std::string & executable, const Parameters & parameters)
{
  std::vector<std::string> command = {find_executable(executable), "--ros-args"};
  for (const auto & [name, value] : parameters) {
    command.insert(command.end(), {"-p", name + ":=" + value});
  }
  return command;
}

Parameters building_parameters(const std::string & site)
{
  return {{"site_file", site}, {"robot_file", papers_robot()}};
}

Stack::Stack(const LoopbackDomain & domain, StackOptions options)
: domain_(domain), options_(std::move(options))
{
  start_driver();
  start_localizer();
  start_supervisor();
}

Process::Environment Stack::environment() const
{
  Process::Environment result = domain_.environment();
  if (!options_.ros_distro.empty()) {
    result["ROS_DISTRO"] = options_.ros_distro;
  }
  return result;
}

std::unique_ptr<Process> Stack::start(const std::string & name, Parameters parameters) const
{
  const Parameters building = building_parameters(options_.site);
  parameters.insert(building.begin(), building.end());
  return std::make_unique<Process>(command_of("stetro_" + name, parameters), environment());
}

void Stack::start_driver()
{
  driver_.reset();
  Parameters parameters = {
    {"sim.seed", std::to_string(options_.seed)},
    {"sim.speed", decimal(options_.speed)},
    {"sim.snapshot_file", (folder_.path() / "driver").string()}};
  parameters.insert(options_.driver_extra.begin(), options_.driver_extra.end());
  driver_ = start("driver", std::move(parameters));
}

void Stack::start_localizer()
{
  localizer_.reset();
  Parameters parameters = {
    {"use_sim_time", "true"}, {"state_file", (folder_.path() / "localizer").string()}};
  parameters.insert(options_.localizer_extra.begin(), options_.localizer_extra.end());
  localizer_ = start("localizer", std::move(parameters));
}

void Stack::start_supervisor()
{
  supervisor_.reset();
  supervisor_ = start(
    "supervisor",
    {{"use_sim_time", "true"}, {"state_file", (folder_.path() / "supervisor").string()}});
}

std::string Stack::tails() const
{
  return driver_->tail() + localizer_->tail() + supervisor_->tail();
}

}  // namespace stetro_tests
