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
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "stetro_tests/deadline.hpp"
#include "stetro_tests/loopback_domain.hpp"
#include "stetro_tests/process.hpp"

namespace stetro_tests
{

TEST(Process, KeepsWhatTheChildPrintsAndHowItEnds)
{
  Process child({"/bin/sh", "-c", "echo out; echo err >&2; exit 3"});
  const auto ending = child.wait(10s);
  ASSERT_TRUE(ending);
  EXPECT_EQ(ending->exit_code, 3);
  EXPECT_EQ(ending->signal, 0);
  EXPECT_EQ(child.output(), "out\nerr\n");
}

TEST(Process, TellsASignalFromAnExit)
{
  Process child({"/bin/sleep", "60"});
  EXPECT_TRUE(child.running());
  child.signal(SIGTERM);
  const auto ending = child.wait(10s);
  ASSERT_TRUE(ending);
  EXPECT_EQ(ending->signal, SIGTERM);
}

TEST(Process, HidesWhatCouldLeadDdsElsewhere)
{
  setenv("ROS_DISCOVERY_SERVER", "192.0.2.1:11811", 1);
  setenv("FASTRTPS_DEFAULT_PROFILES_FILE", "/nowhere.xml", 1);
  Process child({"/usr/bin/env"}, {{"ROS_DOMAIN_ID", "41"}});
  ASSERT_TRUE(child.wait(10s));
  EXPECT_EQ(child.output().find("ROS_DISCOVERY_SERVER"), std::string::npos);
  EXPECT_EQ(child.output().find("FASTRTPS"), std::string::npos);
  EXPECT_NE(child.output().find("ROS_DOMAIN_ID=41\n"), std::string::npos);
}

TEST(Process, StandsStillBetweenPauseAndGoOn)
{
  Process child({"/bin/sh", "-c", "while :; do echo tick; sleep 0.01; done"});
  ASSERT_TRUE(poll_until([&] { return !child.output().empty(); }, 10s));
  child.pause();
  const std::string at_pause = child.output();
  std::ifstream status("/proc/" + std::to_string(child.pid()) + "/stat");
  std::string text;
  std::getline(status, text);
  EXPECT_NE(text.find(") T "), std::string::npos) << text;
  child.go_on();
  EXPECT_TRUE(poll_until([&] { return child.output().size() > at_pause.size(); }, 10s));
}

TEST(LoopbackDomain, IsHeldByOneAtATime)
{
  const LoopbackDomain one;
  const LoopbackDomain other;
  EXPECT_NE(one.id(), other.id());
  EXPECT_EQ(one.environment().at("ROS_DOMAIN_ID"), std::to_string(one.id()));
}

TEST(LoopbackDomain, HasNoInterfaceButTheLoopback)
{
  const std::string refusal = enter_network_of_its_own();
  if (!refusal.empty()) {
    GTEST_SKIP() << refusal;
  }
  std::ifstream devices("/proc/self/net/dev");
  int count = 0;
  for (std::string line; std::getline(devices, line);) {
    count += line.find(':') != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(count, 1);
}

}  // namespace stetro_tests
