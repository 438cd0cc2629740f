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
  const auto json = nlohmann::json::parse(profiles_json({table}, 7));
  const auto & trusted = json.at("rooms").at("trusted");
  EXPECT_DOUBLE_EQ(trusted.at("solved").get<double>(), 0.5) << "to 0.1 unit";
  EXPECT_EQ(trusted.at("no_verdict").get<int>(), 1);
  EXPECT_EQ(trusted.at("false_accepts").get<int>(), 0);
  EXPECT_DOUBLE_EQ(trusted.at("median_us").get<double>(), 20.0);
  EXPECT_DOUBLE_EQ(json.at("rooms").at("published").at("solved").get<double>(), 0.75);
  EXPECT_DOUBLE_EQ(json.at("rooms").at("published").at("solved_fine").get<double>(), 0.25);
}

}  // namespace
}  // namespace stetro_bringup
