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
#include <memory>
#include <string>
#include <vector>

#include "stetro_dds/node.hpp"
#include "stetro_msgs/Header.hpp"
#include "stetro_msgs/String.hpp"
#include "support/raw_publisher.hpp"
#include "support/spin_until.hpp"
#include "support/test_domain.hpp"
#include "support/udp_sockets.hpp"

namespace stetro_dds
{
namespace
{

using std::chrono_literals::operator""s;
using std_msgs::msg::String;

/// The report of a node's task.
DiagnosticReport report_of(Node & node, const std::string & task)
{
  for (auto & [name, report] : node.diagnostics().reports()) {
    if (name == task) {
      return report;
    }
  }
  return {};
}

/// Waits until the node's topics report tells of a mismatch. \return its summary
std::string mismatch_told_by(Node & node, Executor & executor)
{
  std::string message;
  spin_until(
    executor,
    [&] {
      message = report_of(node, "topics").message();
      return message.find("cannot match") != std::string::npos;
    },
    10s);
  return message;
}

TEST(Discovery, FindsMoreParticipantsThanTheMiddlewareDoesByDefault)
{
  constexpr std::size_t kProcesses = 12;  // the default stops at 4
  std::vector<std::unique_ptr<Context>> contexts;
  std::vector<std::unique_ptr<Node>> nodes;
  for (std::size_t i = 0; i < kProcesses; ++i) {
    contexts.push_back(std::make_unique<Context>(test_options(false)));
    nodes.push_back(std::make_unique<Node>(*contexts.back(), NodeOptions{"n" + std::to_string(i)}));
    nodes.back()->advertise<String>("words", qos::kPose);
    nodes.back()->subscribe<String>("words", qos::kPose, [](const String &) {});
  }
  for (std::size_t i = 0; i < kProcesses; ++i) {
    const auto & words = nodes[i]->subscriptions().front();
    EXPECT_TRUE(
      contexts[i]->wait_for([&] { return words->matched() == static_cast<int>(kProcesses); }, 10s))
      << i << " has found " << words->matched();
  }
}

TEST(Discovery, BindsNothingBut127001)
{
  Context context(test_options());
  Node node(context, {"node"});
  node.advertise<String>("words", qos::kPose);
  const auto addresses = bound_udp_addresses();
  EXPECT_GE(addresses.size(), 2U);
  for (const auto & address : addresses) {
    EXPECT_EQ(address, "127.0.0.1");
  }
}

TEST(Discovery, ReportsAWriterThatOffersTooLittle)
{
  Context theirs(test_options(false));
  Context ours(test_options(false));
  Node them(theirs, {"them"});
  Node us(ours, {"us"});
  Executor executor;
  executor.add(us);
  us.subscribe<String>("words", qos::kPose, [](const String &) {});
  constexpr QosProfile kWeak{
    "weak", qos::best_effort(1), qos::best_effort(1), qos::kPose.heartbeat, "tests"};
  const auto & weak = them.advertise<String>("words", kWeak);
  const auto told = mismatch_told_by(us, executor);
  EXPECT_NE(told.find("/words"), std::string::npos) << told;
  EXPECT_NE(told.find(to_string(weak.guid())), std::string::npos) << told;
  EXPECT_NE(told.find("reliability"), std::string::npos) << told;
}

TEST(Discovery, ReportsAReaderThatWantsMore)
{
  Context theirs(test_options(false));
  Context ours(test_options(false));
  Node them(theirs, {"them"});
  Node us(ours, {"us"});
  Executor executor;
  executor.add(us);
  us.advertise<String>("words", qos::kPose);
  them.subscribe<String>("words", qos::kLatched, [](const String &) {});
  EXPECT_NE(mismatch_told_by(us, executor).find("durability"), std::string::npos);
}

TEST(Discovery, ReportsAPeerWithAnotherType)
{
  Context theirs(test_options(false));
  Context ours(test_options(false));
  Node them(theirs, {"them"});
  Node us(ours, {"us"});
  Executor executor;
  executor.add(us);
  us.subscribe<String>("words", qos::kPose, [](const String &) {});
  them.advertise<std_msgs::msg::Header>("words", qos::kPose);
  EXPECT_NE(mismatch_told_by(us, executor).find("Header_"), std::string::npos);
}

TEST(Discovery, ReportsAPeerOfTheSameProcessToo)
{
  Context context(test_options());
  Node them(context, {"them"});
  Node us(context, {"us"});
  Executor executor;
  executor.add(us);
  us.advertise<String>("words", qos::kPose);
  them.subscribe<String>("words", qos::kLatched, [](const String &) {});
  EXPECT_NE(mismatch_told_by(us, executor).find("durability"), std::string::npos);
}

TEST(Discovery, TellsWhichTopicsHaveNoPeer)
{
  Context context(test_options());
  Node us(context, {"us", "/test"});
  us.subscribe<String>("words", qos::kPose, [](const String &) {});
  us.subscribe<String>("silence", qos::kPose, [](const String &) {});
  us.advertise<String>("words", qos::kPose);
  EXPECT_EQ(us.unmatched(), std::vector<std::string>{"/test/silence"});
  EXPECT_TRUE(us.wait_matched({"words"}, 5s));
  EXPECT_FALSE(us.wait_matched({}, std::chrono::milliseconds(10)));
}

TEST(Discovery, RefusesASecondTypeOnOneTopic)
{
  Context context(test_options());
  Node us(context, {"us"});
  us.advertise<String>("words", qos::kPose);
  EXPECT_THROW(us.advertise<std_msgs::msg::Header>("words", qos::kPose), std::runtime_error);
}

}  // namespace
}  // namespace stetro_dds
