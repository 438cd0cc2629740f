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
    "/stetro/driver: {ros__parameters: {x: 2}}\n"
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
