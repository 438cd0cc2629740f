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

#include <cmath>

#include "stetro_localizer/floor/passage.hpp"
#include "support/two_floors.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kDegree = M_PI / 180.0;

class PassageTest : public testing::Test
{
protected:
  [[nodiscard]] bool enters(double x_m, double y_m, double yaw_rad, double sigma_m = 0.05) const
  {
    stetro_site::Covariance covariance = stetro_site::Covariance::Zero();
    covariance(0, 0) = covariance(1, 1) = sigma_m * sigma_m;
    return passage.enters(
      flight.T_map_flight().to_map(stetro_site::Pose{x_m, y_m, 0.0, yaw_rad}), covariance);
  }

  stetro_site::Site site = two_floors();
  const stetro_site::Flight & flight = site.flight("upper");  // yaw pi
  Passage passage{FloorParams{}, flight};
};

TEST_F(PassageTest, EntersBeforeTheStairsBetweenTheWallsFacingThem)
{
  EXPECT_TRUE(enters(-0.5, 1.0, 0.0));
  EXPECT_TRUE(enters(-0.99, 0.16, 24.0 * kDegree));
  EXPECT_FALSE(enters(-1.01, 1.0, 0.0)) << "too far";
  EXPECT_FALSE(enters(0.001, 1.0, 0.0)) << "on the stairs";
  EXPECT_FALSE(enters(-0.5, 0.14, 0.0)) << "beside the right wall";
  EXPECT_FALSE(enters(-0.5, 1.91, 0.0)) << "beside the left wall";
  EXPECT_FALSE(enters(-0.5, 1.0, 26.0 * kDegree)) << "turned away";
  EXPECT_FALSE(enters(-0.5, 1.0, 0.0, 0.11)) << "hardly known";
}

TEST_F(PassageTest, RetreatsWithRoomToSpare)
{
  EXPECT_FALSE(passage.retreats(0, {-1.29, 1.0, 0.0, 39.0 * kDegree}));
  EXPECT_TRUE(passage.retreats(0, {-1.31, 1.0, 0.0, 0.0}));
  EXPECT_TRUE(passage.retreats(0, {-0.5, 1.0, 0.0, -41.0 * kDegree}));
  EXPECT_FALSE(passage.retreats(1, {0.2, 1.0, 0.14, 1.0}));
}

TEST_F(PassageTest, LeavesLevelAndAtRestOnTheLastStep)
{
  BlockSample blocks = LevelRobot::level(std::chrono::seconds(1));
  EXPECT_TRUE(passage.may_leave(8, blocks));
  EXPECT_FALSE(passage.may_leave(7, blocks));
  blocks.blocks[0].height_m = 0.14;
  EXPECT_FALSE(passage.may_leave(8, blocks));
  blocks.blocks[0] = {0.0, 0.3, true, true, false};
  EXPECT_FALSE(passage.may_leave(8, blocks)) << "moving";
  EXPECT_FALSE(passage.may_leave(8, BlockSample{})) << "nothing has told";
  // The run is 2.56 m, towards -x from 10.12: the floor begins 0.05 m before its end.
  EXPECT_TRUE(passage.leaves({10.12 - 2.52, 3.6, 3.36, M_PI}));
  EXPECT_FALSE(passage.leaves({10.12 - 2.50, 3.6, 3.36, M_PI}));
}

}  // namespace
}  // namespace stetro_localizer
