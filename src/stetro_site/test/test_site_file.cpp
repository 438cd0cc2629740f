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

#include <optional>
#include <string>
#include <vector>

#include "./written_file.hpp"
#include "stetro_site/site.hpp"

namespace stetro_site
{
namespace
{

const char kPapers[] = "site/papers_staircase.yaml";
const char kBuilding[] = "site/two_floors.yaml";

/// Every fault of a text as "name: value 'x' refused, ..." without its place.
std::string faults_of(const std::string & text)
{
  const WrittenFile file{text};
  stetro_config::Faults faults;
  EXPECT_FALSE(read_site(file.path(), faults));
  std::string lines;
  for (auto fault : faults) {
    EXPECT_EQ(fault.file, file.path());
    EXPECT_GT(fault.line, 0) << fault;
    fault.file.clear();
    lines += to_string(fault) + "\n";
  }
  return lines;
}

/// The papers' staircase with one more line in its flight.
std::string papers_with(const std::string & line)
{
  return with(shipped(kPapers), "    riser_m: 0.14\n", "    riser_m: 0.14\n    " + line + "\n");
}

TEST(SiteFile, OfThePapersReadsAsTheyPrintIt)
{
  const Site site = load_site(std::string{CONFIG_FOLDER} + kPapers);
  const Flight & stairs = site.flight("stairs");
  EXPECT_EQ(stairs.steps(), 16);
  EXPECT_EQ(stairs.riser_m(7), 0.14);
  EXPECT_EQ(stairs.tread_m(16), 0.32);
  EXPECT_EQ(stairs.width_m(3.0), 2.05);
  EXPECT_EQ(stairs.spec().right, Side::kWalled);
  EXPECT_EQ(stairs.spec().wall_overrun_m, 1.0);
  EXPECT_EQ(site.neighbours("stairs"), (std::vector<std::string>{"ground", "landing"}));
  EXPECT_TRUE(site.notes().empty());
}

TEST(SiteFile, OfABuildingReadsItsExceptionsAndItsTurn)
{
  const Site site = load_site(std::string{CONFIG_FOLDER} + kBuilding);
  EXPECT_EQ(site.flight("lower").steps(), 16);
  EXPECT_NEAR(site.flight("upper").total_rise_m(), 1.12, 1e-12);
  EXPECT_EQ(site.neighbours("landing"), (std::vector<std::string>{"lower", "upper"}));
  // The upper flight leads back: its first tread, at the right-hand wall, is at x = 10.12 - 0.16.
  const Pose pose = site.flight("upper").T_map_flight().to_map(Pose{0.16, 0.0, 0.14, 0.0});
  EXPECT_NEAR(pose.x_m, 9.96, 1e-12);
  EXPECT_NEAR(pose.y_m, 4.6, 1e-12);
  EXPECT_NEAR(pose.z_m, 2.38, 1e-12);
  const auto & ground = std::get<PolygonWalls>(site.floor("ground").drawing);
  // The room less its corner, and the stairs' first treads.
  EXPECT_NEAR(signed_area_m2(ground.outline), 5.0 * 4.0 - 1.2 * 0.8 + 0.96 * 2.05, 1e-12);
  EXPECT_EQ(ground.obstacles.size(), 1U);
  EXPECT_EQ(site.origin("flights[1].width_m").line, site.origin("flights[1].tread_m").line + 1);
}

// D1-10: 16 x 14 = 224, and the papers print 165.
TEST(SiteFile, RefusesTheHeightThePapersPrint)
{
  EXPECT_EQ(
    faults_of(papers_with("total_height_m: 1.65")),
    "flights[0].total_height_m: value '1.65' refused, accepted: 2.24 = 16 x 0.14 risers, within "
    "0.01 (differs by 0.59)\n");
}

TEST(SiteFile, TakesAHeightThatAgrees)
{
  const WrittenFile file{papers_with("total_height_m: 2.25")};
  EXPECT_NO_THROW(static_cast<void>(load_site(file.path())));
}

// D1-10: 16 x 32 = 512, and the papers print 480 = 15 x 32.
TEST(SiteFile, SaysWhichLengthIsMeant)
{
  const WrittenFile whole{papers_with("total_length_m: 5.12")};
  EXPECT_TRUE(load_site(whole.path()).notes().empty());
  const WrittenFile centres{papers_with("total_length_m: 4.80")};
  EXPECT_EQ(
    load_site(centres.path()).notes(),
    std::vector<std::string>{
      "flights[0].total_length_m: 4.8 is the length from the first tread's centre to the last's; "
      "all treads together are 5.12"});
  EXPECT_EQ(
    faults_of(papers_with("total_length_m: 5.00")),
    "flights[0].total_length_m: value '5' refused, accepted: 5.12 = 16 x 0.32 treads (differs by "
    "0.12), or 4.8 from the first tread's centre to the last's (differs by 0.2), within 0.01\n");
}

TEST(SiteFile, CountsExceptionsInItsSums)
{
  EXPECT_EQ(
    faults_of(with(
      papers_with("exceptions: [{step: 16, riser_m: 0.15}]\n    total_height_m: 2.24"), "2.24 ",
      "2.30 ")),
    "flights[0].joins: value 'landing at 2.3' refused, accepted: a floor at 2.25 = 0 of ground + "
    "2.25 of 16 risers, within 0.01 (differs by 0.05)\n");
}

TEST(SiteFile, RefusesExceptionsThatAreNone)
{
  EXPECT_EQ(
    faults_of(
      papers_with("exceptions: [{step: 17, riser_m: 0.1}, {step: 2}, {step: 3, tread_m: 0.33}, "
                  "{step: 3, tread_m: 0.31}, {step: 4, treed_m: 0.3}]")),
    "flights[0].exceptions[0].step: value '17' refused, accepted: a whole number, 1 to 16\n"
    "flights[0].exceptions[1].step: value '2' refused, accepted: an exception with riser_m, "
    "tread_m or both\n"
    "flights[0].exceptions[3].step: value '3' refused, accepted: one exception for each step\n"
    "flights[0].exceptions[4].treed_m: value '0.3' refused, accepted: a known key; did you mean "
    "tread_m?\n");
}

TEST(SiteFile, ReportsAllFaultsOfAllFlightsAtOnce)
{
  std::string text = with(shipped(kBuilding), "riser_m: 0.14", "raiser_m: 0.14");
  text = with(
    text, "right: walled, left: walled}\n    wall_overrun_m: 0.0\n    pose: {x_m: 10.12",
    "right: glass}\n    pose: {x_m: .nan");
  text = with(text, "{x_m: 5.96, y_m: 2.05}", "{x_m: 5.96}");
  EXPECT_EQ(
    faults_of(text),
    "floors[0].walls.outline[2].y_m: missing, accepted: a finite number\n"
    "flights[0].riser_m: missing, accepted: a finite number, 0.02 to 0.5\n"
    "flights[0].raiser_m: value '0.14' refused, accepted: a known key; did you mean riser_m?\n"
    "flights[1].sides.right: value 'glass' refused, accepted: text (quoted if it looks like a "
    "number), one of walled, open\n"
    "flights[1].sides.left: missing, accepted: text (quoted if it looks like a number), one of "
    "walled, open\n"
    "flights[1].pose.x_m: value '.nan' refused, accepted: a finite number\n");
}

TEST(SiteFile, ReportsTotalsAndGraphTogether)
{
  const std::string text =
    with(papers_with("total_height_m: 1.65"), "[ground, landing]", "[ground, attic]");
  EXPECT_EQ(
    faults_of(text),
    "flights[0].total_height_m: value '1.65' refused, accepted: 2.24 = 16 x 0.14 risers, within "
    "0.01 (differs by 0.59)\n"
    "flights[0].joins: value 'attic' refused, accepted: the id of a floor: ground, landing\n");
}

TEST(SiteFile, PlacesAFlightOnItsLowerFloor)
{
  EXPECT_EQ(
    faults_of(with(shipped(kPapers), "z_m: 0.0", "z_m: 0.5")),
    "flights[0].pose.z_m: value '0.5' refused, accepted: 0, the elevation of ground, within "
    "0.01\n");
}

TEST(SiteFile, RefusesWallsThatMeetThemselves)
{
  EXPECT_EQ(
    faults_of(with(shipped(kBuilding), "{x_m: 5.96, y_m: 0.0}", "{x_m: -1.0, y_m: 3.0}")),
    "floors[0].walls.outline: value 'the edge at corner 1 meets the edge at corner 3' refused, "
    "accepted: a closed line of three corners or more that never meets itself\n");
}

/// The papers' staircase, its ground drawn as a map.
std::string site_with(const std::string & map)
{
  const std::string floor = "elevation_m: 0.0\n";
  return with(shipped(kPapers), floor, floor + "    map: " + map + "\n");
}

const char kMap[] =
  "resolution: 0.05\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n";

TEST(SiteFile, ReadsTheGridMapOfAFloor)
{
  const WrittenFile image{"P2 3 1 255\n0 254 205\n"};
  const WrittenFile map{"image: " + image.path() + "\n" + kMap};
  const WrittenFile file{site_with(map.path())};
  const Site site = load_site(file.path());
  const auto & drawing = std::get<GridMapFile>(site.floor("ground").drawing);
  EXPECT_EQ(drawing.path, map.path());
  ASSERT_NE(drawing.grid, nullptr);
  EXPECT_EQ(drawing.grid->at(drawing.grid->cell_at({1.025, 2.025})), Cell::kOccupied);
  ASSERT_EQ(site.notes().size(), 1U);
  EXPECT_EQ(site.notes()[0].find("floors[0].map: " + map.path() + ": 1 cells of level 205"), 0U);
}

TEST(SiteFile, RefusesAFloorWhoseMapHasFaults)
{
  const WrittenFile image{"P2 3 1 255\n0 254\n"};
  const WrittenFile map{"image: " + image.path() + "\n" + with(kMap, "[1,", "[.nan,")};
  const std::string refused =
    "floors[0].map: value '" + map.path() + "' refused, accepted: a map without faults; ";
  EXPECT_EQ(
    faults_of(site_with(map.path())),
    refused + map.path() + ":1: image: value '" + image.path() +
      ": ends after 2 pixels' refused, accepted: 3 = 3 x 1 pixels, as its header says\n" + refused +
      map.path() +
      ":3: origin: value '[.nan, 2, 0]' refused, accepted: a list of finite numbers, 3 of them, "
      "each -1000000 to 1000000\n");
}

TEST(SiteFile, WantsOneDrawingOfAFloor)
{
  const WrittenFile image{"P2 1 1 255\n254\n"};
  const WrittenFile map{"image: " + image.path() + "\n" + kMap};
  EXPECT_NE(faults_of(site_with("no_such.yaml")).find("floors[0].map: value"), std::string::npos);
  EXPECT_NE(
    faults_of(site_with(map.path() + "\n    walls: {outline: []}")).find("either map or walls"),
    std::string::npos);
}

TEST(SiteFile, SaysOnceThatThereIsNone)
{
  stetro_config::Faults faults;
  EXPECT_FALSE(read_site("no/such.yaml", faults));
  EXPECT_EQ(faults.size(), 1U);
  EXPECT_THROW(static_cast<void>(load_site(CONFIG_FOLDER)), stetro_config::ConfigError);
}

TEST(SiteFile, NeedsFloors)
{
  EXPECT_EQ(faults_of("name: a\n"), "floors: missing, accepted: a list of maps\n");
  EXPECT_EQ(
    faults_of("name: a\nfloors: []\n"),
    "floors: value '[]' refused, accepted: at least one floor\n");
}

// Property: however the file is cut off or a line is lost, nothing but ConfigError leaves.
TEST(SiteFile, ThrowsNothingElseWhateverTheFileHolds)
{
  const std::string good = shipped(kBuilding);
  for (std::size_t cut = good.find("name:"); cut < good.size(); cut += 7) {
    for (const std::string & text : {good.substr(0, cut), std::string{good}.erase(cut, 9)}) {
      const WrittenFile file{text};
      stetro_config::Faults faults;
      std::optional<Site> site;
      EXPECT_NO_THROW(site = read_site(file.path(), faults)) << text;
      EXPECT_EQ(site.has_value(), faults.empty()) << text;
    }
  }
}

}  // namespace
}  // namespace stetro_site
