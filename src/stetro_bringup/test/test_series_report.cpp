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

#include <sstream>

#include "nlohmann/json.hpp"
#include "stetro_bringup/series_report.hpp"

namespace stetro_bringup
{
namespace
{

Kidnap kidnap(double noticed_s, std::optional<double> relocalised_s)
{
  Kidnap one;
  one.segment = "landing";
  one.noticed_after_s = noticed_s;
  one.relocalised_after_s = relocalised_s;
  return one;
}

ClimbOutcome run(std::uint64_t seed)
{
  ClimbOutcome outcome;
  outcome.seed = seed;
  outcome.hand_overs = {{"lower", "landing", 400.0, 0.001 * static_cast<double>(seed), 0.0}};
  return outcome;
}

}  // namespace

TEST(SeriesReport, SumsUpRuns)
{
  SeriesReport series;
  EXPECT_FALSE(series.succeeded()) << "nothing was run";
  ClimbOutcome first = run(3);
  first.kidnaps = {kidnap(0.5, 4.0), kidnap(2.5, 9.0)};
  series.add(first);
  series.add(run(4));
  EXPECT_TRUE(series.succeeded());
  ClimbOutcome third = run(5);
  third.kidnaps = {kidnap(1.5, std::nullopt)};
  third.shortfalls = {"the robot is not found after the kidnap on landing"};
  series.add(third);
  EXPECT_FALSE(series.succeeded());
  const auto json = nlohmann::json::parse(series.json());
  EXPECT_EQ(json["runs"], 3);
  EXPECT_EQ(json["succeeded"], 2);
  EXPECT_EQ(json["hand_overs"], 3);
  EXPECT_NEAR(json["jump_max_m"].get<double>(), 0.005, 1e-12);
  EXPECT_EQ(json["kidnaps"], 3);
  EXPECT_EQ(json["noticed"], 3);
  EXPECT_EQ(json["noticed_after_median_s"], 1.5);
  EXPECT_EQ(json["noticed_after_max_s"], 2.5);
  EXPECT_EQ(json["relocalised"], 2);
  EXPECT_EQ(json["relocalised_after_max_s"], 9.0);
  EXPECT_EQ(json["each"][2]["seed"], 5);
  EXPECT_EQ(json["each"][2]["succeeded"], false);
  std::ostringstream text;
  series.print(text);
  EXPECT_NE(text.str().find("2 of 3 runs succeeded; 3 hand-overs, 0.50 cm"), std::string::npos)
    << text.str();
  EXPECT_NE(text.str().find("seed 5: the robot is not found"), std::string::npos) << text.str();
}

TEST(SeriesReport, ClaimsNothingOfWhatDidNotHappen)
{
  SeriesReport series;
  series.add(ClimbOutcome{});
  const auto json = nlohmann::json::parse(series.json());
  EXPECT_TRUE(json["jump_max_m"].is_null());
  EXPECT_TRUE(json["noticed_after_max_s"].is_null());
}

}  // namespace stetro_bringup
