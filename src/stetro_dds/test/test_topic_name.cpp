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

#include "stetro_dds/topic_name.hpp"

namespace stetro_dds
{
namespace
{

const NodeName kNode{"/stetro", "driver"};

TEST(TopicName, IsResolvedAsInRos)
{
  EXPECT_EQ(resolve_topic("ranges", kNode), "/stetro/ranges");
  EXPECT_EQ(resolve_topic("imu/data", kNode), "/stetro/imu/data");
  EXPECT_EQ(resolve_topic("~/state", kNode), "/stetro/driver/state");
  EXPECT_EQ(resolve_topic("/tf", kNode), "/tf");
  EXPECT_EQ(resolve_topic("ranges", {"/", "driver"}), "/ranges");
  EXPECT_EQ(resolve_topic("~/state", {"/", "driver"}), "/driver/state");
  EXPECT_EQ(dds_topic_name("/stetro/ranges"), "rt/stetro/ranges");
}

TEST(TopicName, FollowsTheFirstRemappingOfItsResolvedName)
{
  EXPECT_EQ(resolve_topic("scan", kNode, {{"scan", "/lidar/points"}}), "/lidar/points");
  EXPECT_EQ(resolve_topic("scan", kNode, {{"/stetro/scan", "other"}}), "/stetro/other");
  EXPECT_EQ(resolve_topic("scan", kNode, {{"/scan", "other"}}), "/stetro/scan");
  EXPECT_EQ(resolve_topic("scan", kNode, {{"scan", "a"}, {"scan", "b"}}), "/stetro/a");
}

TEST(TopicName, ThatRosWouldNotTakeIsRefusedWithTheRule)
{
  for (const char * bad :
       {"", "/", "a/", "a//b", "1a", "a/2b", "a-b", "a b", "a__b", "~", "~a", "\xc3\xa4", "a{b}"}) {
    EXPECT_THROW(resolve_topic(bad, kNode), NameError) << bad;
  }
  EXPECT_THROW(resolve_topic(std::string(300, 'a'), kNode), NameError);
  EXPECT_NO_THROW(resolve_topic("a_1/_hidden", kNode));
}

TEST(NodeNameRules, AreThoseOfRos)
{
  EXPECT_NO_THROW(validate({"/", "driver"}));
  EXPECT_NO_THROW(validate({"/a/b", "driver_2"}));
  EXPECT_THROW(validate({"", "driver"}), NameError);
  EXPECT_THROW(validate({"stetro", "driver"}), NameError);
  EXPECT_THROW(validate({"/stetro/", "driver"}), NameError);
  EXPECT_THROW(validate({"/", ""}), NameError);
  EXPECT_THROW(validate({"/", "2nd"}), NameError);
  EXPECT_THROW(validate({"/", "a/b"}), NameError);
}

}  // namespace
}  // namespace stetro_dds
