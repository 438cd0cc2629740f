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
#include <string>

#include "node/convert.hpp"
#include "support/localizer_on_wire.hpp"
#include "support/two_floors.hpp"

namespace stetro_localizer
{
namespace
{

namespace stair = stetro_msgs::msg::StairPose_Constants;

constexpr char kSite[] = R"(name: drawn
floors:
  - id: ground
    elevation_m: 0.0
    walls: {outline: [{x_m: 0, y_m: 0}, {x_m: 6, y_m: 0}, {x_m: 6, y_m: 4}, {x_m: 0, y_m: 4}]}
  - id: landing
    elevation_m: 2.24
    walls: {outline: [{x_m: 5, y_m: 0}, {x_m: 14, y_m: 0}, {x_m: 14, y_m: 4}, {x_m: 5, y_m: 4}]}
flights:
  - id: lower
    joins: [ground, landing]
    steps: 16
    riser_m: 0.14
    tread_m: 0.32
    width_m: 2.05
    sides: {right: walled, left: walled}
    wall_overrun_m: 0.0
    pose: {x_m: 5.0, y_m: 0.0, z_m: 0.0, yaw_rad: 0.0}
)";

/// On a site whose floors are drawn.
class LocalizerNodeFloorTest : public LocalizerOnWire
{
protected:
  LocalizerNodeFloorTest() : LocalizerOnWire(kSite) { start(); }

  void correct(double x_m, double y_m, std::uint32_t reset_counter)
  {
    stetro_msgs::msg::PoseCorrection message;
    message.header().frame_id(std::string("ground"));
    message.header().stamp(stamp_of(robot_.now));
    message.segment_id(std::string("ground"));
    message.source(stetro_msgs::msg::PoseCorrection_Constants::SOURCE_PROFILE);
    message.reset_counter(reset_counter);
    message.pose().pose().position().x(x_m);
    message.pose().pose().position().y(y_m);
    message.pose().pose().orientation().w(1.0);
    for (const std::size_t i : {0u, 7u, 35u}) {
      message.pose().covariance()[i] = 4e-4;
    }
    wire_.correct(message);
  }

  LevelRobot robot_{wire_};
};

TEST_F(LocalizerNodeFloorTest, SaysThatItDoesNotKnowWhereItIs)
{
  robot_.drive(1.0, 0.0);
  ASSERT_TRUE(stair_pose_ && static_tf_);
  EXPECT_EQ(stair_pose_->segment_kind(), stair::SEGMENT_UNKNOWN);
  EXPECT_EQ(std::string(stair_pose_->segment_id().c_str()), "");
  EXPECT_EQ(std::string(stair_pose_->header().frame_id().c_str()), "map");
  EXPECT_EQ(stair_pose_->step_index(), stair::STEP_UNKNOWN);
  EXPECT_EQ(stair_pose_->integrity(), stair::INTEGRITY_LOST);
  EXPECT_EQ(stair_pose_->reasons(), stair::REASON_NOT_INITIALISED);
  EXPECT_FALSE(pose_) << "an unknown pose is none";
  EXPECT_EQ(static_tf_->transforms().size(), 3u) << "a flight and two floors";
}

TEST_F(LocalizerNodeFloorTest, IsLocatedByTwoCorrectionsAndCountsThem)
{
  robot_.drive(1.0, 0.0);
  correct(2.0, 1.0, 0);
  EXPECT_EQ(stair_pose_->integrity(), stair::INTEGRITY_LOST);
  robot_.drive(0.5, 0.1);
  correct(2.05, 1.0, 0);
  ASSERT_TRUE(pose_);
  EXPECT_EQ(stair_pose_->integrity(), stair::INTEGRITY_OK) << stair_pose_->reasons();
  EXPECT_EQ(stair_pose_->segment_kind(), stair::SEGMENT_FLOOR);
  EXPECT_EQ(std::string(stair_pose_->segment_id().c_str()), "ground");
  EXPECT_EQ(std::string(stair_pose_->header().frame_id().c_str()), "ground");
  EXPECT_EQ(stair_pose_->step_index(), 0);
  EXPECT_EQ(stair_pose_->step_count(), 0);
  EXPECT_TRUE(std::isnan(stair_pose_->tread_x()));
  EXPECT_EQ(stair_pose_->reset_counter(), 1u);
  EXPECT_NEAR(pose_->pose().pose().position().x(), 2.05, 0.01);
  robot_.drive(0.5, 0.0);
  correct(2.05, 1.0, 1);
  robot_.drive(0.5, 0.0);
  correct(2.05, 1.0, 0);  // of before the reset
  EXPECT_EQ(diagnosed("corrections", "awaits_another"), "1");
  EXPECT_EQ(diagnosed("corrections", "reset"), "1");
  EXPECT_EQ(diagnosed("corrections", "fused"), "1");
  EXPECT_EQ(diagnosed("corrections", "stale_reset_counter"), "1");
}

TEST_F(LocalizerNodeFloorTest, AToldPoseInMapIsOnTheSegmentThatHasThePlace)
{
  robot_.drive(1.0, 0.0);
  StairEstimate told;
  told.stamp = robot_.now;
  told.pose = {3.0, 1.0, 0.0, 0.0};
  geometry_msgs::msg::PoseWithCovarianceStamped message;
  fill(message, told, Segment{});
  wire_.tell(message);
  EXPECT_EQ(std::string(stair_pose_->segment_id().c_str()), "ground");
  EXPECT_EQ(stair_pose_->integrity(), stair::INTEGRITY_OK) << stair_pose_->reasons();
  EXPECT_EQ(diagnosed("estimate", "segment"), "ground");

  robot_.drive(15.0, 0.1);  // to the foot of the stairs
  EXPECT_EQ(std::string(stair_pose_->segment_id().c_str()), "lower");
  EXPECT_EQ(stair_pose_->segment_kind(), stair::SEGMENT_FLIGHT);
  EXPECT_NEAR(stair_pose_->pose().pose().position().x(), -0.5, 0.02);
  EXPECT_NEAR(pose_->pose().pose().position().x(), 4.5, 0.02);
  EXPECT_EQ(stair_pose_->reset_counter(), 1u);
}

}  // namespace
}  // namespace stetro_localizer
