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

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <thread>

#include "stetro_driver/realtime.hpp"

namespace stetro_driver::linux_io
{
namespace
{

/// What the kernel says of the thread that asked, whatever the report says.
struct Granted
{
  int policy = SCHED_OTHER;
  int priority = 0;
  int cpus = 0;
  bool locked = false;
};

bool some_memory_is_locked()
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmLck:", 0) == 0) {
      return std::stol(line.substr(6)) > 0;
    }
  }
  return false;
}

/// Asks in a thread that then ends, so that nothing is left behind.
RealtimeReport ask(const RealtimeConfig & config, Granted & granted)
{
  RealtimeReport report;
  std::thread([&] {
    report = ask_for_realtime(config);
    sched_param parameters{};
    pthread_getschedparam(pthread_self(), &granted.policy, &parameters);
    granted.priority = parameters.sched_priority;
    cpu_set_t cpus;
    pthread_getaffinity_np(pthread_self(), sizeof(cpus), &cpus);
    granted.cpus = CPU_COUNT(&cpus);
    granted.locked = some_memory_is_locked();
  }).join();
  munlockall();
  return report;
}

TEST(Realtime, NothingAskedIsNothingDone)
{
  Granted granted;
  const RealtimeReport report = ask({}, granted);
  EXPECT_FALSE(report.refused());
  EXPECT_EQ(report.words, "scheduled as any process");
  EXPECT_EQ(granted.policy, SCHED_OTHER);
  EXPECT_FALSE(granted.locked);
}

// Whether a machine grants it is its affair; what is reported must be what is so.
TEST(Realtime, TheReportIsWhatIsSo)
{
  Granted granted;
  const RealtimeReport report = ask({10, true, -1}, granted);
  EXPECT_EQ(report.priority == WishOutcome::kGranted, granted.policy == SCHED_FIFO) << report.words;
  EXPECT_EQ(granted.priority, report.priority == WishOutcome::kGranted ? 10 : 0);
  EXPECT_EQ(report.memory == WishOutcome::kGranted, granted.locked) << report.words;
  EXPECT_EQ(report.cpu, WishOutcome::kNotAsked);
  EXPECT_NE(report.words.find("SCHED_FIFO 10: "), std::string::npos) << report.words;
  EXPECT_EQ(report.refused(), report.words.find("refused") != std::string::npos);
}

TEST(Realtime, ACpuOfItsOwnIsOneCpu)
{
  cpu_set_t cpus;
  ASSERT_EQ(sched_getaffinity(0, sizeof(cpus), &cpus), 0);
  int mine = 0;
  while (!CPU_ISSET(mine, &cpus)) {
    ++mine;
  }
  Granted granted;
  const RealtimeReport report = ask({0, false, mine}, granted);
  EXPECT_EQ(report.cpu, WishOutcome::kGranted) << report.words;
  EXPECT_EQ(granted.cpus, 1);
}

TEST(Realtime, ARefusalIsToldWithARemedyAndTheRestGoesOn)
{
  Granted granted;
  const RealtimeReport report = ask({0, true, 1023}, granted);
  EXPECT_TRUE(report.refused());
  EXPECT_EQ(report.cpu, WishOutcome::kRefused);
  EXPECT_NE(report.words.find("CPU 1023 only: refused, "), std::string::npos) << report.words;
  EXPECT_NE(report.words.find("which CPUs there are"), std::string::npos) << report.words;
  EXPECT_NE(report.memory, WishOutcome::kNotAsked);
}

TEST(Realtime, EveryFieldAcceptsItsDefault)
{
  RealtimeConfig config;
  for (const auto & field : stetro_config::fields_of(config)) {
    EXPECT_TRUE(field.accepts(field.get())) << field.name;
  }
}

}  // namespace
}  // namespace stetro_driver::linux_io
