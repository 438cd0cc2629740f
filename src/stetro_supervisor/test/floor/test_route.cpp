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

#include "stetro_supervisor/floor/route.hpp"
#include "support/two_floors.hpp"

namespace stetro_supervisor
{

using Segments = std::vector<std::string>;

class RouteTest : public testing::Test
{
protected:
  const stetro_site::Site site = two_floors(3, 2);
};

TEST_F(RouteTest, GoesFromFloorToFloorOverTheFlights)
{
  EXPECT_EQ(
    find_route(site, "ground", "first").segments,
    (Segments{"ground", "lower", "landing", "upper", "first"}));
  EXPECT_EQ(find_route(site, "lower", "upper").segments, (Segments{"lower", "landing", "upper"}));
}

TEST_F(RouteTest, IsOneSegmentWhereTheRobotIs)
{
  EXPECT_EQ(find_route(site, "landing", "landing").segments, (Segments{"landing"}));
}

TEST_F(RouteTest, RefusesToGoDown)
{
  const Route route = find_route(site, "first", "ground");
  EXPECT_TRUE(route.segments.empty());
  EXPECT_NE(route.refusal.find("gone down, which is not supported"), std::string::npos)
    << route.refusal;
  EXPECT_FALSE(find_route(site, "upper", "landing").refusal.empty()) << "back down a flight";
}

TEST_F(RouteTest, NamesTheSegmentsWhenThereIsNoSuchOne)
{
  EXPECT_EQ(
    find_route(site, "ground", "attic").refusal,
    "segment 'attic' is not in the site, accepted: 'ground', 'landing', 'first', 'lower', 'upper'");
  EXPECT_NE(find_route(site, "", "ground").refusal.find("segment ''"), std::string::npos);
}

}  // namespace stetro_supervisor
