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

// What the fused estimator finds of the staircase that it climbs, against the world.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "accuracy/climb.hpp"
#include "accuracy/estimator_totals.hpp"

namespace stetro_bringup
{
namespace
{

constexpr int kSteps = 6;

/// A flight of six steps as the papers', but for the `exceptions` of the site file.
RobotSetup six_steps(const std::string & exceptions)
{
  const auto folder = std::filesystem::path(testing::TempDir());
  const std::string site = folder / "test_staircase_climb_site.yaml";
  std::ofstream(site) << "name: six_steps\n"
                         "floors:\n"
                         "  - {id: ground, elevation_m: 0.0}\n"
                         "  - {id: landing, elevation_m: 0.84}\n"
                         "flights:\n"
                         "  - id: stairs\n"
                         "    joins: [ground, landing]\n"
                         "    steps: 6\n"
                         "    riser_m: 0.14\n"
                         "    tread_m: 0.32\n"
                         "    exceptions: ["
                      << exceptions
                      << "]\n"
                         "    width_m: 2.05\n"
                         "    sides: {right: walled, left: walled}\n"
                         "    wall_overrun_m: 1.0\n"
                         "    pose: {x_m: 0.0, y_m: 0.0, z_m: 0.0, yaw_rad: 0.0}\n";
  return read_robot_setup({site, STETRO_ROBOT_FILE});
}

ClimbScore climbed(const RobotSetup & setup, std::uint64_t seed, const char * calibration)
{
  ClimbOrder order;
  order.seed = seed;
  order.calibration = calibration;
  order.estimators = {"fused"};
  const ClimbRecord record = climb(setup, order);
  EXPECT_EQ(record.end, ClimbEnd::kFinished) << "seed " << seed << ": " << record.detail;
  return record.scores.front();
}

// Built to +-5 mm, 2.5 mm of standard deviation. Treads of one climb share the pair's offsets, so
// that forty of them tell less of the sigmas than forty would.
TEST(StaircaseClimb, FindsTheTreadsBetterThanTheSiteFileSaysThem)
{
  const RobotSetup setup = six_steps("");
  EstimatorTotals totals(kSteps);
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    totals.add(climbed(setup, seed, "none"));
  }
  const MeasureTotals & treads = totals.tread_depths;
  EXPECT_EQ(treads.found_m.count(), 8u * (kSteps - 1)) << "the last one ends at no riser";
  EXPECT_LT(treads.found_m.rmse(), 0.002);
  EXPECT_LT(treads.found_m.rmse(), 0.8 * treads.site_m.rmse());
  EXPECT_GT(treads.sigmas.inside_95(), 0.85);
  EXPECT_GT(treads.sigmas.mean_square(), 0.4);
  EXPECT_LT(treads.sigmas.mean_square(), 1.8);
  EXPECT_LT(totals.widths.sigmas.mean_square(), 2.0);
  EXPECT_EQ(totals.deviations_reported, 0u);
  EXPECT_GT(totals.flight_x.inside_95(), 0.8) << "the flight frame doubts the treads below";
  EXPECT_GT(totals.flight_z.inside_95(), 0.8);
}

// The site file says 32 cm. What the filter itself finds of such a tread is next to nothing.
TEST(StaircaseClimb, ReportsATreadFourCentimetresDeeperThanTheSiteFile)
{
  RobotSetup setup = six_steps("");
  setup.driver = six_steps("{step: 3, tread_m: 0.36}").driver;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const StaircaseScore score = climbed(setup, seed, "factory").staircase;
    EXPECT_EQ(score.reported, 1u) << "seed " << seed;
    const auto third = std::find_if(
      score.treads.begin(), score.treads.end(), [](const auto & one) { return one.step == 3; });
    ASSERT_NE(third, score.treads.end());
    EXPECT_NEAR(third->site_error_m, -0.04, 0.005) << "seed " << seed;
    EXPECT_LT(std::abs(third->found_error_m), 3.5 * third->sigma_m) << "seed " << seed;
    EXPECT_LT(third->sigma_m, 0.005);
  }
}

}  // namespace
}  // namespace stetro_bringup
