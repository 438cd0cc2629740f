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

#include <vector>

#include "nlohmann/json.hpp"
#include "profiles/profiles_json.hpp"

namespace stetro_bringup
{
namespace
{

TEST(ProfilesJson, TellsSharesAndCountsUnderTheTablesName)
{
  RoomsTable table;
  table.kind.name = "rooms";
  table.trusted.cases = 4;
  table.trusted.within_1 = 3;
  table.trusted.within_01 = 2;
  table.trusted.no_verdict = 1;
  table.trusted.us = {30.0, 10.0, 20.0};
  table.published.cases = 4;
  table.published.within_1 = 3;
  table.published.within_01 = 1;
  const auto json = nlohmann::json::parse(profiles_json({7, {table}, {}, {}}));
  const auto & trusted = json.at("rooms").at("trusted");
  EXPECT_DOUBLE_EQ(trusted.at("solved").get<double>(), 0.5) << "to 0.1 unit";
  EXPECT_EQ(trusted.at("no_verdict").get<int>(), 1);
  EXPECT_EQ(trusted.at("false_accepts").get<int>(), 0);
  EXPECT_DOUBLE_EQ(trusted.at("median_us").get<double>(), 20.0);
  EXPECT_DOUBLE_EQ(json.at("rooms").at("published").at("solved").get<double>(), 0.75);
  EXPECT_DOUBLE_EQ(json.at("rooms").at("published").at("solved_fine").get<double>(), 0.25);
}

TEST(ProfilesJson, TellsMapsAndLogsByTheirNames)
{
  MapsTable map;
  map.name = "hall";
  map.guarded_radius = {0.8, 0.7};
  map.published_radius = {0.9, 0.6};
  map.determined.cases = 4;
  map.determined.solved = 3;
  map.elsewhere.reasons["one direction"] = 2;
  LogTable log;
  log.name = "walk";
  log.right_m = 0.1;
  log.right_rad = 0.05;
  LogCase right;
  right.verdict = stetro_supervisor::Verdict::kCorrected;
  right.error_m = 0.02;
  LogCase far = right;
  far.number = 9;
  far.error_m = 0.4;
  log.cases = {right, far, LogCase{}};
  const auto json = nlohmann::json::parse(profiles_json({7, {}, {map}, {log}}));
  const auto & hall = json.at("real_maps").at("hall");
  EXPECT_DOUBLE_EQ(hall.at("trusted").at("solved").get<double>(), 0.75);
  EXPECT_EQ(hall.at("trusted").at("elsewhere").at("reasons").at("one direction").get<int>(), 2);
  const auto & radius = hall.at("spectral_radius");
  EXPECT_DOUBLE_EQ(radius.at("guarded").at("median").get<double>(), 0.8);
  EXPECT_DOUBLE_EQ(radius.at("guarded").at("share_below_1").get<double>(), 0.7);
  EXPECT_DOUBLE_EQ(radius.at("published").at("median").get<double>(), 0.9);
  EXPECT_DOUBLE_EQ(radius.at("published").at("share_below_1").get<double>(), 0.6);
  const auto & walk = json.at("real_logs").at("walk").at("trusted");
  EXPECT_EQ(walk.at("false_accepts").get<int>(), 1);
  EXPECT_EQ(walk.at("accepted_beyond_25_cm").at(0).at("scan").get<int>(), 9);
  EXPECT_NEAR(walk.at("right_or_no_verdict").get<double>(), 2.0 / 3.0, 1e-12);
}

}  // namespace
}  // namespace stetro_bringup
