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

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "stetro_dds/executor.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_msgs/String.hpp"
#include "support/test_domain.hpp"

namespace stetro_dds
{
namespace
{

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;
using std_msgs::msg::String;

String text(const std::string & content)
{
  String message;
  message.data(content);
  return message;
}

/// A talker and a listener in one process.
class OneProcess : public testing::Test
{
protected:
  Context context_{test_options()};
  Node talker_{context_, {"talker", "/test"}};
  Node listener_{context_, {"listener", "/test"}};
  Executor executor_;
};

TEST_F(OneProcess, DrainSeesWhatWasWrittenBefore)
{
  auto & words = talker_.advertise<String>("words", qos::kPose);
  std::vector<std::string> heard;
  listener_.subscribe<String>(
    "words", qos::kPose, [&](const String & message) { heard.push_back(message.data()); });
  executor_.add(listener_);
  for (int i = 0; i < 1000; ++i) {
    const std::string word = std::to_string(i);
    ASSERT_TRUE(words.publish(text(word)));
    executor_.drain();
    ASSERT_EQ(heard.size(), static_cast<std::size_t>(i + 1));
    ASSERT_EQ(heard.back(), word);
  }
}

TEST_F(OneProcess, BestEffortSensorsAreSynchronousToo)
{
  auto & words = talker_.advertise<String>("words", qos::kSensor);
  int heard = 0;
  listener_.subscribe<String>("words", qos::kSensor, [&](const String &) { ++heard; });
  executor_.add(listener_);
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(words.publish(text("x")));
    executor_.drain();
    ASSERT_EQ(heard, i + 1);
  }
}

TEST_F(OneProcess, DrainFollowsAnswersUntilAllQueuesAreEmpty)
{
  auto & questions = talker_.advertise<String>("question", qos::kCommand);
  auto & answers = listener_.advertise<String>("answer", qos::kCommand);
  std::vector<std::string> order;
  talker_.subscribe<String>("answer", qos::kCommand, [&](const String & message) {
    order.push_back(message.data());
    if (order.size() < 6) {
      questions.publish(text("q"));
    }
  });
  listener_.subscribe<String>("question", qos::kCommand, [&](const String & message) {
    order.push_back(message.data());
    answers.publish(text("a"));
  });
  executor_.add(talker_);
  executor_.add(listener_);
  questions.publish(text("q"));
  EXPECT_EQ(executor_.drain(), 6U);
  EXPECT_EQ(order, (std::vector<std::string>{"q", "a", "q", "a", "q", "a"}));
}

TEST_F(OneProcess, RoundsVisitNodesAndSubscriptionsInTheirOrder)
{
  auto & first = talker_.advertise<String>("first", qos::kPose);
  auto & second = talker_.advertise<String>("second", qos::kPose);
  std::vector<std::string> order;
  const auto note = [&order](const std::string & who) {
    return [&order, who](const String & message) { order.push_back(who + message.data()); };
  };
  listener_.subscribe<String>("first", qos::kPose, note("L1:"));
  listener_.subscribe<String>("second", qos::kPose, note("L2:"));
  talker_.subscribe<String>("second", qos::kPose, note("T2:"));
  executor_.add(talker_);
  executor_.add(listener_);
  second.publish(text("a"));  // written in the other order than taken
  second.publish(text("b"));
  first.publish(text("c"));
  executor_.drain();
  EXPECT_EQ(order, (std::vector<std::string>{"T2:a", "T2:b", "L1:c", "L2:a", "L2:b"}));
}

TEST_F(OneProcess, LatchedMessagesReachALateReader)
{
  auto & words = talker_.advertise<String>("words", qos::kLatched);
  words.publish(text("old"));
  words.publish(text("latest"));
  std::string heard;
  listener_.subscribe<String>(
    "words", qos::kLatched, [&](const String & message) { heard = message.data(); });
  executor_.add(listener_);
  const auto deadline = Clock::steady_now() + 5s;
  while (heard.empty() && Clock::steady_now() < deadline) {
    executor_.spin_some(10ms);
  }
  EXPECT_EQ(heard, "latest");
}

TEST_F(OneProcess, SpinWakesForASampleFromAnotherThread)
{
  auto & words = talker_.advertise<String>("words", qos::kPose);
  int heard = 0;
  listener_.subscribe<String>("words", qos::kPose, [&](const String &) {
    if (++heard >= 100) {
      executor_.stop();
    }
  });
  executor_.add(listener_);
  std::thread writer([&] {
    while (!executor_.stopped()) {
      words.publish(text("x"));
      std::this_thread::yield();
    }
  });
  executor_.spin();
  writer.join();
  EXPECT_GE(heard, 100) << "a round is finished before the stop";
}

TEST_F(OneProcess, AnIdleExecutorSleeps)
{
  listener_.subscribe<String>("words", qos::kPose, [](const String &) {});
  executor_.add(listener_);
  std::thread stopper([&] {
    std::this_thread::sleep_for(300ms);  // the time it is given to prove it
    executor_.stop();
  });
  const auto cpu_before = std::clock();
  executor_.spin();
  stopper.join();
  const double cpu_s = static_cast<double>(std::clock() - cpu_before) / CLOCKS_PER_SEC;
  EXPECT_LT(cpu_s, 0.1);
}

TEST_F(OneProcess, ANodeMayGoBeforeItsExecutor)
{
  {
    Node passing(context_, {"passing", "/test"});
    passing.subscribe<String>("words", qos::kPose, [](const String &) {});
    executor_.add(passing);
    executor_.drain();
  }
  executor_.add(listener_);
  EXPECT_NO_THROW(executor_.spin_some(1ms));
}

TEST_F(OneProcess, ANodeHasOneExecutor)
{
  Executor other;
  executor_.add(listener_);
  EXPECT_THROW(other.add(listener_), std::invalid_argument);
}

TEST_F(OneProcess, SubscriptionsMadeLaterAreServed)
{
  executor_.add(listener_);
  executor_.spin_some(1ms);
  int heard = 0;
  listener_.subscribe<String>("words", qos::kPose, [&](const String &) { ++heard; });
  talker_.advertise<String>("words", qos::kPose).publish(text("x"));
  executor_.spin_some(1s);
  EXPECT_EQ(heard, 1);
}

}  // namespace
}  // namespace stetro_dds
