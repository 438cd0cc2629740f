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

#include <stdexcept>

#include "stetro_site/site.hpp"

namespace stetro_site
{
namespace
{

Floor floor_at(const std::string & id, double elevation_m)
{
  Floor floor;
  floor.id = id;
  floor.pose_in_map.z_m = elevation_m;
  return floor;
}

Flight flight_between(const std::string & id, const std::string & lower, const std::string & upper)
{
  FlightSpec spec;
  spec.id = id;
  spec.steps = equal_steps(10, 0.15, 0.32);  // 1.5 m up
  spec.width_foot_m = spec.width_top_m = 1.6;
  spec.lower_floor = lower;
  spec.upper_floor = upper;
  return Flight{spec};
}

SiteSpec two_floors()
{
  SiteSpec spec;
  spec.name = "house";
  spec.floors = {floor_at("ground", 0.0), floor_at("first", 1.5)};
  spec.flights = {flight_between("stairs", "ground", "first")};
  return spec;
}

std::string faults_of(const SiteSpec & spec)
{
  std::string text;
  for (const auto & fault : check_graph(spec)) {
    text += to_string(fault) + "\n";
  }
  return text;
}

TEST(Site, FindsItsSegmentsAndTheirNeighbours)
{
  SiteSpec spec = two_floors();
  spec.flights.push_back(flight_between("back_stairs", "ground", "first"));
  const Site site{spec};
  EXPECT_EQ(site.name(), "house");
  EXPECT_EQ(site.flight("stairs").steps(), 10);
  EXPECT_EQ(site.floor("first").elevation_m(), 1.5);
  EXPECT_EQ(site.find_flight("first"), nullptr);
  EXPECT_EQ(site.find_floor("stairs"), nullptr);
  using Ids = std::vector<std::string>;
  EXPECT_EQ(site.neighbours("stairs"), (Ids{"ground", "first"}));
  EXPECT_EQ(site.neighbours("first"), (Ids{"stairs", "back_stairs"}));
}

TEST(Site, NamesTheSegmentsThereAreWhenAskedForAnother)
{
  const Site site{two_floors()};
  EXPECT_THROW(static_cast<void>(site.flight("lift")), std::out_of_range);
  EXPECT_THROW(static_cast<void>(site.floor("attic")), std::out_of_range);
  try {
    static_cast<void>(site.neighbours("attic"));
    FAIL();
  } catch (const std::out_of_range & error) {
    EXPECT_STREQ(error.what(), "segment 'attic' refused, accepted: ground, first, stairs");
  }
}

TEST(Site, RefusesIdsThatAreTakenOrReserved)
{
  SiteSpec spec = two_floors();
  spec.floors.push_back(floor_at("stairs", 1.5));
  spec.floors[0].id = "map";
  EXPECT_EQ(
    faults_of(spec),
    "floors[0].id: value 'map' refused, accepted: an id that is not the name of a frame of REP "
    "105\n"
    "flights[0].id: value 'stairs' refused, accepted: an id of its own; floors[2].id has this "
    "one\n"
    "flights[0].joins: value 'ground' refused, accepted: the id of a floor: map, first, stairs\n");
}

TEST(Site, RefusesFlightsThatJoinNothingOrOneFloorTwice)
{
  SiteSpec spec = two_floors();
  spec.flights = {flight_between("a", "ground", "attic"), flight_between("b", "first", "first")};
  EXPECT_EQ(
    faults_of(spec),
    "flights[0].joins: value 'attic' refused, accepted: the id of a floor: ground, first\n"
    "flights[1].joins: value 'first' refused, accepted: two different floors, the lower one "
    "first\n");
}

TEST(Site, RefusesElevationsThatTheRisersDoNotReach)
{
  SiteSpec spec = two_floors();
  spec.floors[1] = floor_at("first", 1.51);
  EXPECT_EQ(faults_of(spec), "") << "within a centimetre";
  spec.floors[1] = floor_at("first", 1.52);
  EXPECT_EQ(
    faults_of(spec),
    "flights[0].joins: value 'first at 1.52' refused, accepted: a floor at 1.5 = 0 of ground + "
    "1.5 of 10 risers, within 0.01 (differs by 0.02)\n");
  spec.tolerance_m = 0.02;
  EXPECT_EQ(faults_of(spec), "");
}

TEST(Site, RefusesAFlightTurnedUpsideDown)
{
  SiteSpec spec = two_floors();
  spec.flights = {flight_between("stairs", "first", "ground")};
  EXPECT_EQ(check_graph(spec).size(), 2U) << "stands on the wrong floor, and misses the other";
}

TEST(Site, RefusesSegmentsThatDoNotHangTogether)
{
  SiteSpec spec = two_floors();
  spec.floors.push_back(floor_at("island", 9.0));
  EXPECT_EQ(
    faults_of(spec),
    "floors[2].id: value 'island' refused, accepted: a floor that flights join to ground\n");
  EXPECT_THROW(Site{spec}, stetro_config::ConfigError);
}

TEST(Site, ReachesEveryFloorOfAChainInWhateverOrder)
{
  SiteSpec spec;
  spec.floors = {floor_at("c", 0.0), floor_at("a", 0.0), floor_at("b", 1.5)};
  spec.flights = {flight_between("two", "a", "b"), flight_between("one", "c", "b")};
  EXPECT_EQ(faults_of(spec), "");
}

TEST(Site, HasAFloor)
{
  EXPECT_EQ(faults_of(SiteSpec{}), "floors: value '[]' refused, accepted: at least one floor\n");
}

}  // namespace
}  // namespace stetro_site
