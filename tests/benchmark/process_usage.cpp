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

#include "benchmark/process_usage.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace bench
{

// From schedstat, which counts nanoseconds; stat counts ticks of 10 ms.
std::chrono::nanoseconds cpu_time_of(pid_t pid)
{
  std::int64_t sum = 0;
  const std::string tasks = "/proc/" + std::to_string(pid) + "/task";
  for (const auto & task : std::filesystem::directory_iterator(tasks)) {
    std::ifstream file(task.path() / "schedstat");
    std::int64_t on_cpu = 0;
    file >> on_cpu;
    sum += on_cpu;
  }
  return std::chrono::nanoseconds(sum);
}

double pss_mib_of(pid_t pid)
{
  std::ifstream file("/proc/" + std::to_string(pid) + "/smaps_rollup");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("Pss:", 0) == 0) {
      return std::stod(line.substr(4)) / 1024.0;
    }
  }
  throw std::runtime_error("no PSS of process " + std::to_string(pid));
}

}  // namespace bench
