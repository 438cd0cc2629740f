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

#include "accuracy/machine.hpp"

#include <fstream>
#include <istream>
#include <string>
#include <thread>

namespace stetro_bringup
{

Machine this_machine()
{
  std::ifstream cpuinfo("/proc/cpuinfo");
  return {std::thread::hardware_concurrency(), cpu_model(cpuinfo)};
}

// "model name" is a PC's; many ARM boards name only themselves, as "Model", at the end.
std::string cpu_model(std::istream & cpuinfo)
{
  std::string board;
  for (std::string line; std::getline(cpuinfo, line);) {
    const auto colon = line.find(": ");
    if (colon == std::string::npos) {
      continue;
    }
    if (line.rfind("model name", 0) == 0) {
      return line.substr(colon + 2);
    }
    if (line.rfind("Model", 0) == 0) {
      board = line.substr(colon + 2);
    }
  }
  return board;
}

}  // namespace stetro_bringup
