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
#include <sstream>
#include <string>

#include "accuracy/accuracy_markdown.hpp"

namespace stetro_bringup
{
namespace
{

constexpr int kSteps = 4;

ClimbRecord climb_with(double y_error_m)
{
  ClimbScore score;
  ScoredEstimate sample;
  sample.step = 2;
  sample.errors.y_m = y_error_m;
  sample.nees = 3.0;
  sample.sigma_y_m = 0.005;
  score.samples = {sample};
  score.ticks_ok = 300;
  score.ticks_degraded = 100;
  score.alarms = 1;
  score.steps.checks = 10;
  score.steps.on_stairs = 9;
  score.treads = 10;
  score.treads_exceeded = 1;
  score.stated_risk = 1e-4;
  score.detection = Detection{true, false, true, 12.0, 3.0, 0.8};
  ClimbRecord record;
  record.end = ClimbEnd::kFinished;
  record.last_step = kSteps;
  record.simulated_s = 360.0;
  record.scores = {score};
  return record;
}

AccuracyReport report_of(bool faults)
{
  AccuracyReport report{1, 7, "site", "none", "stairs", kSteps, {"fused"}, {"", kSteps, 1}, {}};
  report.overall.add(climb_with(0.003));
  if (faults) {
    report.scenarios.emplace_back("dead", kSteps, 1);
    report.scenarios.back().add(climb_with(0.003));
  }
  return report;
}

bool has_line(const std::string & text, const std::string & line)
{
  return ('\n' + text).find('\n' + line + '\n') != std::string::npos;
}

const Provenance kHere{"scripts/accuracy --runs 1", "abc123", {2, "a processor"}};

TEST(AccuracyMarkdown, SaysWhereItsFiguresComeFrom)
{
  const std::string text = summary_markdown(report_of(false), kHere);
  EXPECT_TRUE(has_line(text, "| command | `scripts/accuracy --runs 1` |")) << text;
  EXPECT_TRUE(has_line(text, "| commit | `abc123` |"));
  EXPECT_TRUE(has_line(text, "| machine | 2 cores, a processor |"));
  EXPECT_TRUE(has_line(text, "| seeds | 7 to 7 |"));
  EXPECT_TRUE(has_line(text, "| climbs | 1 of 1 finished, 4 steps, 0.1 h simulated |"));
  const std::string nameless = summary_markdown(report_of(false), {});
  EXPECT_TRUE(has_line(nameless, "| commit | – |"));
  EXPECT_TRUE(has_line(nameless, "| machine | – cores, – |"));
}

TEST(AccuracyMarkdown, GivesErrorsInMillimetresAndWhatIsNotKnownAsADash)
{
  const std::string text = summary_markdown(report_of(false), kHere);
  EXPECT_TRUE(has_line(text, "## `fused`, driving"));
  EXPECT_TRUE(has_line(text, "| y, right wall | mm | 3.00 | 3.00 | 0.00 | 3.00 | 3.00 | 3.00 |"))
    << text;
  EXPECT_TRUE(has_line(text, "| hand-over jump | mm | – | – | – | – | – | – |"));
  EXPECT_TRUE(has_line(text, "| 2 | 0.00 | 0.00 | 3.00 | 5.00 | 0.00 | 0.00 | 100.00 % |"));
  EXPECT_TRUE(has_line(text, "| 3 | – | – | – | – | – | – | – |"));
}

// None of ten: up to 0.31. One in nine steps: 0.0253 and 5.5716 expected, over nine.
TEST(AccuracyMarkdown, BoundsItsRates)
{
  const std::string text = summary_markdown(report_of(false), kHere);
  EXPECT_TRUE(has_line(text, "| time DEGRADED | 25.00 % |  |")) << text;
  EXPECT_TRUE(has_line(text, "| of these, with integrity OK | 0 of 10 | 0 to 3.1e-01 |"));
  EXPECT_TRUE(
    has_line(text, "| false alarms after the first tread | 1 in 9 steps | 2.8e-03 to 6.2e-01 |"));
  EXPECT_TRUE(has_line(
    text,
    "| treads with an error beyond its protection while OK | 1 in 10 steps | 2.5e-03 to "
    "5.6e-01 |"));
  EXPECT_TRUE(has_line(text, "| of these, for longer than 1 s | 0 in 10 steps | 0 to 3.7e-01 |"));
  EXPECT_TRUE(has_line(
    text,
    "| integrity risk stated, per step | 1.0e-04 | below 3.0e-01 with 95 % confidence; not "
    "carried: needs 29958 clean steps |"));
  EXPECT_EQ(text.find("| fault |"), std::string::npos);
}

// One of two missed: 1.3 % to 98.7 %; one of one: 2.5 % and more.
TEST(AccuracyMarkdown, GivesARowAFault)
{
  AccuracyReport report = report_of(true);
  ClimbRecord missed = climb_with(0.003);
  missed.scores[0].detection->detected = false;
  report.scenarios[0].add(missed);
  report.scenarios.emplace_back("stuck", kSteps, 1);
  report.scenarios[1].add(missed);
  const std::string text = summary_markdown(report, kHere);
  EXPECT_EQ(text.find("false alarms"), std::string::npos) << "there were faults";
  EXPECT_TRUE(has_line(
    text,
    "| dead | 2 | 1 | 1.3e-02 to 9.9e-01 | 1 of 2 | 12.0 | 0.8 | – | – | – | 0.00 | 0 of 20 |"))
    << text;
  EXPECT_TRUE(has_line(
    text, "| stuck | 1 | 1 | 2.5e-02 to 1.0e+00 | 0 of 1 | – | – | – | – | – | 0.00 | 0 of 10 |"));
}

TEST(AccuracyMarkdown, EveryTableIsAsWideAsItsHead)
{
  std::istringstream lines(summary_markdown(report_of(true), kHere));
  std::ptrdiff_t width = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::ptrdiff_t cells = std::count(line.begin(), line.end(), '|');
    EXPECT_TRUE(width == 0 || cells == 0 || cells == width) << line;
    width = cells;
  }
}

}  // namespace
}  // namespace stetro_bringup
