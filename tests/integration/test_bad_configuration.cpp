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

// Whatever a person wrote wrong: nothing starts, exit code 2, every fault with its file and line.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "stetro_tests/deadline.hpp"
#include "stetro_tests/stack.hpp"

namespace stetro_tests
{

constexpr const char * kFaults = STETRO_TESTS_DATA "/params/five_faults.yaml";
constexpr const char * kMalformed = STETRO_TESTS_DATA "/params/malformed.yaml";
constexpr const char * kContradicting = STETRO_TESTS_DATA "/site/contradicting_height.yaml";

class BadConfiguration : public testing::TestWithParam<const char *>
{
protected:
  /// Starts the executable with the parameters and a file of more; it must refuse. \return why
  std::string refusal(const Parameters & parameters, const std::string & file = "")
  {
    auto command = command_of(GetParam(), parameters);
    if (!file.empty()) {
      command.insert(command.end(), {"--params-file", file});
    }
    Process process(command, domain_.environment());
    const auto ending = process.wait(10s);
    EXPECT_TRUE(ending) << "it runs\n" << process.tail();
    if (ending) {
      EXPECT_EQ(ending->exit_code, 2) << "signal " << ending->signal << "\n" << process.tail();
    }
    return process.output();
  }

  static void expect_named(const std::string & said, const std::vector<std::string> & words)
  {
    for (const std::string & word : words) {
      EXPECT_NE(said.find(word), std::string::npos) << word << " is not in:\n" << said;
    }
  }

  LoopbackDomain domain_;
};

TEST_P(BadConfiguration, ListsEveryFaultWithFileAndLine)
{
  const std::string said = refusal(building_parameters(short_flight()), kFaults);
  const std::string place = std::string(kFaults) + ":";
  expect_named(
    said, {place + "17:", "use_sim_time", "maybe", place + "18:", "dds.network", "moon",
           place + "19:", "dds.ros_distro", place + "20:", "site_fiel", "site_file",
           place + "21:", "dds.intra_proces"});
}

TEST_P(BadConfiguration, NamesThePlaceOfASyntaxError)
{
  const std::string said = refusal(building_parameters(short_flight()), kMalformed);
  expect_named(said, {std::string(kMalformed) + ":"});
}

TEST_P(BadConfiguration, RefusesASiteThatContradictsItself)
{
  const std::string said = refusal(building_parameters(kContradicting));
  expect_named(said, {std::string(kContradicting) + ":", "1.65", "2.24"});
}

TEST_P(BadConfiguration, RefusesValuesOfTheCommandLine)
{
  Parameters parameters = building_parameters(short_flight());
  parameters["use_sim_time"] = "7";
  parameters["no_such_parameter"] = "1";
  const std::string said = refusal(parameters);
  expect_named(said, {"command line", "use_sim_time", "no_such_parameter"});
}

TEST_P(BadConfiguration, RefusesFilesThatAreNotThere)
{
  expect_named(refusal(building_parameters("/no/such/site.yaml")), {"/no/such/site.yaml"});
  expect_named(
    refusal(building_parameters(short_flight()), "/no/such/params.yaml"), {"/no/such/params.yaml"});
}

TEST_P(BadConfiguration, RefusesAVariableOfTheEnvironment)
{
  Process process(
    command_of(GetParam(), building_parameters(short_flight())), {{"ROS_DOMAIN_ID", "many"}});
  const auto ending = process.wait(10s);
  ASSERT_TRUE(ending) << process.tail();
  EXPECT_EQ(ending->exit_code, 2) << process.tail();
  expect_named(process.output(), {"ROS_DOMAIN_ID", "many"});
}

INSTANTIATE_TEST_SUITE_P(
  Executables, BadConfiguration,
  testing::Values("stetro_driver", "stetro_localizer", "stetro_supervisor"),
  [](const auto & test) { return std::string(test.param); });

}  // namespace stetro_tests
