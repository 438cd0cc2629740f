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

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "stetro_dds/node.hpp"
#include "stetro_msgs/String.hpp"
#include "support/child_process.hpp"
#include "support/spin_until.hpp"
#include "support/test_domain.hpp"

namespace stetro_dds
{
namespace
{

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;
using std_msgs::msg::String;

constexpr char kLonelyNode[] = LONELY_NODE;

/// This process listens to a child.
class TwoProcesses : public testing::Test
{
protected:
  TwoProcesses()
  {
    // In this order: a child that says hello to us has met our reader of its echo before.
    node_.subscribe<String>(
      "echo", qos::kPose, [this](const String & message) { echo_ = message.data(); });
    node_.subscribe<String>("hello", qos::kPose, [this](const String &) { ++hellos_; });
    executor_.add(node_);
  }

  bool hears_hello_again()
  {
    const int before = hellos_;
    return spin_until(
      executor_, [&] { return hellos_ > before; }, 10s);
  }

  Context context_{test_options()};
  Node node_{context_, {"tester", "/test"}};
  Publisher<String> & say_ = node_.advertise<String>("say", qos::kPose);
  Executor executor_;
  int hellos_ = 0;
  std::string echo_;
};

TEST_F(TwoProcesses, FindEachOtherAndTalkBothWays)
{
  const ChildProcess child(kLonelyNode, {});
  ASSERT_TRUE(node_.wait_matched({}, 10s));
  ASSERT_TRUE(hears_hello_again());
  for (const char * word : {"one", "two", "three"}) {
    String message;
    message.data(word);
    say_.publish(message);
    EXPECT_TRUE(spin_until(
      executor_, [&] { return echo_ == word; }, 5s))
      << word;
  }
}

TEST_F(TwoProcesses, MeetAgainAfterAKill)
{
  for (int life = 0; life < 5; ++life) {
    ChildProcess child(kLonelyNode, {});
    const auto born = Clock::steady_now();
    ASSERT_TRUE(hears_hello_again()) << "life " << life;
    EXPECT_LT(Clock::steady_now() - born, 4s) << "life " << life;
    child.send(SIGKILL);
    EXPECT_EQ(child.wait(5s), 128 + SIGKILL);
    executor_.drain();
  }
}

TEST_F(TwoProcesses, ForgetAKilledPeerWithItsLease)
{
  ChildProcess child(kLonelyNode, {});
  ASSERT_TRUE(hears_hello_again());
  child.send(SIGKILL);
  child.wait(5s);
  EXPECT_TRUE(context_.wait_for([&] { return say_.matched() == 0; }, 8s));
}

TEST_F(TwoProcesses, SayGoodbyeAtOnceOnBothSignals)
{
  for (const int signal : {SIGTERM, SIGINT}) {
    ChildProcess child(kLonelyNode, {});
    ASSERT_TRUE(hears_hello_again());
    child.send(signal);
    EXPECT_EQ(child.wait(3s), 0) << child.said();
    EXPECT_TRUE(context_.wait_for([&] { return say_.matched() == 0; }, 1s));
  }
}

TEST_F(TwoProcesses, EndInTimeEvenIfTheTearDownHangs)
{
  ChildProcess child(kLonelyNode, {"--ros-args", "-p", "hang:=true"});
  ASSERT_TRUE(hears_hello_again());
  child.send(SIGTERM);
  EXPECT_FALSE(child.wait(1s)) << "it has three seconds";
  EXPECT_EQ(child.wait(5s), 128 + SIGTERM);
}

TEST_F(TwoProcesses, EndAtOnceOnASecondSignal)
{
  ChildProcess child(kLonelyNode, {"--ros-args", "-p", "hang:=true"});
  ASSERT_TRUE(hears_hello_again());
  child.send(SIGTERM);
  const auto told = [&] { return child.said().find("shutting down") != std::string::npos; };
  ASSERT_TRUE(spin_until(executor_, told, 5s)) << child.said();
  child.send(SIGINT);
  EXPECT_EQ(child.wait(1500ms), 128 + SIGTERM);
}

TEST_F(TwoProcesses, IgnoreProfilesFromTheEnvironment)
{
  ::setenv("FASTRTPS_DEFAULT_PROFILES_FILE", "/no/such/profiles.xml", 1);
  ::setenv("ROS_DISCOVERY_SERVER", "127.0.0.1:11811", 1);
  const ChildProcess child(kLonelyNode, {});
  ::unsetenv("FASTRTPS_DEFAULT_PROFILES_FILE");
  ::unsetenv("ROS_DISCOVERY_SERVER");
  EXPECT_TRUE(hears_hello_again()) << child.said();
  EXPECT_NE(child.said().find("FASTRTPS_DEFAULT_PROFILES_FILE is ignored"), std::string::npos);
}

}  // namespace
}  // namespace stetro_dds
