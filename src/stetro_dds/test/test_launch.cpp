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
#include <csignal>
#include <functional>
#include <string>
#include <vector>

#include "stetro_dds/launch.hpp"
#include "support/child_process.hpp"
#include "support/parameter_file.hpp"

namespace sample
{

struct Params
{
  double rate_hz = 30.0;
  std::string mode = "slow";
};

template <class Visitor>
void visit(Params & p, Visitor && each)
{
  each("rate_hz", p.rate_hz, stetro_config::Within{1.0, 100.0}, "how often [1/s]");
  each("mode", p.mode, stetro_config::OneOf{"slow", "fast"}, "how hard");
}

inline void check(const Params & p, stetro_config::Faults & faults)
{
  if (p.mode == "slow" && p.rate_hz > 50.0) {
    faults.refuse("rate_hz", stetro_config::to_text(p.rate_hz), "at most 50 in mode slow");
  }
}

}  // namespace sample

namespace stetro_dds
{
namespace
{

Launch launched_with(std::vector<const char *> words)
{
  words.insert(words.begin(), {"robot", "--ros-args"});
  return Launch(RosArguments::parse(static_cast<int>(words.size()), words.data()));
}

std::vector<std::string> faults_of(const Launch & launch)
{
  std::vector<std::string> names;
  try {
    launch.check();
  } catch (const stetro_config::ConfigError & error) {
    for (const auto & fault : error.faults()) {
      names.push_back(fault.name);
    }
  }
  return names;
}

TEST(Launch, ReadsFilesThenTheCommandLine)
{
  const ParameterFile file(
    "/**: {ros__parameters: {use_sim_time: true}}\n"
    "/stetro/driver: {ros__parameters: {rate_hz: 20.0, mode: fast}}\n");
  auto launch = launched_with({"--params-file", file.path().c_str(), "-p", "rate_hz:=40.0"});
  const auto driver = launch.configure<sample::Params>("driver", "/stetro");
  launch.check();
  EXPECT_EQ(driver.params.rate_hz, 40.0);
  EXPECT_EQ(driver.params.mode, "fast");
  EXPECT_EQ(driver.options.time, TimeSource::kClockTopic);
}

TEST(Launch, RenamesNodesAndTopics)
{
  auto launch = launched_with(
    {"-r", "__ns:=/robot1", "-r", "driver:__node:=wheels", "-r", "driver:scan:=/lidar"});
  const auto driver = launch.configure<sample::Params>("driver", "/stetro");
  const auto other = launch.configure<sample::Params>("localizer", "/stetro");
  launch.check();
  EXPECT_EQ(driver.options.ns, "/robot1");
  EXPECT_EQ(driver.options.name, "wheels");
  EXPECT_EQ(driver.options.remappings.size(), 1U);
  EXPECT_EQ(other.options.name, "localizer");
  EXPECT_TRUE(other.options.remappings.empty());
}

TEST(Launch, ReportsTheFaultsOfEveryNodeAtOnce)
{
  const ParameterFile file(
    "/driver: {ros__parameters: {rate_hz: 20, mod: fast}}\n"
    "/localizer: {ros__parameters: {rate_hz: 70.0, use_sim_time: 1}}\n");
  auto launch = launched_with(
    {"--params-file", file.path().c_str(), "-p", "driver:mode:=idle", "-p", "ghost:x:=1"});
  launch.configure<sample::Params>("driver");
  launch.configure<sample::Params>("localizer");
  const auto faults = faults_of(launch);
  EXPECT_EQ(faults, (std::vector<std::string>{"mod", "use_sim_time", "mode", "-p ghost:x"}));
  EXPECT_THROW(launch.context_options(), stetro_config::ConfigError);
}

TEST(Launch, FindsNumbersThatContradictEachOther)
{
  auto launch = launched_with({"-p", "rate_hz:=60.0"});
  launch.configure<sample::Params>("driver");
  EXPECT_EQ(faults_of(launch), std::vector<std::string>{"rate_hz"});
}

TEST(Launch, RefusesNodesOfOneProcessOnDifferentNetworks)
{
  auto launch = launched_with({"-p", "driver:dds.network:=subnet"});
  launch.configure<sample::Params>("driver");
  launch.configure<sample::Params>("localizer");
  EXPECT_EQ(faults_of(launch), std::vector<std::string>{"dds.network"});
}

TEST(Launch, RefusesNamesThatRosWouldNotTake)
{
  auto launch = launched_with({"-r", "__ns:=robot1", "-r", "scan:=a//b"});
  launch.configure<sample::Params>("driver");
  EXPECT_FALSE(faults_of(launch).empty());
}

TEST(Launch, MayBeStoppedBeforeItSpins)
{
  auto launch = launched_with({});
  Executor executor;
  launch.stop();
  launch.spin(executor);
  EXPECT_TRUE(launch.stop_requested());
}

/// The exit code of the program with these arguments, and what it said.
std::pair<int, std::string> run(const std::vector<std::string> & arguments)
{
  ChildProcess child(LONELY_NODE, arguments);
  const int code = child.wait(std::chrono::seconds(10)).value_or(-1);
  return {code, child.said()};
}

TEST(RunMain, EndsWith2AndEveryFaultWithItsPlace)
{
  const ParameterFile file("/test/lonely:\n  ros__parameters:\n    greting: x\n    period_s: 0\n");
  const auto [code, said] = run({"--ros-args", "--params-file", file.path(), "-p", "hang:=maybe"});
  EXPECT_EQ(code, 2);
  EXPECT_NE(said.find(file.path() + ":3: greting"), std::string::npos) << said;
  EXPECT_NE(said.find(file.path() + ":4: period_s"), std::string::npos) << said;
  EXPECT_NE(said.find("command line: hang"), std::string::npos) << said;
}

TEST(RunMain, EndsWith2OnANodeSectionGivenTwice)
{
  const ParameterFile file(
    "/test/lonely: {ros__parameters: {greeting: x}}\n"
    "test: {lonely: {ros__parameters: {greeting: y}}}\n");
  const auto [code, said] = run({"--ros-args", "--params-file", file.path()});
  EXPECT_EQ(code, 2);
  EXPECT_NE(said.find(file.path() + ":2: /test/lonely: "), std::string::npos) << said;
}

TEST(RunMain, WarnsOfASectionThatNamesNoNodeOfTheProgram)
{
  const ParameterFile file(
    "/test/lonly: {ros__parameters: {greeting: x}}\n"
    "/test/other: {ros__parameters: {greeting: y}}\n"
    "/test/*: {ros__parameters: {greeting: z}}\n");
  ChildProcess child(LONELY_NODE, {"--ros-args", "--params-file", file.path()});
  const auto warned = [&](const std::string & line, const std::string & section) {
    return child.said().find(
             "[warning] [lonely_node] " + file.path() + ":" + line + ": section '" + section +
             "' names no node of this program") != std::string::npos;
  };
  for (int i = 0; i < 500 && !warned("2", "/test/other"); ++i) {
    ASSERT_FALSE(child.wait(std::chrono::milliseconds(20))) << "another program's node is no fault";
  }
  EXPECT_TRUE(warned("1", "/test/lonly")) << child.said();
  EXPECT_TRUE(warned("2", "/test/other")) << child.said();
  EXPECT_EQ(child.said().find("'/test/*'"), std::string::npos) << child.said();
  child.send(SIGTERM);
  EXPECT_EQ(child.wait(std::chrono::seconds(5)), 0) << child.said();
}

TEST(RunMain, WarnsOnceAndBeforeTheFaults)
{
  const ParameterFile file("/test/lonly: {ros__parameters: {greeting: x}}\n");
  const auto [code, said] = run({"--ros-args", "--params-file", file.path(), "-p", "hang:=maybe"});
  EXPECT_EQ(code, 2);
  const auto warning = said.find("'/test/lonly'");
  ASSERT_NE(warning, std::string::npos) << said;
  EXPECT_EQ(said.find("'/test/lonly'", warning + 1), std::string::npos) << said;
  EXPECT_LT(warning, said.find("command line: hang")) << said;
}

TEST(RunMain, EndsWith2OnACommandLineItDoesNotUnderstand)
{
  EXPECT_EQ(run({"--bogus"}).first, 2);
  EXPECT_EQ(run({"--ros-args", "--bogus"}).first, 2);
  EXPECT_EQ(run({"--ros-args", "--params-file", "/no/such/file"}).first, 2);
  EXPECT_EQ(run({"--ros-args", "-p", "dds.network:=wide"}).first, 2);
}

TEST(RunMain, EndsWith2OnAnEnvironmentItDoesNotUnderstand)
{
  ::setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "GALAXY", 1);
  const auto [code, said] = run({});
  ::unsetenv("ROS_AUTOMATIC_DISCOVERY_RANGE");
  EXPECT_EQ(code, 2);
  EXPECT_NE(said.find("ROS_AUTOMATIC_DISCOVERY_RANGE"), std::string::npos) << said;
}

TEST(RunMain, EndsWith0AfterHelp) { EXPECT_EQ(run({"--help"}).first, 0); }

}  // namespace
}  // namespace stetro_dds
