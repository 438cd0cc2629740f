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
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stetro_dds/executor.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_msgs/Clock.hpp"
#include "stetro_msgs/DiagnosticArray.hpp"
#include "stetro_msgs/RangeArray.hpp"
#include "stetro_msgs/String.hpp"
#include "support/spin_until.hpp"
#include "support/test_domain.hpp"

namespace stetro_dds
{
namespace
{

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;
using std_msgs::msg::String;

rosgraph_msgs::msg::Clock clock_message(std::int32_t sec, std::uint32_t nanosec = 0)
{
  rosgraph_msgs::msg::Clock message;
  message.clock().sec(sec);
  message.clock().nanosec(nanosec);
  return message;
}

class NodeInOneProcess : public testing::Test
{
protected:
  Context context_{test_options()};
  Executor executor_;
};

TEST_F(NodeInOneProcess, TakesItsTimeFromTheClockTopic)
{
  Node world(context_, {"world"});
  Node robot(context_, {"robot", "/", TimeSource::kClockTopic});
  auto & clock = world.advertise<rosgraph_msgs::msg::Clock>("/clock", qos::kClock);
  std::vector<Time> ticks;
  robot.create_timer(100ms, [&](Time now) { ticks.push_back(now); });
  executor_.add(robot);
  EXPECT_FALSE(robot.clock().known());
  for (std::uint32_t i = 0; i <= 30; ++i) {
    clock.publish(clock_message(1000, i * 10'000'000));
    executor_.drain();
  }
  EXPECT_EQ(robot.clock().now(), 1000s + 300ms);
  EXPECT_EQ(ticks, (std::vector<Time>{1000s + 100ms, 1000s + 200ms, 1000s + 300ms}));
}

TEST_F(NodeInOneProcess, RefusesAndCountsTimeZeroAndThePastOnTheClockTopic)
{
  Node world(context_, {"world"});
  Node robot(context_, {"robot", "/", TimeSource::kClockTopic});
  auto & clock = world.advertise<rosgraph_msgs::msg::Clock>("/clock", qos::kClock);
  executor_.add(robot);
  for (const int second : {0, 1000, 999}) {
    clock.publish(clock_message(second));
    executor_.drain();
  }
  EXPECT_EQ(robot.clock().now(), 1000s);
  EXPECT_EQ(robot.clock().faults().zero, 1U);
  EXPECT_EQ(robot.clock().faults().backwards, 1U);
  EXPECT_EQ(robot.subscriptions().front()->counts().refused_by_reason.at("time zero"), 1U);
}

TEST_F(NodeInOneProcess, CountsRefusalsByReason)
{
  Node node(context_, {"node"});
  auto & words = node.advertise<String>("words", qos::kPose);
  auto & heard = node.subscribe<String>(
    "words", qos::kPose, [](const String & message) -> std::optional<Refusal> {
      if (message.data().empty()) {
        return Refusal{"empty"};
      }
      return std::nullopt;
    });
  executor_.add(node);
  for (const char * word : {"a", "", "b", ""}) {
    String message;
    message.data(word);
    words.publish(message);
    executor_.drain();
  }
  EXPECT_EQ(heard.counts().accepted, 2U);
  EXPECT_EQ(heard.counts().refused, 2U);
  EXPECT_EQ(heard.counts().refused_by_reason.at("empty"), 2U);
  EXPECT_EQ(heard.counts().received(), 4U);
}

TEST_F(NodeInOneProcess, KeepsAFewReasonsHoweverManyThereAre)
{
  Node node(context_, {"node"});
  auto & words = node.advertise<String>("words", qos::kPose);
  auto & heard = node.subscribe<String>("words", qos::kPose, [n = 0](const String &) mutable {
    return std::optional<Refusal>{Refusal{std::to_string(n++)}};
  });
  executor_.add(node);
  for (int i = 0; i < 1000; ++i) {
    words.publish(String{});
    executor_.drain();
  }
  EXPECT_EQ(heard.counts().refused, 1000U);
  EXPECT_LT(heard.counts().refused_by_reason.size(), 40U);
  EXPECT_GT(heard.counts().refused_by_reason.at("others"), 900U);
}

TEST_F(NodeInOneProcess, TellsWhenAndFromWhomASampleCame)
{
  Node node(context_, {"node"});
  auto & words = node.advertise<String>("words", qos::kPose);
  Reception reception{};
  node.subscribe<String>(
    "words", qos::kPose, [&](const String &, const Reception & came) { reception = came; });
  executor_.add(node);
  const auto before = Clock::steady_now();
  words.publish(String{});
  const auto after = Clock::steady_now();
  executor_.drain();
  EXPECT_EQ(reception.writer, words.guid());
  EXPECT_GT(reception.steady, before - 1ms);
  EXPECT_LT(reception.steady, after + 1ms) << "the reception, not the taking";
}

TEST_F(NodeInOneProcess, SendsNothingBeyondItsBounds)
{
  Node node(context_, {"node"});
  auto & ranges = node.advertise<stetro_msgs::msg::RangeArray>("ranges", qos::kSensor);
  stetro_msgs::msg::RangeArray message;
  EXPECT_TRUE(ranges.publish(message));
  message.readings().resize(1000);
  EXPECT_FALSE(ranges.publish(message));
  EXPECT_EQ(ranges.counts().published, 1U);
  EXPECT_EQ(ranges.counts().out_of_bounds, 1U);
}

TEST_F(NodeInOneProcess, ReportsToDiagnosticsEachSecond)
{
  NodeOptions options{"robot", "/test"};
  options.hardware_id = "vl53l0x-7";
  Node robot(context_, options);
  robot.diagnostics().add("ranging", [](DiagnosticReport & report) {
    report.summarise(Health::kWarn, "a sensor is silent");
    report.summarise(Health::kOk, "not this");
    report.value("silent", std::int64_t{1});
  });
  auto & words = robot.advertise<String>("words", qos::kPose);
  robot.subscribe<String>("words", qos::kPose, [](const String &) {
    return std::optional<Refusal>{{"stale", ""}};
  });
  robot.lifecycle().request(LifecycleTransition::kConfigure);

  Node monitor(context_, {"monitor"});
  std::map<std::string, diagnostic_msgs::msg::DiagnosticStatus> last;
  int arrays = 0;
  monitor.subscribe<diagnostic_msgs::msg::DiagnosticArray>(
    "/diagnostics", qos::kDiagnostics, [&](const diagnostic_msgs::msg::DiagnosticArray & array) {
      for (const auto & status : array.status()) {
        last[status.name()] = status;
        arrays += status.name() == "robot: topics" ? 1 : 0;
      }
      EXPECT_GT(array.header().stamp().sec(), 0);
    });
  executor_.add(robot);
  executor_.add(monitor);
  words.publish(String{});
  const auto begin = Clock::steady_now();
  ASSERT_TRUE(spin_until(
    executor_, [&] { return arrays == 2; }, 10s));
  EXPECT_GT(Clock::steady_now() - begin, 1500ms);

  EXPECT_EQ(last["robot: ranging"].level(), 1);
  EXPECT_EQ(last["robot: ranging"].message(), "a sensor is silent");
  EXPECT_EQ(last["robot: ranging"].hardware_id(), "vl53l0x-7");
  EXPECT_EQ(last["robot: lifecycle"].values().at(0).value(), "inactive");
  std::map<std::string, std::string> values;
  for (const auto & pair : last["robot: topics"].values()) {
    values[pair.key()] = pair.value();
  }
  EXPECT_EQ(values["/test/words refused: stale"], "1");
  EXPECT_EQ(values["/test/words published"], "1");
  EXPECT_EQ(values["/test/words malformed"], "0");
}

TEST_F(NodeInOneProcess, WarnsOfNewTroubleOnly)
{
  Node node(context_, {"node"});
  auto & words = node.advertise<String>("words", qos::kPose);
  node.subscribe<String>("words", qos::kPose, [](const String &) {
    return std::optional<Refusal>{{"stale", ""}};
  });
  executor_.add(node);
  words.publish(String{});
  executor_.drain();
  const auto topics = [&] { return node.diagnostics().reports().at(2).second.health(); };
  EXPECT_EQ(topics(), Health::kWarn);
  EXPECT_EQ(topics(), Health::kOk);
}

}  // namespace
}  // namespace stetro_dds
