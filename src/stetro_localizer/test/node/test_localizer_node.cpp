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
#include <fstream>
#include <limits>
#include <string>

#include "node/convert.hpp"
#include "stetro_msgs/PoseCorrection.hpp"
#include "support/localizer_on_wire.hpp"
#include "support/stair_robot.hpp"

namespace stetro_localizer
{
namespace
{

namespace stair = stetro_msgs::msg::StairPose_Constants;

constexpr char kSite[] = R"(name: papers
floors:
  - {id: ground, elevation_m: 0.0}
  - {id: landing, elevation_m: 2.24}
flights:
  - id: papers
    joins: [ground, landing]
    steps: 16
    riser_m: 0.14
    tread_m: 0.32
    width_m: 2.05
    sides: {right: walled, left: walled}
    wall_overrun_m: 1.0
    pose: {x_m: 10.0, y_m: 0.0, z_m: 0.0, yaw_rad: 0.0}
)";

class LocalizerNodeTest : public LocalizerOnWire
{
protected:
  LocalizerNodeTest() : LocalizerOnWire(kSite)
  {
    params_.state_file = (folder_ / "state").string();
    params_.initial_step = 3;
    params_.estimator = "paper";  // exact where the sensors are
    start();
    robot_.stand_on(3);
  }

  [[nodiscard]] std::uint64_t refused(const std::string & topic, const std::string & reason)
  {
    for (const auto & subscription : localizer_->node().subscriptions()) {
      if (subscription->topic() == "/stetro/" + topic) {
        const auto counts = subscription->counts();
        const auto found = counts.refused_by_reason.find(reason);
        return found == counts.refused_by_reason.end() ? 0 : found->second;
      }
    }
    return 0;
  }

  /// That the robot stands where it does: on tread 3, in the flight frame.
  [[nodiscard]] static geometry_msgs::msg::PoseWithCovarianceStamped told_at(Nanoseconds stamp)
  {
    StairEstimate told;
    told.stamp = stamp;
    told.pose = {2.5 * 0.32, 1.0, 3 * 0.14, 0.0};
    geometry_msgs::msg::PoseWithCovarianceStamped message;
    fill(message, told, segment_of(papers_flight()));
    message.header().frame_id("papers");
    message.header().stamp(stamp_of(stamp));
    return message;
  }

  StairRobot robot_{wire_};
};

TEST_F(LocalizerNodeTest, PublishesWhereTheRobotIs)
{
  robot_.rest(1.0);
  ASSERT_TRUE(stair_pose_ && pose_ && innovations_ && tf_);
  EXPECT_EQ(stair_pose_->integrity(), stair::INTEGRITY_OK) << stair_pose_->reasons();
  EXPECT_EQ(stair_pose_->step_index(), 3);
  EXPECT_NEAR(stair_pose_->tread_y(), 1.0, 1e-6);
  EXPECT_NEAR(pose_->pose().pose().position().x(), 10.0 + 2.5 * 0.32, 1e-9) << "in map";
  EXPECT_NEAR(pose_->pose().pose().position().z(), 3 * 0.14, 1e-9);
  EXPECT_EQ(std::string(tf_->transforms()[0].child_frame_id().c_str()), "odom");
  EXPECT_EQ(innovations_->innovations().size(), 6u);
}

// stair_pose is given in the flight's frame, which a transform tree must know.
TEST_F(LocalizerNodeTest, PublishesTheFlightsOfTheSite)
{
  robot_.rest(0.1);
  ASSERT_TRUE(static_tf_ && stair_pose_);
  ASSERT_EQ(static_tf_->transforms().size(), 1u);
  const auto & flight = static_tf_->transforms()[0];
  EXPECT_EQ(std::string(flight.header().frame_id().c_str()), "map");
  EXPECT_EQ(flight.child_frame_id(), stair_pose_->header().frame_id());
  EXPECT_EQ(flight.transform().translation().x(), 10.0);
  EXPECT_EQ(flight.transform().rotation().w(), 1.0);
}

TEST_F(LocalizerNodeTest, AnswersEachArrayOfRangesWithItsStamp)
{
  robot_.rest(1.0);
  robot_.tick(0.0, 0.0, 0.0);
  robot_.tick(0.0, 0.0, 0.0);
  robot_.tick(0.0, 0.0, 0.0);
  const Nanoseconds stamp = time_of(pose_->header().stamp());
  EXPECT_LE(robot_.now - stamp, std::chrono::milliseconds(20));
  robot_.tick(0.0, 0.0, 0.0);
  robot_.tick(0.0, 0.0, 0.0);
  robot_.tick(0.0, 0.0, 0.0);
  EXPECT_EQ(time_of(pose_->header().stamp()) - stamp, std::chrono::milliseconds(30));
}

TEST_F(LocalizerNodeTest, RefusesBadMessagesAndGoesOn)
{
  robot_.rest(1.0);
  RangeSample nan = robot_.ranges();
  nan.readings[0] = {
    robot_.now, std::numeric_limits<double>::quiet_NaN(), 0.0, RangeStatus::kValid};
  wire_.add_ranges(nan, robot_.now);
  RangeSample zero = robot_.ranges();
  zero.stamp = Nanoseconds{0};
  for (RangeReading & reading : zero.readings) {
    reading.status = RangeStatus::kNoTarget;
  }
  wire_.add_ranges(zero, robot_.now);
  wire_.add_gyro({robot_.now + std::chrono::seconds(60), 0.0}, robot_.now);
  wire_.add_gyro({robot_.now - std::chrono::milliseconds(100), 0.0}, robot_.now);
  EXPECT_EQ(refused("ranges", "not_finite"), 1u);
  EXPECT_EQ(refused("ranges", "stamp is zero"), 1u);
  EXPECT_EQ(refused("imu/data", "stamp is in the future"), 1u);
  EXPECT_EQ(refused("imu/data", "out of order"), 1u);
  robot_.rest(0.2);
  EXPECT_EQ(stair_pose_->integrity(), stair::INTEGRITY_OK);
  EXPECT_NEAR(stair_pose_->tread_y(), 1.0, 1e-6);
}

TEST_F(LocalizerNodeTest, SaysThatItsInputsAreSilent)
{
  robot_.rest(1.0);
  for (int i = 0; i < 100; ++i) {
    robot_.now += std::chrono::milliseconds(10);
    localizer_->node().clock().set(robot_.now);
    executor_.drain();
  }
  EXPECT_EQ(stair_pose_->integrity(), stair::INTEGRITY_DEGRADED);
  EXPECT_TRUE(stair_pose_->reasons() & stair::REASON_INPUT_SILENT);
  EXPECT_TRUE(stair_pose_->reasons() & stair::REASON_NO_SIDE_RANGE);
  EXPECT_LE(robot_.now - time_of(stair_pose_->header().stamp()), std::chrono::milliseconds(100));
}

TEST_F(LocalizerNodeTest, GoesOnAfterARestart)
{
  robot_.rest(1.0);
  robot_.climb(3);
  ASSERT_EQ(stair_pose_->step_index(), 4);
  stop();
  params_.initial_step = -1;
  stair_pose_.reset();
  start();
  robot_.rest(1.0);
  ASSERT_TRUE(stair_pose_);
  EXPECT_EQ(stair_pose_->step_index(), 4);
  EXPECT_EQ(stair_pose_->integrity(), stair::INTEGRITY_OK) << stair_pose_->reasons();
}

TEST_F(LocalizerNodeTest, ReportsADamagedStateFileAndWaitsToBeTold)
{
  robot_.rest(1.0);
  stop();
  std::ofstream{params_.state_file} << "garbage";
  start();
  robot_.rest(1.0);
  EXPECT_EQ(stair_pose_->integrity(), stair::INTEGRITY_LOST);
  EXPECT_TRUE(stair_pose_->reasons() & stair::REASON_CALIBRATION_DAMAGED);
  StairEstimate told;
  told.stamp = robot_.now;
  told.pose = {2.5 * 0.32, 1.0, 3 * 0.14, 0.0};
  geometry_msgs::msg::PoseWithCovarianceStamped message;
  fill(message, told, segment_of(papers_flight()));
  message.pose().pose().position().x(10.0 + 2.5 * 0.32);
  wire_.tell(message);
  robot_.rest(1.0);
  EXPECT_EQ(stair_pose_->integrity(), stair::INTEGRITY_OK) << stair_pose_->reasons();
  EXPECT_EQ(stair_pose_->step_index(), 3);
}

TEST_F(LocalizerNodeTest, RefusesPosesThatCannotBe)
{
  robot_.rest(1.0);
  StairEstimate told;
  told.stamp = robot_.now;
  told.pose = {2.5 * 0.32, 1.0, 1.0, 0.0};
  geometry_msgs::msg::PoseWithCovarianceStamped message;
  fill(message, told, segment_of(papers_flight()));
  wire_.tell(message);
  EXPECT_EQ(refused("initialpose", "implausible"), 1u);
  stetro_msgs::msg::PoseCorrection correction;
  correction.header().frame_id(std::string("ground"));
  correction.segment_id(std::string("ground"));
  correction.pose().pose().orientation().w(1.0);
  wire_.correct(correction);
  EXPECT_EQ(refused("pose_correction", "not_on_a_floor"), 1u);
}

TEST_F(LocalizerNodeTest, RefusesAToldPoseByItsStampAndItsFrameAndSaysSo)
{
  robot_.rest(1.0);
  const auto tell = [&](Nanoseconds stamp, const std::string & frame = "papers") {
    auto message = told_at(stamp);
    message.header().frame_id(frame);
    wire_.tell(message);
  };
  tell(Nanoseconds{0});
  EXPECT_EQ(refused("initialpose", "stamp is zero"), 1u);
  tell(robot_.now - std::chrono::seconds(6));
  EXPECT_EQ(refused("initialpose", "too old"), 1u);
  tell(robot_.now + std::chrono::seconds(1));
  EXPECT_EQ(refused("initialpose", "stamp is in the future"), 1u);
  tell(robot_.now, "odom");
  EXPECT_EQ(refused("initialpose", "frame"), 1u);
  EXPECT_EQ(diagnosed("estimate", "initialpose refused"), "4");
  EXPECT_NE(diagnosed("estimate", "initialpose last refused").find("'odom'"), std::string::npos);
  EXPECT_EQ(diagnosed("estimate", "initialpose taken"), "0");
  EXPECT_EQ(stair_pose_->reset_counter(), 0u);

  tell(robot_.now);  // the one refused for its frame has not used up the stamp
  EXPECT_EQ(diagnosed("estimate", "initialpose taken"), "1");
  tell(robot_.now - std::chrono::seconds(1));
  EXPECT_EQ(refused("initialpose", "out of order"), 1u);
  EXPECT_EQ(stair_pose_->reset_counter(), 1u);
}

TEST_F(LocalizerNodeTest, PublishesAToldPoseAtOnceAsAResetWithItsCause)
{
  robot_.rest(1.0);
  EXPECT_EQ(diagnosed("estimate", "last reset"), "none");
  auto message = told_at(robot_.now);
  message.pose().pose().position().y(1.2);
  wire_.tell(message);
  ASSERT_EQ(stair_pose_->reset_counter(), 1u);
  EXPECT_NEAR(stair_pose_->reset_delta_x(), 0.0, 1e-9);
  EXPECT_NEAR(stair_pose_->reset_delta_y(), 0.2, 1e-6);
  EXPECT_NEAR(stair_pose_->reset_delta_z(), 0.0, 1e-9);
  EXPECT_NEAR(stair_pose_->reset_delta_heading(), 0.0, 1e-6);
  EXPECT_NEAR(stair_pose_->pose().pose().position().y(), 1.2, 1e-6);
  EXPECT_EQ(diagnosed("estimate", "resets"), "1");
  EXPECT_EQ(diagnosed("estimate", "last reset"), "told by initialpose");
}

TEST_F(LocalizerNodeTest, EachRestartIsAResetWithANumberOfItsOwn)
{
  robot_.rest(1.0);
  robot_.climb(3);  // something worth storing
  const std::uint32_t before = stair_pose_->reset_counter();
  for (std::uint32_t restart = 1; restart <= 3; ++restart) {
    stop();
    start();
    EXPECT_EQ(diagnosed("estimate", "resets"), std::to_string(before + restart))
      << "nothing has moved since";
    EXPECT_EQ(diagnosed("estimate", "last reset"), "restarted from the stored state");
  }
  robot_.rest(1.0);
  EXPECT_EQ(stair_pose_->step_index(), 4);
  EXPECT_EQ(stair_pose_->reset_counter(), before + 3);
}

TEST_F(LocalizerNodeTest, RefusesToStartOnAWrongSite)
{
  LocalizerParams wrong = params_;
  wrong.flight = "no such flight";
  EXPECT_THROW(
    LocalizerNode(context_, stetro_dds::NodeOptions{"other", "/stetro"}, wrong),
    stetro_config::ConfigError);
  wrong = params_;
  wrong.initial_step = 17;
  EXPECT_THROW(
    LocalizerNode(context_, stetro_dds::NodeOptions{"other", "/stetro"}, wrong),
    stetro_config::ConfigError);
}

}  // namespace
}  // namespace stetro_localizer
