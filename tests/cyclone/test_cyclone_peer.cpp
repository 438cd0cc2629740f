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

#include <StairPose.h>
#include <gtest/gtest.h>

#include <cstring>

#include "cyclone/peer.hpp"
#include "stetro_dds/qos.hpp"
#include "stetro_msgs/StairPose.hpp"
#include "stetro_tests/observer.hpp"

namespace stetro_tests
{

using CycloneStairPose = stetro_msgs_msg_dds__StairPose_;
constexpr cyclone::Quality kLatched{true, true, 1};

class TwoVendors : public testing::Test
{
protected:
  LoopbackDomain domain_;
  Observer ours_{domain_};
};

TEST_F(TwoVendors, ALateJoinerGetsALatchedSample)
{
  auto & pose =
    ours_.publisher<stetro_msgs::msg::StairPose>("stair_pose", stetro_dds::qos::kLatched);
  ours_.start();
  stetro_msgs::msg::StairPose message;
  message.segment_id("stairs");
  message.step_index(7);
  message.block_heights({0.98, 0.84, 0.84});
  ASSERT_TRUE(pose.publish(message));

  cyclone::Peer theirs(domain_.id());
  cyclone::Reader<CycloneStairPose> reader(
    theirs, stetro_msgs_msg_dds__StairPose__desc, "rt/stetro/stair_pose", kLatched);
  EXPECT_TRUE(reader.wait_for(
    [](const CycloneStairPose & seen) {
      return std::strcmp(seen.segment_id, "stairs") == 0 && seen.step_index == 7 &&
             seen.block_heights[0] == 0.98;
    },
    10s));
}

TEST_F(TwoVendors, SamplesGoTheOtherWayToo)
{
  auto & pose = ours_.probe<stetro_msgs::msg::StairPose>("stair_pose", stetro_dds::qos::kLatched);
  ours_.start();
  cyclone::Peer theirs(domain_.id());
  cyclone::Writer<CycloneStairPose> writer(
    theirs, stetro_msgs_msg_dds__StairPose__desc, "rt/stetro/stair_pose", kLatched);
  CycloneStairPose message{};
  char frame[] = "stairs";
  message.header.frame_id = frame;
  message.step_index = -1;
  message.reset_delta_heading = 0.5;
  ASSERT_TRUE(poll_until([&] { return writer.matched() > 0; }, 10s));
  ASSERT_TRUE(writer.write(message));

  const auto seen = pose.wait_next(10s);
  ASSERT_TRUE(seen) << pose.tail();
  EXPECT_EQ(seen->header().frame_id(), "stairs");
  EXPECT_EQ(seen->step_index(), -1);
  EXPECT_EQ(seen->reset_delta_heading(), 0.5);
}

}  // namespace stetro_tests
