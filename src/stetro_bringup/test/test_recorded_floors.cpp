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

#include <Eigen/Core>
#include <string>

#include "profiles/logs_suite.hpp"
#include "profiles/maps_suite.hpp"

namespace stetro_bringup
{
namespace
{

TEST(FreeDirection, IsShownAlongWhatTheMapLeavesFree)
{
  stetro_supervisor::Determination told;  // 3 cm along x by the map, and 1 cm across
  told.worst_direction = Eigen::Vector2d::UnitX();
  told.worst_sigma_m = 0.03;
  told.covariance = Eigen::Vector2d(9e-4, 1e-4).asDiagonal();
  const auto shown = [&told](double along_m, double across_m) {
    const Eigen::Vector2d variances(along_m * along_m, across_m * across_m);
    return shows_free_direction(variances.asDiagonal(), told);
  };
  EXPECT_TRUE(shown(0.03, 0.01));
  EXPECT_FALSE(shown(0.01, 0.03)) << "another direction is";
  EXPECT_FALSE(shown(0.03, 0.025)) << "not one of them";
  EXPECT_FALSE(shown(0.012, 0.002)) << "it claims to know the place";
  told.covariance = Eigen::Vector2d(9e-4, 8.5e-4).asDiagonal();
  EXPECT_TRUE(shown(0.05, 0.045)) << "where the map tells both badly, so does it";
}

TEST(RecordedFloors, ASmallArenaIsSolvedAndNeverWrong)
{
  const std::string folder = STETRO_RECORDED;
  const auto arena = grid_floor("tb3_world", folder + "/maps/tb3_world/map.yaml");
  const auto tables = run_maps({arena}, 60, 20260101, [] {});
  ASSERT_EQ(tables.size(), 1u);
  const MapsTable & table = tables[0];
  EXPECT_GT(table.determined_share, 0.9);
  EXPECT_GE(table.determined.solved * 100, table.determined.cases * 97);
  EXPECT_EQ(table.determined.false_accepts + table.elsewhere.false_accepts, 0u);
  EXPECT_LT(table.published.solved * 2, table.published.cases) << "the published search does less";
}

TEST(RecordedFloors, ScansOfAMovingRobotAreFoundInAChangedRoom)
{
  for (const RecordedLog & log : recorded_logs(STETRO_RECORDED)) {
    if (log.name != "uw_tb4_line" && log.name != "rplidar_a1") {
      continue;
    }
    const LogSummary sum = summary_of(run_log(log, 20260101, [] {}));
    EXPECT_GE((sum.right + sum.no_verdict) * 100, sum.cases * 85) << log.name;
    EXPECT_GE(sum.verdicts * 2, sum.cases) << log.name;
    EXPECT_EQ(sum.false_accepts, 0u) << log.name;
  }
}

}  // namespace
}  // namespace stetro_bringup
