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
#include <utility>
#include <vector>

#include "stetro_dds/parameter_files.hpp"
#include "support/parameter_file.hpp"

namespace stetro_dds
{
namespace
{

/// The values of `x` that reach the node, in order.
std::vector<int> reaching(
  const std::string & node, const std::string & text, stetro_config::Faults & faults)
{
  const ParameterFile file(text);
  const ParameterFiles files({file.path()}, faults);
  std::vector<int> values;
  files.each_section(node, faults, [&](const YAML::Node & map, const std::string & name) {
    EXPECT_EQ(name, file.path());
    values.push_back(map["x"].as<int>());
  });
  return values;
}

TEST(NodePattern, AddressesAsInRos)
{
  EXPECT_TRUE(addresses("/driver", "/driver"));
  EXPECT_FALSE(addresses("/driver", "/stetro/driver"));
  EXPECT_TRUE(addresses("/**", "/driver"));
  EXPECT_TRUE(addresses("/**", "/a/b/driver"));
  EXPECT_TRUE(addresses("/*", "/driver"));
  EXPECT_FALSE(addresses("/*", "/stetro/driver"));
  EXPECT_TRUE(addresses("/*/driver", "/stetro/driver"));
  EXPECT_TRUE(addresses("/**/driver", "/driver"));
  EXPECT_TRUE(addresses("/a/**/driver", "/a/b/c/driver"));
  EXPECT_FALSE(addresses("/a/**/driver", "/b/driver"));
}

TEST(ParameterFiles, ReachTheNodesTheyName)
{
  stetro_config::Faults faults;
  const auto values = reaching(
    "/stetro/driver",
    "/**: {ros__parameters: {x: 1}}\n"
    "/*/driver: {ros__parameters: {x: 2}}\n"
    "stetro: {driver: {ros__parameters: {x: 3}}, localizer: {ros__parameters: {x: 4}}}\n"
    "/stetro: {'*': {ros__parameters: {x: 5}}}\n"
    "/other/driver: {ros__parameters: {x: 6}}\n",
    faults);
  EXPECT_EQ(values, (std::vector<int>{1, 2, 3, 5}));
  EXPECT_TRUE(faults.empty());
}

TEST(ParameterFiles, RefuseASectionThatForgetsTheNamespace)
{
  stetro_config::Faults faults;
  EXPECT_TRUE(reaching("/stetro/driver", "driver: {ros__parameters: {x: 1}}\n", faults).empty());
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].accepted.find("/stetro/driver"), std::string::npos);
}

/// The patterns of the sections that mean none of the nodes, with their lines.
std::vector<std::pair<std::string, int>> strays(
  const std::vector<std::string> & nodes, const std::string & text)
{
  stetro_config::Faults faults;
  const ParameterFile file(text);
  const ParameterFiles files({file.path()}, faults);
  EXPECT_TRUE(faults.empty());
  std::vector<std::pair<std::string, int>> found;
  for (const ParameterSection & section : files.sections_for_none_of(nodes)) {
    EXPECT_EQ(section.origin.file, file.path());
    found.emplace_back(section.pattern, section.origin.line);
  }
  return found;
}

TEST(ParameterFiles, TellWhichSectionsMeanNoneOfTheNodes)
{
  const std::string text =
    "/**: {ros__parameters: {x: 1}}\n"
    "/stetro/drivr:\n"
    "  ros__parameters: {x: 2}\n"
    "stetro:\n"
    "  localizer: {ros__parameters: {x: 3}}\n"
    "  '*': {ros__parameters: {x: 4}}\n"
    "/other/**: {ros__parameters: {x: 5}}\n";
  using Strays = std::vector<std::pair<std::string, int>>;
  EXPECT_EQ(
    strays({"/stetro/driver"}, text),
    (Strays{{"/stetro/drivr", 2}, {"/stetro/localizer", 5}, {"/other/**", 7}}));
  EXPECT_EQ(
    strays({"/stetro/driver", "/stetro/localizer"}, text),
    (Strays{{"/stetro/drivr", 2}, {"/other/**", 7}}));
}

TEST(ParameterFiles, DoNotCallStrayWhatIsRefusedAlready)
{
  const std::string text = "driver: {ros__parameters: {x: 1}}\n";
  EXPECT_TRUE(strays({"/stetro/driver"}, text).empty()) << "it forgets the namespace";
  EXPECT_EQ(strays({"/stetro/localizer"}, text).size(), 1U);
}

TEST(ParameterFiles, RefuseASectionGivenTwiceInOneFile)
{
  stetro_config::Faults faults;
  reaching(
    "/stetro/driver",
    "/stetro/driver: {ros__parameters: {x: 1}}\n"
    "/stetro/localizer: {ros__parameters: {x: 2}}\n"
    "stetro:\n"
    "  driver: {ros__parameters: {x: 3}}\n"
    "/stetro/localizer: {ros__parameters: {x: 4}}\n",
    faults);
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0].name, "/stetro/driver");
  EXPECT_EQ(faults[0].line, 4) << "nested or in one key, it is the same name";
  EXPECT_NE(faults[0].accepted.find("line 1"), std::string::npos) << faults[0];
  EXPECT_EQ(faults[1].name, "/stetro/localizer");
  EXPECT_EQ(faults[1].line, 5);
  EXPECT_NE(faults[1].accepted.find("line 2"), std::string::npos) << faults[1];
}

TEST(ParameterFiles, RefuseParametersGivenTwiceBelowOneName)
{
  stetro_config::Faults faults;
  reaching("/driver", "/driver:\n  ros__parameters: {x: 1}\n  ros__parameters: {x: 2}\n", faults);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].name, "/driver");
}

TEST(ParameterFiles, TakeASectionOfEachFile)
{
  stetro_config::Faults faults;
  const ParameterFile file("/driver: {ros__parameters: {x: 1}}\n");
  const ParameterFiles files({file.path(), file.path()}, faults);
  int sections = 0;
  files.each_section(
    "/driver", faults, [&](const YAML::Node &, const std::string &) { ++sections; });
  EXPECT_EQ(sections, 2) << "the last wins";
  EXPECT_TRUE(faults.empty());
}

TEST(ParameterFiles, RefuseAnotherLayout)
{
  stetro_config::Faults faults;
  reaching("/driver", "ros__parameters: {x: 1}\ndriver:\n  x: 2\n", faults);
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0].line, 1);
  EXPECT_EQ(faults[1].line, 3);
}

TEST(ParameterFiles, RefuseAMapThatContainsItself)
{
  stetro_config::Faults faults;
  const ParameterFile file("a: &a {b: *a}\n");
  const ParameterFiles files({file.path()}, faults);
  EXPECT_FALSE(faults.empty()) << "and the stack is still there";
}

TEST(ParameterFiles, RefuseAFileThatIsNotThere)
{
  stetro_config::Faults faults;
  const ParameterFiles files({"/no/such/file.yaml"}, faults);
  EXPECT_EQ(faults.size(), 1U);
}

}  // namespace
}  // namespace stetro_dds
