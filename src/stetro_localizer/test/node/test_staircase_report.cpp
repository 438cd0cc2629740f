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

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "node/staircase_report.hpp"
#include "support/stair_robot.hpp"

namespace stetro_localizer
{
namespace
{

using stetro_dds::DiagnosticReport;
using stetro_dds::Health;

constexpr double kBound = 0.02;

ScalarEstimate known(double value, double sigma) { return {value, sigma * sigma}; }

std::string value_of(const DiagnosticReport & report, const std::string & key)
{
  const auto & values = report.values();
  const auto found = std::find_if(
    values.begin(), values.end(), [&](const auto & value) { return value.first == key; });
  return found == values.end() ? "" : found->second;
}

TEST(StaircaseReport, HasARowAStep)
{
  DiagnosticReport report;
  tell(
    report,
    {{1, known(0.3216, 0.001), known(2.0513, 0.0018)}, {2, known(0.3178, 0.001), std::nullopt}},
    papers_flight(), kBound);
  EXPECT_EQ(report.health(), Health::kOk);
  EXPECT_EQ(value_of(report, "steps measured"), "2");
  EXPECT_EQ(value_of(report, "largest deviation [m]"), "-0.002200");
  EXPECT_EQ(value_of(report, "largest deviation of"), "tread of step 2");
  EXPECT_EQ(
    value_of(report, "step 1: tread, sigma, width, sigma [m]"),
    "0.321600 0.001000 2.051300 0.001800");
  EXPECT_EQ(
    value_of(report, "step 2: tread, sigma, width, sigma [m]"), "0.317800 0.001000 nan nan");
}

TEST(StaircaseReport, WarnsOfATreadFourCentimetresTooDeep)
{
  DiagnosticReport report;
  tell(
    report, {{1, known(0.321, 0.001), std::nullopt}, {2, known(0.36, 0.0011), std::nullopt}},
    papers_flight(), kBound);
  EXPECT_EQ(report.health(), Health::kWarn);
  EXPECT_EQ(
    report.message(), "tread of step 2 is 0.3600 m (sigma 0.0011 m), the site file says 0.3200 m");
  EXPECT_EQ(value_of(report, "step 2: tread, sigma, site file [m]"), "0.360000 0.001100 0.320000");
  EXPECT_EQ(value_of(report, "step 1: tread, sigma, site file [m]"), "");
}

TEST(StaircaseReport, HasNothingToSayBeforeTheFirstStep)
{
  DiagnosticReport report;
  tell(report, {}, papers_flight(), kBound);
  EXPECT_EQ(report.health(), Health::kOk);
  EXPECT_EQ(value_of(report, "steps measured"), "0");
  EXPECT_EQ(report.values().size(), 1u);
}

}  // namespace
}  // namespace stetro_localizer
