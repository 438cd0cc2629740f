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
#include <memory>
#include <string>
#include <vector>

#include "../../src/node/convert_floor.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr float kInfinity = std::numeric_limits<float>::infinity();

sensor_msgs::msg::LaserScan turn_of(std::size_t beams)
{
  sensor_msgs::msg::LaserScan scan;
  const double step = 2.0 * 3.14159265358979 / static_cast<double>(beams);
  scan.angle_min(-3.14159274F);
  scan.angle_increment(static_cast<float>(step));
  scan.angle_max(static_cast<float>(-3.14159265358979 + step * static_cast<double>(beams - 1)));
  scan.range_min(0.15F);
  scan.range_max(12.0F);
  scan.ranges(std::vector<float>(beams, 2.0F));
  return scan;
}

}  // namespace

TEST(ConvertFloor, TakesAScanAndReadsRangesAsRep117)
{
  auto message = turn_of(720);
  message.ranges()[1] = 0.10F;
  message.ranges()[2] = 13.0F;
  message.ranges()[3] = kInfinity;
  message.ranges()[4] = -kInfinity;
  message.ranges()[5] = std::nanf("");
  std::shared_ptr<const Scan> scan;
  ASSERT_FALSE(take(message, Time{5}, scan));
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->time, Time{5});
  EXPECT_EQ(scan->profile.ranges_m.size(), 720u);
  EXPECT_DOUBLE_EQ(scan->profile.ranges_m[0], 2.0);
  EXPECT_EQ(scan->profile.ranges_m[1], -HUGE_VAL);
  EXPECT_EQ(scan->profile.ranges_m[2], HUGE_VAL);
  EXPECT_EQ(scan->profile.ranges_m[3], HUGE_VAL);
  EXPECT_EQ(scan->profile.ranges_m[4], -HUGE_VAL);
  EXPECT_TRUE(std::isnan(scan->profile.ranges_m[5]));
}

TEST(ConvertFloor, RefusesABadScanAndKeepsTheLast)
{
  std::shared_ptr<const Scan> scan;
  ASSERT_FALSE(take(turn_of(360), Time{5}, scan));
  auto few = turn_of(360);
  few.ranges().resize(5);
  auto still = turn_of(360);
  still.angle_increment(0.0F);
  auto more = turn_of(360);
  more.ranges().resize(400, 1.0F);
  auto span = turn_of(360);
  span.range_max(0.1F);
  auto nan = turn_of(360);
  nan.angle_min(std::nanf(""));
  for (const auto & bad : {few, still, more, span, nan}) {
    const auto refusal = take(bad, Time{9}, scan);
    ASSERT_TRUE(refusal);
    EXPECT_FALSE(refusal->detail.empty());
    EXPECT_EQ(scan->time, Time{5});
  }
}

TEST(ConvertFloor, TellsACorrectionInTheFloorsFrame)
{
  Correction correction;
  correction.time = std::chrono::seconds(1001);
  correction.place = {"landing", {1.0, 2.0}, 1.0, Eigen::Matrix3d::Identity() * 4e-4};
  correction.resets = 3;
  const auto message = to_message(correction, 7);
  EXPECT_STREQ(message.header().frame_id().c_str(), "landing");
  EXPECT_STREQ(message.segment_id().c_str(), "landing");
  EXPECT_EQ(message.header().stamp().sec(), 1001);
  EXPECT_EQ(message.reset_counter(), 3u);
  EXPECT_EQ(message.sequence_number(), 7u);
  EXPECT_DOUBLE_EQ(message.pose().pose().position().y(), 2.0);
  EXPECT_DOUBLE_EQ(message.pose().pose().orientation().z(), std::sin(0.5));
  EXPECT_DOUBLE_EQ(message.pose().covariance()[0], 4e-4);
  EXPECT_DOUBLE_EQ(message.pose().covariance()[35], 4e-4);
  EXPECT_GT(message.pose().covariance()[14], 0.0) << "a variance of z, not a claim of none";
}

TEST(ConvertFloor, TellsACheckOnTheMapAndUnknownAsNan)
{
  CheckReport report;
  report.floor_id = "landing";
  report.told = FloorPlace{"landing", {1.0, 2.0}, 0.0, Eigen::Matrix3d::Identity()};
  report.reason = std::string(500, 'x');
  stetro_site::Floor floor;
  floor.id = "landing";
  floor.pose_in_map = {10.0, 20.0, 2.24, 1.5707963267948966};
  const auto message = to_message(report, &floor);
  EXPECT_STREQ(message.header().frame_id().c_str(), "map");
  EXPECT_NEAR(message.pose().pose().position().x(), 8.0, 1e-9);   // 10 - 2, turned by a quarter
  EXPECT_NEAR(message.pose().pose().position().y(), 21.0, 1e-9);  // 20 + 1
  EXPECT_NEAR(message.pose().pose().position().z(), 2.24, 1e-9);
  EXPECT_TRUE(std::isnan(message.corrected_pose().pose().position().x()));
  EXPECT_TRUE(std::isnan(message.expected_area()));
  EXPECT_EQ(message.verdict(), stetro_msgs::msg::ProfileCheck_Constants::VERDICT_NO_VERDICT);
  EXPECT_EQ(message.reason().size(), 127u);
}

}  // namespace stetro_supervisor
