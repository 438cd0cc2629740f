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

#include "payload.hpp"
#include "stetro_msgs/HumbleParticipantEntitiesInfo.hpp"
#include "stetro_msgs/IronParticipantEntitiesInfo.hpp"
#include "stetro_msgs/Quaternion.hpp"
#include "stetro_msgs/Range.hpp"
#include "stetro_msgs/RangeReading.hpp"

namespace stetro_msgs
{
namespace
{

// The header and members of a Range as rosidl lays them out in Humble, checked against an
// independent CDR writer: encapsulation, stamp 1 s 2 ns, "tof_0", a byte, a byte of padding.
const char kHumbleRange[] =
  "00010000"
  "0100000002000000"
  "06000000746f665f3000"
  "0100"
  "d7a3f03e8fc2f53c9a99993f0000807f";

sensor_msgs::msg::Range example_range()
{
  sensor_msgs::msg::Range range;
  range.header().stamp().sec(1);
  range.header().stamp().nanosec(2);
  range.header().frame_id("tof_0");
  range.radiation_type(sensor_msgs::msg::Range_Constants::INFRARED);
  range.field_of_view(0.47F);
  range.min_range(0.03F);
  range.max_range(1.2F);
  range.range(std::numeric_limits<float>::infinity());
  return range;
}

TEST(GoldenBytes, RangeIsHumblesWithTheVarianceBehindIt)
{
  auto range = example_range();
  range.variance(0.5F);  // 0x3f000000
  auto hex = to_hex(range);
  hex.replace(2 * 23, 2, "00");  // the byte of padding before the floats may hold anything
  EXPECT_EQ(hex, std::string{kHumbleRange} + "0000003f");
}

TEST(GoldenBytes, RangeWithoutVarianceIsTooShort)
{
  EXPECT_THROW(from_hex<sensor_msgs::msg::Range>(kHumbleRange), std::runtime_error);
  EXPECT_EQ(
    from_hex<sensor_msgs::msg::Range>(std::string{kHumbleRange} + "00000000"), example_range());
}

template <class Info>
Info one_node_with_one_writer()
{
  Info info;
  info.node_entities_info_seq().resize(1);
  info.node_entities_info_seq()[0].node_namespace("/");
  info.node_entities_info_seq()[0].node_name("node_x");
  info.node_entities_info_seq()[0].writer_gid_seq().resize(1);
  return info;
}

TEST(GoldenBytes, ParticipantEntitiesInfoIsAsLongAsItsGids)
{
  // 4 encapsulation, Gid, 4 count, 4+2 "/" and 2 padding, 4+7 "node_x" and 1 padding, 4 readers,
  // 4 writers, Gid: 36 and two Gids.
  const auto humble =
    one_node_with_one_writer<rmw_dds_common::msg::humble::ParticipantEntitiesInfo>();
  EXPECT_EQ(to_hex(humble).size() / 2, 84U);
  const auto iron = one_node_with_one_writer<rmw_dds_common::msg::iron::ParticipantEntitiesInfo>();
  EXPECT_EQ(to_hex(iron).size() / 2, 68U);
}

TEST(GoldenBytes, BothParticipantEntitiesInfoHaveTheNameRos2LooksFor)
{
  const std::string name = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";
  SupportOf<rmw_dds_common::msg::humble::ParticipantEntitiesInfo> humble;
  SupportOf<rmw_dds_common::msg::iron::ParticipantEntitiesInfo> iron;
  EXPECT_EQ(humble.getName(), name);
  EXPECT_EQ(iron.getName(), name);
}

TEST(GoldenBytes, ARangeReadingIsAlignedAsRosidlAlignsIt)
{
  msg::RangeReading reading;
  reading.stamp().sec(1000);
  reading.sensor(msg::RangeReading_Constants::SENSOR_SIDE_LEFT);
  reading.range(0.5);
  reading.standard_deviation(0.25);
  reading.status(msg::RangeReading_Constants::STATUS_VALID);
  auto hex = to_hex(reading);
  hex.replace(2 * 26, 2 * 2, "0000");  // padding
  EXPECT_EQ(
    hex,
    "00010000"
    "e803000000000000"                  // stamp
    "0a000000736964655f6c656674000000"  // "side_left" of 10 bytes, 2 of padding
    "000000000000e03f"
    "000000000000d03f"  // 0.5, 0.25: the second 8 bytes after the origin
    "01");
}

TEST(Defaults, AQuaternionIsTheIdentity)
{
  const geometry_msgs::msg::Quaternion rotation;
  EXPECT_EQ(rotation.w(), 1.0);
  EXPECT_EQ(rotation.x(), 0.0);
}

TEST(Defaults, AKindThatNobodySetIsUnknown)
{
  EXPECT_EQ(msg::RangeReading{}.status(), msg::RangeReading_Constants::STATUS_UNKNOWN);
}

}  // namespace
}  // namespace stetro_msgs
