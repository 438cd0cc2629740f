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

#include "stetro_dds/qos.hpp"
#include "stetro_msgs/BlockStates.hpp"
#include "stetro_tests/observer.hpp"
#include "stetro_tests/raw_message.hpp"

namespace stetro_tests
{

using stetro_msgs::msg::BlockStates;

// Bytes written raw arrive as the message they spell; a boolean byte of 2 does not arrive.
TEST(RawMessage, ArrivesAsItsBytesSpell)
{
  const LoopbackDomain domain;
  Observer ears(domain, "ears");
  auto & blocks = ears.probe<BlockStates>("blocks", stetro_dds::qos::kSensor);
  ears.start();
  Observer hostile(domain, "hostile");
  auto & writer = hostile.publisher<Raw<BlockStates>>("blocks", stetro_dds::qos::kSensor);
  hostile.start();
  // Both sides: a best-effort reader that has not met the writer yet never hears what it wrote.
  ASSERT_TRUE(hostile.wait_matched(10s).empty());
  ASSERT_TRUE(ears.wait_matched(10s).empty());

  BlockStates message;
  message.steering_angle(0.25);
  message.steering_moving(true);
  Bytes bytes = bytes_of(message);
  ASSERT_EQ(bytes.back(), 1) << "steering_moving is the last byte";
  bytes.back() = 2;
  ASSERT_TRUE(writer.publish({bytes}));
  bytes.back() = 1;
  ASSERT_TRUE(writer.publish({bytes}));

  const auto arrived = blocks.wait_next(10s);
  ASSERT_TRUE(arrived) << blocks.tail();
  EXPECT_EQ(arrived->steering_angle(), 0.25);
  EXPECT_TRUE(arrived->steering_moving());
  EXPECT_EQ(blocks.count(), 1U) << "the one with the impossible boolean is dropped";
}

}  // namespace stetro_tests
