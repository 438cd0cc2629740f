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

#include <set>
#include <string>

#include "distinct_values.hpp"
#include "payload.hpp"
#include "stetro_msgs/all_messages.hpp"

namespace stetro_msgs
{
namespace
{

TEST(EveryMessage, SurvivesTheWire)
{
  for_each_message_type([](const char * file, auto type) {
    using Message = typename decltype(type)::type;
    const auto sent = DistinctValues{}.make<Message>();
    ASSERT_NE(sent, Message{}) << file;
    EXPECT_EQ(from_hex<Message>(to_hex(sent)), sent) << file;
  });
}

TEST(EveryMessage, IsRefusedWhenItsLastByteIsMissing)
{
  for_each_message_type([](const char * file, auto type) {
    using Message = typename decltype(type)::type;
    auto hex = to_hex(DistinctValues{}.make<Message>());
    hex.resize(hex.size() - 2);
    EXPECT_THROW(from_hex<Message>(hex), std::runtime_error) << file;
  });
}

TEST(EveryMessage, HasNoKey)  // a keyed endpoint never matches one of ROS 2
{
  for_each_message_type([](const char * file, auto type) {
    EXPECT_FALSE(SupportOf<typename decltype(type)::type>{}.m_isGetKeyDefined) << file;
  });
}

TEST(EveryMessage, HasTheNameRos2LooksFor)
{
  std::set<std::string> names;
  for_each_message_type([&names](const char *, auto type) {
    names.insert(SupportOf<typename decltype(type)::type>{}.getName());
  });
  std::set<std::string> expected;
  const auto expect = [&expected](
                        const std::string & package, const std::set<std::string> & types) {
    for (const auto & type : types) {
      expected.insert(std::string{package}.append("::msg::dds_::").append(type).append("_"));
    }
  };
  expect("builtin_interfaces", {"Duration", "Time"});
  expect("std_msgs", {"Header", "String"});
  expect("rosgraph_msgs", {"Clock"});
  expect(
    "geometry_msgs",
    {"Point", "Pose", "PoseStamped", "PoseWithCovariance", "PoseWithCovarianceStamped",
     "Quaternion", "Transform", "TransformStamped", "Twist", "TwistWithCovariance", "Vector3"});
  expect("sensor_msgs", {"Imu", "LaserScan", "Range"});
  expect("nav_msgs", {"Odometry"});
  expect("tf2_msgs", {"TFMessage"});
  expect("diagnostic_msgs", {"DiagnosticArray", "DiagnosticStatus", "KeyValue"});
  expect("rmf_fleet_msgs", {"FleetState", "Location", "RobotMode", "RobotState"});
  expect("rmw_dds_common", {"Gid", "NodeEntitiesInfo", "ParticipantEntitiesInfo"});
  expect(
    "stetro_msgs",
    {"BiasEstimate", "BlockState", "BlockStates", "Command", "CommandStatus", "ContactState",
     "Contacts", "Innovation", "Innovations", "MissionRequest", "MissionStatus", "PoseCorrection",
     "ProfileCheck", "RangeArray", "RangeReading", "StairPose"});
  EXPECT_EQ(names, expected);
}

}  // namespace
}  // namespace stetro_msgs
