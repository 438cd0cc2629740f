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

#include "./written_file.hpp"
#include "stetro_site/fit.hpp"

namespace stetro_site
{
namespace
{

const char kPapers[] = CONFIG_FOLDER "site/papers_staircase.yaml";
const char kRobot[] = CONFIG_FOLDER "robot/stetro.yaml";

Site flight_of(double riser_m, double tread_m, double width_m)
{
  SiteSpec spec;
  spec.floors.resize(2);
  spec.floors[0].id = "ground";
  spec.floors[1].id = "landing";
  spec.floors[1].pose_in_map.z_m = 3 * riser_m;
  FlightSpec flight;
  flight.id = "stairs";
  flight.steps = equal_steps(3, riser_m, tread_m);
  flight.width_foot_m = flight.width_top_m = width_m;
  flight.lower_floor = "ground";
  flight.upper_floor = "landing";
  spec.flights.emplace_back(flight);
  return Site{spec};
}

std::string misfits(const Site & site, const RobotGeometry & robot = {})
{
  std::string text;
  for (const auto & fault : check_fit(site, robot)) {
    text += to_string(fault) + "\n";
  }
  return text;
}

TEST(Fit, OfThePapersRobotAndStaircase)
{
  const Deployment deployment = load_deployment(kPapers, kRobot);
  EXPECT_EQ(deployment.site.flights().size(), 1U);
  EXPECT_EQ(deployment.robot.name, "stetro");
  EXPECT_NO_THROW(static_cast<void>(load_deployment(CONFIG_FOLDER "site/two_floors.yaml", kRobot)));
}

TEST(Fit, NeedsRoomBetweenTheSides)
{
  EXPECT_EQ(
    misfits(flight_of(0.14, 0.32, 0.23)),
    "flights[0].width_m: value '0.23' refused, accepted: more than 0.23, the robot's contact "
    "width\n");
}

// 2 x 1.20 + 0.10: wider, and in the middle neither side is in range.
TEST(Fit, NeedsOneSideInRangeEverywhere)
{
  EXPECT_EQ(misfits(flight_of(0.14, 0.32, 2.50)), "");
  EXPECT_EQ(
    misfits(flight_of(0.14, 0.32, 2.51)),
    "flights[0].width_m: value '2.51' refused, accepted: at most 2.5 = 2 x 1.2 reliable range + "
    "0.1 between the side sensors\n");
}

TEST(Fit, NeedsTheStrokeToExceedTheRiserByItsMargin)
{
  EXPECT_EQ(misfits(flight_of(0.16, 0.32, 2.05)), "");
  EXPECT_EQ(
    misfits(flight_of(0.161, 0.32, 2.05)),
    "flights[0].riser_m: value '0.161' refused, accepted: at most 0.16 = 0.18 stroke - 0.02 "
    "margin, on every step\n");
}

TEST(Fit, NeedsTreadsForTwoBlocks)
{
  EXPECT_EQ(misfits(flight_of(0.14, 0.30, 2.05)), "");
  EXPECT_EQ(
    misfits(flight_of(0.14, 0.29, 2.05)),
    "flights[0].tread_m: value '0.29' refused, accepted: at least 0.3 = 2 blocks of 0.15, on "
    "every step\n");
}

TEST(Fit, ReportsTheRobotsOwnContradictionsToo)
{
  RobotGeometry robot;
  robot.contact_width_m = 0.19;
  EXPECT_EQ(check_fit(flight_of(0.17, 0.29, 3.0), robot).size(), 4U);
}

TEST(Fit, ReportsTheFaultsOfBothFilesTogether)
{
  const WrittenFile robot{with(shipped("robot/stetro.yaml"), "stroke_m: 0.18", "stroke_m: far")};
  const WrittenFile site{with(shipped("site/papers_staircase.yaml"), "2.24 ", "2.34 ")};
  try {
    static_cast<void>(load_deployment(site.path(), robot.path()));
    FAIL();
  } catch (const stetro_config::ConfigError & error) {
    EXPECT_EQ(error.faults().size(), 2U) << error.what();
  }
}

TEST(Fit, PlacesAMisfitInTheSiteFile)
{
  const WrittenFile site{with(shipped("site/papers_staircase.yaml"), "2.05", "2.55")};
  try {
    static_cast<void>(load_deployment(site.path(), kRobot));
    FAIL();
  } catch (const stetro_config::ConfigError & error) {
    ASSERT_EQ(error.faults().size(), 1U) << error.what();
    EXPECT_EQ(error.faults()[0].file, site.path());
    EXPECT_GT(error.faults()[0].line, 20);
  }
}

}  // namespace
}  // namespace stetro_site
