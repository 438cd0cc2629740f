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
#include "stetro_tests/demo_run.hpp"

#include <fstream>
#include <sstream>

namespace stetro_tests
{

DemoRun::DemoRun(const std::vector<std::string> & arguments)
{
  std::vector<std::string> command = {
    find_executable("stetro_demo"), "--out", folder_.path().string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  process_ = std::make_unique<Process>(command, domain_.environment());
}

int DemoRun::wait(std::chrono::nanoseconds limit)
{
  const auto ending = process_->wait(limit);
  return ending ? ending->exit_code : -1;
}

std::string DemoRun::tail() const { return process_->tail(); }

std::string DemoRun::file(const std::string & name) const
{
  std::ifstream file(folder_.path() / name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace stetro_tests
