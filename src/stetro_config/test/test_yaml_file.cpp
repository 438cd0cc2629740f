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

#include <cstdio>
#include <fstream>

#include "stetro_config/yaml_file.hpp"

namespace stetro_config
{
namespace
{

/// The only fault of a text that must not be read.
Fault fault_of(const std::string & text)
{
  Faults faults;
  EXPECT_FALSE(read_yaml_text(text, "site.yaml", faults)) << text;
  EXPECT_EQ(faults.size(), 1U) << text;
  return faults.empty() ? Fault{} : faults[0];
}

TEST(YamlFile, ReportsMalformedTextWithItsLine)
{
  const Fault fault = fault_of("a: 1\nb: [1, 2\nc: }\n");
  EXPECT_EQ(fault.file, "site.yaml");
  EXPECT_EQ(fault.line, 3);
  EXPECT_EQ(fault.accepted, "well-formed YAML");
  EXPECT_EQ(fault_of("a: *nobody\n").line, 1);
  EXPECT_EQ(fault_of("a:\n\t- 1\n").line, 2);
}

TEST(YamlFile, RefusesASecondDocumentAndAnotherRoot)
{
  EXPECT_EQ(fault_of("a: 1\n---\nb: 2\n").value, "a second document");
  EXPECT_EQ(fault_of("").value, "an empty file");
  EXPECT_EQ(fault_of("# nothing\n").value, "an empty file");
  EXPECT_EQ(fault_of("- 1\n- 2\n").value, "[1, 2]");
  EXPECT_EQ(fault_of("\nhello\n").line, 2);
}

TEST(YamlFile, SurvivesDepthAndNoise)
{
  for (const char c : {'[', '{', '-', '?', '&', '!', '\xff', '\0'}) {
    fault_of(std::string(50000, c));
  }
}

TEST(YamlFile, ReportsFilesThatCannotBeRead)
{
  Faults faults;
  EXPECT_FALSE(read_yaml_file("no/such.yaml", faults));
  EXPECT_FALSE(read_yaml_file(testing::TempDir(), faults));
  EXPECT_FALSE(read_yaml_file("/dev/zero", faults));
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(
    to_string(faults[0]),
    "no/such.yaml: value 'No such file or directory' refused, accepted: a file that can be read");
  EXPECT_EQ(faults[1].value, "a directory");
  EXPECT_EQ(faults[2].value, "more than 16 MiB");
}

TEST(YamlFile, ReadsAMapAndCountsLinesFromOne)
{
  const std::string path = testing::TempDir() + "yaml_file_test.yaml";
  std::ofstream{path} << "a: 1\nb:\n  c: 2\n";
  Faults faults;
  const auto root = read_yaml_file(path, faults);
  ASSERT_TRUE(root);
  EXPECT_EQ(line_of(*root), 1);
  EXPECT_EQ(line_of((*root)["b"]["c"]), 3);
  EXPECT_EQ(line_of(YAML::Node{"made here"}), 0);
  std::remove(path.c_str());
}

}  // namespace
}  // namespace stetro_config
