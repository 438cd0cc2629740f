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
#include <limits>

#include "../../src/node/convert.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr Time kNow{1'000'000'000'007};
constexpr double kInf = std::numeric_limits<double>::infinity();

stetro_msgs::msg::RangeArray ranges(const char * sensor, double range_m, std::uint8_t status)
{
  stetro_msgs::msg::RangeReading reading;
  reading.sensor(sensor);
  reading.range(range_m);
  reading.status(status);
  reading.stamp(stamp_of(kNow));
  stetro_msgs::msg::RangeArray message;
  message.readings({reading});
  return message;
}

geometry_msgs::msg::Quaternion heading(double yaw_rad)
{
  geometry_msgs::msg::Quaternion q;
  q.z(std::sin(yaw_rad / 2));
  q.w(std::cos(yaw_rad / 2));
  return q;
}

}  // namespace

TEST(Convert, RangesAreKeptByPlaceWithTheTimeOfReception)
{
  namespace wire = stetro_msgs::msg::RangeReading_Constants;
  Observation seen;
  EXPECT_FALSE(take(ranges("block3_front", 0.2, wire::STATUS_VALID), kNow, seen));
  ASSERT_TRUE(seen.range(Place::kBlock3Front).has_value());
  EXPECT_EQ(seen.range(Place::kBlock3Front)->range_m, 0.2);
  EXPECT_FALSE(take(ranges("block3_front", 0.2, wire::STATUS_VALID), kNow + Time{50}, seen));
  EXPECT_EQ(seen.range(Place::kBlock3Front)->time, kNow) << "repeated, not measured again";
}

TEST(Convert, StopsRangesThatAreNoRanges)
{
  namespace wire = stetro_msgs::msg::RangeReading_Constants;
  Observation seen;
  EXPECT_TRUE(take(ranges("side_left", std::nan(""), wire::STATUS_VALID), kNow, seen));
  EXPECT_TRUE(take(ranges("side_left", kInf, wire::STATUS_VALID), kNow, seen));
  EXPECT_TRUE(take(ranges("side_left", -0.1, wire::STATUS_VALID), kNow, seen));
  EXPECT_TRUE(take(ranges("side_left", 0.1, 99), kNow, seen));
  EXPECT_TRUE(take(ranges("tof3", 0.1, wire::STATUS_VALID), kNow, seen));
  EXPECT_FALSE(seen.range(Place::kSideLeft).has_value()) << "nothing was taken";
  EXPECT_FALSE(take(ranges("side_left", kInf, wire::STATUS_NO_TARGET), kNow, seen)) << "REP 117";
}

TEST(Convert, StopsBlocksThatCannotBe)
{
  Observation seen;
  stetro_msgs::msg::BlockStates message;
  message.block1().load(1.5);
  EXPECT_TRUE(take(message, kNow, seen));
  message.block1().load(std::nan(""));
  message.block2().height(-0.01);
  EXPECT_TRUE(take(message, kNow, seen));
  EXPECT_FALSE(seen.blocks.has_value());
  message.block2().height(0.14);
  EXPECT_FALSE(take(message, kNow, seen));
  EXPECT_TRUE(std::isnan(seen.blocks->block[0].load)) << "unknown stays unknown";
}

TEST(Convert, ReadsTheHeadingCounterClockwise)
{
  Observation seen;
  nav_msgs::msg::Odometry odometry;
  odometry.pose().pose().orientation().w(0.0);
  EXPECT_TRUE(take(odometry, kNow, seen)) << "a zero quaternion is no orientation";
  odometry.pose().pose().orientation(heading(0.1));
  EXPECT_FALSE(take(odometry, kNow, seen));
  EXPECT_NEAR(seen.odometry->yaw_rad, 0.1, 1e-12);
}

TEST(Convert, StopsAnOkPoseThatIsNotFinite)
{
  namespace wire = stetro_msgs::msg::StairPose_Constants;
  Observation seen;
  stetro_msgs::msg::StairPose message;
  message.integrity(wire::INTEGRITY_OK);
  message.pose().pose().orientation(heading(-0.05));
  message.pose().pose().position().y(std::nan(""));
  EXPECT_TRUE(take(message, kNow, seen));
  message.integrity(wire::INTEGRITY_LOST);
  EXPECT_FALSE(take(message, kNow, seen)) << "a lost pose may be unknown";
  EXPECT_EQ(seen.pose->integrity, Integrity::kLost);
}

TEST(Convert, CommandCarriesOneKindAndItsLease)
{
  namespace wire = stetro_msgs::msg::Command_Constants;
  const Issuer issuer{"/stetro/supervisor", 42, std::chrono::milliseconds(150)};
  const auto message = to_message(lower(3), issuer, 9, kNow);
  EXPECT_EQ(message.kind(), wire::KIND_LOWER);
  EXPECT_EQ(message.block(), 3);
  EXPECT_EQ(message.sequence_number(), 9u);
  EXPECT_EQ(message.issuer_instance(), 42u);
  EXPECT_EQ(message.valid_for().nanosec(), 150'000'000u);
  EXPECT_EQ(to_message(hold(), issuer, 1, kNow).kind(), wire::KIND_HOLD);
  EXPECT_EQ(to_message(traverse(-0.1, 0.2), issuer, 1, kNow).vy(), -0.1);
}

TEST(Convert, ACommandReplacedByANewerOneWasNotRefused)
{
  namespace wire = stetro_msgs::msg::CommandStatus_Constants;
  Observation seen;
  stetro_msgs::msg::CommandStatus message;
  message.outcome(wire::OUTCOME_REFUSED);
  message.reason(wire::REASON_REPLACED);
  EXPECT_FALSE(take(message, kNow, seen));
  EXPECT_FALSE(seen.driver_answer->refused);
  message.reason(wire::REASON_WRONG_STEERING);
  EXPECT_FALSE(take(message, kNow, seen));
  EXPECT_TRUE(seen.driver_answer->refused);
}

TEST(Convert, DoubtsARequestWhoseIdIsEmptyOrMayBeCut)
{
  stetro_msgs::msg::MissionRequest message;
  message.request_id("1");
  ASSERT_TRUE(doubt_of(message)) << "no issuer";
  EXPECT_EQ(doubt_of(message)->reason, "empty_id");
  message.issuer("rviz");
  EXPECT_FALSE(doubt_of(message));
  message.request_id(std::string(64, 'a'));
  ASSERT_TRUE(doubt_of(message));
  EXPECT_EQ(doubt_of(message)->reason, "full_string");
}

TEST(Convert, KnowsEveryKindOfRequest)
{
  namespace wire = stetro_msgs::msg::MissionRequest_Constants;
  stetro_msgs::msg::MissionRequest message;
  message.kind(wire::KIND_CHECK_POSE);
  EXPECT_EQ(from_message(message).kind, RequestKind::kCheckPose);
  for (std::uint8_t kind = wire::KIND_CLEAN_FLIGHT; kind <= wire::KIND_CHECK_POSE; ++kind) {
    message.kind(kind);
    EXPECT_NE(from_message(message).kind, RequestKind::kUnknown) << int{kind};
  }
  message.kind(wire::KIND_CHECK_POSE + 1);
  EXPECT_EQ(from_message(message).kind, RequestKind::kUnknown);
}

TEST(Convert, StatusEchoesTheAnswerAndNamesTheFault)
{
  namespace wire = stetro_msgs::msg::MissionStatus_Constants;
  MissionStatus status;
  status.mission = MissionState::kFault;
  status.fault = Fault::kSkewed;
  status.state = State::kFault;
  status.swept_share = {1.0, 0.5};
  const auto message = to_message(status, MissionAnswer{"r1", "rviz", false, "because"}, kNow);
  EXPECT_EQ(message.answer(), wire::ANSWER_REFUSED);
  EXPECT_STREQ(message.request_id().c_str(), "r1");
  EXPECT_STREQ(message.fault().c_str(), "skewed");
  EXPECT_EQ(message.swept_share().size(), 2u);
  EXPECT_EQ(to_message(status, std::nullopt, kNow).answer(), wire::ANSWER_NONE);
}

}  // namespace stetro_supervisor
