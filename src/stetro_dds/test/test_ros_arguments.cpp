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

#include <string>
#include <vector>

#include "stetro_config/fault.hpp"
#include "stetro_dds/ros_arguments.hpp"

namespace stetro_dds
{
namespace
{

RosArguments parse(const std::vector<const char *> & words)
{
  return RosArguments::parse(static_cast<int>(words.size()), words.data());
}

std::size_t faults_of(const std::vector<const char *> & words)
{
  try {
    parse(words);
  } catch (const stetro_config::ConfigError & error) {
    return error.faults().size();
  }
  return 0;
}

TEST(RosArguments, AreFoundBetweenTheirMarks)
{
  const auto arguments = parse(
    {"driver", "--own", "--ros-args", "--params-file", "a.yaml", "-p", "rate_hz:=50.0", "-r",
     "__ns:=/robot1", "--log-level", "debug", "--", "other", "--ros-args", "--params-file",
     "b.yaml"});
  EXPECT_EQ(arguments.others, (std::vector<std::string>{"driver", "--own", "other"}));
  EXPECT_EQ(arguments.params_files, (std::vector<std::string>{"a.yaml", "b.yaml"}));
  ASSERT_EQ(arguments.overrides.size(), 1U);
  EXPECT_EQ(arguments.overrides[0].name, "rate_hz");
  EXPECT_EQ(arguments.overrides[0].value, "50.0");
  ASSERT_EQ(arguments.remappings.size(), 1U);
  EXPECT_EQ(arguments.remappings[0].rule.from, "__ns");
  EXPECT_EQ(arguments.remappings[0].rule.to, "/robot1");
  EXPECT_EQ(arguments.log_level, "debug");
}

TEST(RosArguments, MayNameTheNodeTheyMean)
{
  const auto arguments =
    parse({"robot", "--ros-args", "-p", "driver:a.b:=x:=y", "-r", "driver:__node:=d2"});
  EXPECT_EQ(arguments.overrides[0].node, "driver");
  EXPECT_EQ(arguments.overrides[0].name, "a.b");
  EXPECT_EQ(arguments.overrides[0].value, "x:=y");
  EXPECT_EQ(arguments.remappings[0].node, "driver");
}

TEST(RosArguments, AreRefusedAllAtOnce)
{
  EXPECT_EQ(faults_of({"d", "--ros-args", "-p", "a=b", "-q", "--log-level", "loud", "-r"}), 4U);
  EXPECT_EQ(faults_of({"d", "--ros-args", "-p", ":=1"}), 1U);
  EXPECT_EQ(faults_of({"d", "--ros-args", "-p", "node::=1"}), 1U);
  EXPECT_EQ(faults_of({"d", "-q", "--log-level"}), 0U) << "not ours to judge";
}

}  // namespace
}  // namespace stetro_dds
