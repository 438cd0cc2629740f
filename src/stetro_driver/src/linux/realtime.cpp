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

#include "stetro_driver/realtime.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstring>

namespace stetro_driver::linux_io
{
namespace
{

/// Adds what became of a wish. \param error of errno; 0: it was granted
WishOutcome tell(
  std::string & words, const std::string & wish, int error, const std::string & remedy)
{
  words += (words.empty() ? "" : "; ") + wish;
  if (error == 0) {
    words += ": yes";
    return WishOutcome::kGranted;
  }
  words += ": refused, " + std::string(std::strerror(error)) + ", see " + remedy;
  return WishOutcome::kRefused;
}

int set_fifo(std::int64_t priority)
{
  sched_param wanted{};
  wanted.sched_priority = static_cast<int>(priority);
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted);
}

int pin_to(std::int64_t cpu)
{
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(static_cast<std::size_t>(cpu), &only);
  return pthread_setaffinity_np(pthread_self(), sizeof(only), &only);
}

}  // namespace

RealtimeReport ask_for_realtime(const RealtimeConfig & config)
{
  RealtimeReport report;
  if (config.lock_memory) {
    const int error = mlockall(MCL_CURRENT | MCL_FUTURE) == 0 ? 0 : errno;
    report.memory = tell(
      report.words, "memory locked", error, "LimitMEMLOCK of the service or memlock of the user");
  }
  if (config.cpu >= 0) {
    report.cpu = tell(
      report.words, "on CPU " + std::to_string(config.cpu) + " only", pin_to(config.cpu),
      "which CPUs there are");
  }
  if (config.priority > 0) {
    report.priority = tell(
      report.words, "SCHED_FIFO " + std::to_string(config.priority), set_fifo(config.priority),
      "LimitRTPRIO of the service or rtprio of the user");
  }
  if (report.words.empty()) {
    report.words = "scheduled as any process";
  }
  return report;
}

}  // namespace stetro_driver::linux_io
