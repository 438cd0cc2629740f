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

#include "stetro_config/field.hpp"
#include "stetro_config/loader.hpp"
#include "stetro_supervisor/climb_geometry.hpp"
#include "stetro_supervisor/climb_params.hpp"
#include "support/toy_robot.hpp"

namespace stetro_supervisor
{
namespace
{

bool refuses(const ClimbParams & params, const std::string & name)
{
  stetro_config::Faults faults;
  check(params, faults);
  for (const auto & fault : faults) {
    if (fault.name == name) {
      return true;
    }
  }
  return false;
}

std::string what_is_wrong(const ClimbGeometry & geometry, const ClimbParams & params = {})
{
  try {
    check_climbable(geometry, params);
  } catch (const std::invalid_argument & error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(ClimbParams, DefaultsAreInBoundsAndAgree)
{
  ClimbParams params;
  for (const auto & field : stetro_config::fields_of(params)) {
    EXPECT_TRUE(field.accepts(field.get())) << field.name;
  }
  stetro_config::Faults faults;
  check(params, faults);
  EXPECT_TRUE(faults.empty());
}

TEST(ClimbParams, RefusesADeadBandBeyondTheAlignmentLimit)  // D2
{
  ClimbParams params;
  params.dead_band_rad = 0.2;
  params.alignment_limit_rad = 0.1;
  EXPECT_TRUE(refuses(params, "heading.dead_band_rad"));
}

TEST(ClimbParams, RefusesAHysteresisWiderThanTheDeadBand)
{
  ClimbParams params;
  params.hysteresis_rad = params.dead_band_rad;
  EXPECT_TRUE(refuses(params, "heading.hysteresis_rad"));
}

TEST(ClimbGeometry, RefusesAThresholdBelowTheSensorsMinimum)  // D2, D3-7
{
  ClimbGeometry geometry = stairs(3);
  geometry.contact_reading_m[stetro_site::index_of(Place::kBlock2Down)] =
    0.005;  // 0.5 cm + 1 cm < 3 cm
  EXPECT_NE(what_is_wrong(geometry).find("touch_down_gap_m"), std::string::npos);
}

TEST(ClimbGeometry, TakesFlightAndBodyFromTheirFiles)
{
  stetro_site::FlightSpec spec;
  spec.id = "stairs";
  spec.steps = stetro_site::equal_steps(16, 0.14, 0.32);
  spec.width_foot_m = 2.05;
  spec.width_top_m = 2.03;
  spec.lower_floor = "ground";
  spec.upper_floor = "landing";
  stetro_site::RobotGeometry robot;
  robot.at(Place::kBlock3Front).bias_m = 0.004;
  const auto geometry = make_geometry(stetro_site::Flight{spec}, robot);
  EXPECT_EQ(geometry.steps(), 16);
  EXPECT_NEAR(geometry.width_at_m(8), 2.05 - 0.02 * 7.5 / 16, 1e-12);
  EXPECT_NEAR(geometry.contact_reading(Place::kSideLeft), 0.065, 1e-12);
  EXPECT_NEAR(geometry.contact_reading(Place::kBlock3Front), 0.039, 1e-12);
  EXPECT_NEAR(geometry.switch_separation_m, 0.16, 1e-12);
}

TEST(ClimbGeometry, RefusesACreepThatIsNoSlowerThanRolling)
{
  ClimbParams params;
  params.creep_speed_mps = params.roll_speed_mps;
  EXPECT_NE(what_is_wrong(stairs(3), params).find("creep"), std::string::npos);
}

TEST(ClimbGeometry, RefusesARiserHigherThanTheLift)
{
  ClimbGeometry geometry = stairs(3);
  geometry.riser_m[1] = 0.175;
  EXPECT_NE(what_is_wrong(geometry).find("0.175"), std::string::npos);
}

TEST(ClimbGeometry, RefusesADoubtThatCouldHideHalfARiser)
{
  ClimbGeometry geometry = stairs(3);
  geometry.riser_m[2] = 0.07;  // 3.6 cm of doubt either way: 7 cm could read as contact
  EXPECT_NE(what_is_wrong(geometry).find("doubt_sigmas"), std::string::npos);
}

TEST(ClimbGeometry, RefusesAFlightTooNarrowToStandClearOfBothWalls)  // D3-12
{
  ClimbGeometry geometry = stairs(3);
  geometry.width_m = 0.30;
  EXPECT_NE(what_is_wrong(geometry).find("width"), std::string::npos);
  EXPECT_EQ(what_is_wrong(stairs(16)), "");
}

}  // namespace stetro_supervisor
