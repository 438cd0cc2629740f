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

#include "./sample_params.hpp"
#include "stetro_config/loader.hpp"
#include "stetro_config/yaml_file.hpp"

namespace stetro_config
{
namespace
{

sample::Params load(const std::string & text)
{
  Faults faults;
  const auto root = read_yaml_text(text, "p.yaml", faults);
  faults.throw_if_any();
  Loader<sample::Params> loader;
  loader.read_map(*root, "p.yaml");
  return loader.finish();
}

/// Every fault of a text, one to a line, as a person sees them.
std::vector<std::string> faults_of(const std::string & text)
{
  std::vector<std::string> lines;
  try {
    static_cast<void>(load(text));
  } catch (const ConfigError & error) {
    for (const Fault & fault : error.faults()) {
      lines.push_back(to_string(fault));
    }
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST(Loader, TakesNestedMapsAndDottedNamesOverDefaults)
{
  const auto params = load("estimator: paper\ntof:\n  near_m: 0.04\ntof.far_m: 1\ngate: {}\n");
  EXPECT_EQ(params.estimator, "paper");
  EXPECT_EQ(params.near_m, 0.04);
  EXPECT_EQ(params.far_m, 1.0);
  EXPECT_EQ(params.gate.sigma, 3.0);
}

TEST(Loader, SuggestsTheNearestNameForAMisspeltOne)
{
  EXPECT_EQ(
    faults_of("tof:\n  neer_m: 0.04\n"),
    (Lines{"p.yaml:2: tof.neer_m: value '0.04' refused, accepted: a known key; did you mean "
           "tof.near_m?"}));
}

TEST(Loader, ReportsEveryFaultAtOnceWithItsLine)
{
  EXPECT_EQ(
    faults_of("estimator: best\n\ntof:\n  near_m: 3.0\ngate:\n  rejects: 2.0\n"),
    (Lines{
      "p.yaml:1: estimator: value 'best' refused, accepted: text (quoted if it looks like a "
      "number), one of paper, fused",
      "p.yaml:4: tof.near_m: value '3.0' refused, accepted: a finite number, 0 to 2",
      "p.yaml:6: gate.rejects: value '2.0' refused, accepted: a whole number, at least 1"}));
}

TEST(Loader, RefusesANameWrittenTwiceInOneFile)
{
  EXPECT_EQ(
    faults_of("debug: true\ndebug: true\n"),
    (Lines{"p.yaml:2: debug: value 'true' refused, accepted: once only; first on line 1"}));
  EXPECT_EQ(faults_of("tof: {near_m: 0.1}\ntof.near_m: 0.1\n").size(), 1U);
  EXPECT_EQ(faults_of("tof: {near_m: 0.1}\ntof: {far_m: 1.1}\n").size(), 1U);
}

TEST(Loader, RefusesMergeKeysComplexKeysAndGroupsThatAreNoMaps)
{
  EXPECT_EQ(faults_of("<<: {debug: true}\n").size(), 1U);
  EXPECT_EQ(faults_of("? [a]\n: 1\n").size(), 1U);
  EXPECT_EQ(
    faults_of("tof: 5\n"),
    (Lines{"p.yaml:1: tof: value '5' refused, accepted: a map: tof.near_m, tof.far_m"}));
  EXPECT_EQ(faults_of("tof:\n").size(), 1U);
}

TEST(Loader, ReportsAliasesWhereTheyAreUsed)
{
  EXPECT_EQ(load("tof:\n  near_m: &n 0.05\ngate: {sigma: 2}\n").near_m, 0.05);
  EXPECT_EQ(
    faults_of("tof:\n  near_m: &n 0.05\ngate:\n  sigma: *n\n"),
    (Lines{"p.yaml:4: gate.sigma: value '0.05' refused, accepted: a finite number, 1 to 10"}));
  EXPECT_EQ(faults_of("tof: &t\n  near_m: *t\n").size(), 1U) << "a map inside itself";
}

TEST(Loader, PlacesCrossedLimitsWhereTheyWereWritten)
{
  EXPECT_EQ(
    faults_of("tof:\n  near_m: 1.5\n"),
    (Lines{"p.yaml:2: tof.near_m: value '1.5' refused, accepted: less than tof.far_m, 1.2"}));
  EXPECT_EQ(
    faults_of("tof.far_m: 0.01\n"),
    (Lines{"default: tof.near_m: value '0.03' refused, accepted: less than tof.far_m, 0.01"}));
}

TEST(Loader, LetsTheCommandLineHaveTheLastWord)
{
  Loader<sample::Params> loader;
  loader.read_map(YAML::Load("tof: {near_m: 0.04}"), "p.yaml");
  loader.set("tof.near_m", "0.05", "command line");
  loader.set("estimator", "paper", "command line");
  loader.set("sensors", "[front_left]", "command line");
  const auto params = loader.finish();
  EXPECT_EQ(params.near_m, 0.05);
  EXPECT_EQ(params.estimator, "paper");
  EXPECT_EQ(params.sensors, std::vector<std::string>{"front_left"});
  EXPECT_EQ(loader.origin("tof.near_m").file, "command line");
  EXPECT_EQ(loader.origin("debug").file, "default");
}

TEST(Loader, RefusesTheCommandLineAsStrictlyAsAFile)
{
  Loader<sample::Params> loader;
  loader.set("tof.near_m", "", "command line");
  loader.set("gate.rejects", "2.5", "command line");
  loader.set("gate.sgima", "2.5", "command line");
  loader.set("sensors", "[a", "command line");
  Faults faults;
  static_cast<void>(loader.finish(faults));
  ASSERT_EQ(faults.size(), 4U);
  EXPECT_EQ(
    to_string(faults[1]),
    "command line: gate.rejects: value '2.5' refused, accepted: a whole number, at least 1");
}

TEST(Loader, CanDemandEveryName)
{
  Loader<sample::Params> loader;
  loader.read_map(YAML::Load("debug: true"), "p.yaml");
  loader.require_every_name("p.yaml");
  Faults faults;
  static_cast<void>(loader.finish(faults));
  EXPECT_EQ(faults.size(), 7U);
  EXPECT_EQ(faults[0].value, kMissing);
}

TEST(Loader, LeavesOutWhatAnotherReaderJudges)
{
  Loader<sample::Params> loader;
  loader.leave_out("devices");
  EXPECT_TRUE(loader.left_out("devices").IsNull());
  loader.read_map(YAML::Load("{debug: true, devices: {lidar: [1, x]}}"), "p.yaml");
  EXPECT_TRUE(loader.finish().debug);
  EXPECT_EQ(loader.left_out("devices")["lidar"].size(), 2U);
}

TEST(Loader, FindsADefaultThatItsOwnRuleRefuses)
{
  sample::Params params;
  params.gate.sigma = 0.5;
  EXPECT_THROW(static_cast<void>(Loader<sample::Params>{params}.finish()), ConfigError);
}

TEST(Loader, ReportsAFileThatIsNotThere)
{
  EXPECT_THROW(static_cast<void>(load_file<sample::Params>("no/such.yaml")), ConfigError);
}

// Property: however a file is cut off or damaged, the only exception is ConfigError.
TEST(Loader, ThrowsNothingElseWhateverTheFileHolds)
{
  const std::string good = "estimator: paper\ntof: &t {near_m: 0.04, far_m: 1}\nsensors: ['a']\n";
  for (std::size_t cut = 0; cut < good.size(); ++cut) {
    EXPECT_NO_THROW(faults_of(good.substr(0, cut))) << cut;
    for (const char c : {'\0', '\t', '{', ']', '*', '&', ':', '"', '?', '!', '%', '\xc3'}) {
      std::string damaged = good;
      damaged[cut] = c;
      EXPECT_NO_THROW(faults_of(damaged)) << damaged;
    }
  }
}

}  // namespace
}  // namespace stetro_config
