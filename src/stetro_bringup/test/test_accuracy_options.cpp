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

#include "accuracy/options.hpp"

namespace stetro_bringup
{
namespace
{

TEST(AccuracyOptions, TheCommandHoldsWhatChangesTheFigures)
{
  AccuracyOptions options;
  options.runs = 20;
  options.estimator = "both";
  options.calibration = "none";
  options.jobs = 3;
  options.out = "/somewhere";
  options.markdown = "/somewhere/report.md";
  EXPECT_EQ(
    command_of(options),
    "scripts/accuracy --runs 20 --first-seed 1 --estimator both --world as-built "
    "--calibration none");
  options.faults = {"dead", "stuck"};
  options.flight = "stairs";
  EXPECT_EQ(
    command_of(options),
    "scripts/accuracy --runs 20 --first-seed 1 --estimator both --world as-built "
    "--calibration none --faults dead,stuck --flight stairs");
  options.faults.clear();
  options.localizer = "risk.yaml";
  options.errors = "grey_walls.yaml";
  EXPECT_EQ(
    command_of(options),
    "scripts/accuracy --runs 20 --first-seed 1 --estimator both --world as-built "
    "--calibration none --flight stairs --localizer risk.yaml --errors grey_walls.yaml");
}

// -3 would wrap around to 18446744073709551613, and the seeds after it to 0.
TEST(AccuracyOptions, ASeedIsNotNegativeAndLeavesRoomForTheRuns)
{
  const auto first_seed = [](const std::string & text) {
    CLI::App app;
    AccuracyOptions options;
    add_options(app, options);
    app.parse("--first-seed " + text);
    return options.first_seed;
  };
  EXPECT_EQ(first_seed("0"), 0u);
  EXPECT_EQ(first_seed("1000000000000000000"), 1'000'000'000'000'000'000u);
  EXPECT_THROW(first_seed("-3"), CLI::ValidationError);
  EXPECT_THROW(first_seed("1000000000000000001"), CLI::ValidationError);
}

TEST(AccuracyOptions, OfBothTheFusedOneDrives)
{
  AccuracyOptions options;
  options.estimator = "both";
  EXPECT_EQ(estimators_of(options), (std::vector<std::string>{"fused", "paper"}));
  options.estimator = "paper";
  EXPECT_EQ(estimators_of(options), std::vector<std::string>{"paper"});
}

}  // namespace
}  // namespace stetro_bringup
