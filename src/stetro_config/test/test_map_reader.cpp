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

#include "stetro_config/map_reader.hpp"

namespace stetro_config
{
namespace
{

constexpr char kSite[] = R"(name: tower
flights:
  - id: lower
    riser_m: 0.14
  - id: upper
    raiser_m: 0.15
    open: true
pose: {x_m: 1.0}
devices:
  lidar: {port: 0x1}
)";

TEST(MapReader, ReadsKeysMapsAndListsOfMaps)
{
  Faults faults;
  auto site = MapReader::from_text(kSite, "site.yaml", faults);
  EXPECT_EQ(site.require<std::string>("name", Identifier{}), "tower");
  EXPECT_EQ(site.require_map("pose").require<double>("x_m", Any{}), 1.0);
  auto flights = site.require_maps("flights");
  ASSERT_EQ(flights.size(), 2U);
  EXPECT_EQ(flights[0].require<double>("riser_m", Within{0.05, 0.25}), 0.14);
  EXPECT_EQ(flights[0].optional<bool>("open", false, Any{}), false);
  EXPECT_EQ(flights[1].optional<bool>("open", false, Any{}), true);
  EXPECT_FALSE(flights[0].find<double>("tread_m", Any{}));
  EXPECT_TRUE(site.find_maps("floors").empty());
  EXPECT_FALSE(site.find_map("robot"));
  EXPECT_EQ(site.verbatim("devices")["lidar"]["port"].Scalar(), "0x1");
  site.finish();
  EXPECT_TRUE(faults.empty());
  EXPECT_TRUE(site.sound());
  EXPECT_EQ(site.origin("pose").line, 8);
  EXPECT_EQ(flights[1].origin().line, 5);
}

TEST(MapReader, ReportsEveryFaultWithItsPathAndLine)
{
  Faults faults;
  auto site = MapReader::from_text(kSite, "site.yaml", faults);
  EXPECT_EQ(site.require<double>("name", Any{}), 0.0);
  auto flights = site.require_maps("flights");
  static_cast<void>(flights[1].require<std::string>("id", OneOf{"lower"}));
  static_cast<void>(flights[1].require<double>("riser_m", Any{}));
  static_cast<void>(flights[1].optional<bool>("open", false, Any{}));
  flights[1].finish();
  ASSERT_EQ(faults.size(), 4U);
  EXPECT_EQ(
    to_string(faults[0]), "site.yaml:1: name: value 'tower' refused, accepted: a finite number");
  EXPECT_EQ(faults[1].name, "flights[1].id");
  EXPECT_EQ(
    to_string(faults[2]), "site.yaml:5: flights[1].riser_m: missing, accepted: a finite number");
  EXPECT_EQ(
    to_string(faults[3]),
    "site.yaml:6: flights[1].raiser_m: value '0.15' refused, accepted: a known key; did you mean "
    "riser_m?");
  EXPECT_FALSE(flights[1].sound());
}

TEST(MapReader, RefusesWhatIsNoMapOrNoListOfMaps)
{
  Faults faults;
  auto site = MapReader::from_text("a: 1\nb: [1, {c: 2}]\nd: {e: 1}\n", "s.yaml", faults);
  EXPECT_FALSE(site.require_map("a").sound());
  EXPECT_EQ(site.require_maps("b").size(), 2U);
  EXPECT_TRUE(site.require_maps("d").empty());
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(to_string(faults[0]), "s.yaml:1: a: value '1' refused, accepted: a map");
  EXPECT_EQ(to_string(faults[1]), "s.yaml:2: b[0]: value '1' refused, accepted: a map");
  EXPECT_EQ(to_string(faults[2]), "s.yaml:3: d: value 'a map' refused, accepted: a list of maps");
}

TEST(MapReader, IsSpoiledByFaultsBelowButNotBeside)
{
  Faults faults;
  auto site = MapReader::from_text("a: [{b: {c: x}}, {b: {c: 1}}]", "s.yaml", faults);
  auto maps = site.require_maps("a");
  for (MapReader & map : maps) {
    static_cast<void>(map.require_map("b").require<double>("c", Any{}));
  }
  EXPECT_FALSE(site.sound());
  EXPECT_FALSE(maps[0].sound());
  EXPECT_TRUE(maps[1].sound());
}

TEST(MapReader, SaysOnceThatAMapIsMissing)
{
  Faults faults;
  auto pose = MapReader::from_text("a: 1", "s.yaml", faults).require_map("pose");
  EXPECT_EQ(pose.require<double>("x_m", Any{}), 0.0);
  EXPECT_TRUE(pose.require_maps("y").empty());
  pose.finish();
  EXPECT_EQ(faults.size(), 1U);
  EXPECT_FALSE(pose.sound());
}

TEST(MapReader, RefusesDuplicatesMergeKeysAndTheCallersDoubts)
{
  Faults faults;
  auto reader = MapReader::from_text("a: 1\na: 2\n<<: {b: 3}\n", "s.yaml", faults);
  EXPECT_EQ(reader.keys(), std::vector<std::string>{"a"});
  reader.refuse("a", "1", "a better number");
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(
    to_string(faults[0]), "s.yaml:2: a: value '2' refused, accepted: once only; first on line 1");
  EXPECT_EQ(faults[1].line, 3);
  EXPECT_EQ(to_string(faults[2]), "s.yaml:1: a: value '1' refused, accepted: a better number");
}

TEST(MapReader, ReportsAFileThatIsNotThere)
{
  Faults faults;
  auto site = MapReader::from_file("no/such.yaml", faults);
  static_cast<void>(site.require<std::string>("name", Any{}));
  site.finish();
  EXPECT_EQ(faults.size(), 1U);
}

}  // namespace
}  // namespace stetro_config
