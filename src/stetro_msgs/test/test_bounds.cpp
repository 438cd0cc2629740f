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

#include "distinct_values.hpp"
#include "payload.hpp"
#include "stetro_msgs/HumbleParticipantEntitiesInfo.hpp"
#include "stetro_msgs/Innovations.hpp"
#include "stetro_msgs/MissionStatus.hpp"
#include "stetro_msgs/RangeArray.hpp"
#include "stetro_msgs/TFMessage.hpp"
#include "stetro_msgs/bounds.hpp"

namespace stetro_msgs
{
namespace
{

TEST(WithinBounds, AcceptsAFullSequenceAndNotOneMore)
{
  msg::RangeArray ranges;
  ranges.readings().resize(16);
  EXPECT_TRUE(within_bounds(ranges));
  ranges.readings().resize(17);
  EXPECT_FALSE(within_bounds(ranges));
}

TEST(WithinBounds, LooksAtEverySequence)
{
  msg::Innovations innovations;
  innovations.biases().resize(32);
  EXPECT_TRUE(within_bounds(innovations));
  innovations.biases().resize(33);
  EXPECT_FALSE(within_bounds(innovations));

  msg::MissionStatus status;
  status.swept_share().resize(257);
  EXPECT_FALSE(within_bounds(status));
}

TEST(WithinBounds, KnowsWhatCameOverTheWire)
{
  msg::RangeArray ranges;
  ranges.readings().resize(17);
  EXPECT_FALSE(within_bounds(from_hex<msg::RangeArray>(to_hex(ranges))));
}

TEST(WithinBounds, LeavesUnboundedSequencesAlone)
{
  tf2_msgs::msg::TFMessage message;
  message.transforms().resize(1000);
  EXPECT_TRUE(within_bounds(message));
}

TEST(FillsAString, TellsAStringThatMayHaveBeenCut)
{
  msg::RangeArray ranges;
  ranges.readings().resize(2);
  ranges.readings()[1].sensor(std::string(31, 'x'));
  EXPECT_FALSE(fills_a_string(ranges));
  ranges.readings()[1].sensor(std::string(33, 'x'));
  EXPECT_EQ(ranges.readings()[1].sensor().size(), 32U) << "fixed_string cuts in silence";
  EXPECT_TRUE(fills_a_string(ranges));
}

TEST(FillsAString, LooksIntoNestedMessages)
{
  rmw_dds_common::msg::humble::ParticipantEntitiesInfo info;
  info.node_entities_info_seq().resize(1);
  EXPECT_FALSE(fills_a_string(info));
  info.node_entities_info_seq()[0].node_name(std::string(256, 'n'));
  EXPECT_TRUE(fills_a_string(info));
}

}  // namespace
}  // namespace stetro_msgs
