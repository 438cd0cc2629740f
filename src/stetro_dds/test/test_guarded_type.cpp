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

#include <algorithm>
#include <random>
#include <vector>

#include "stetro_dds/guarded_type.hpp"
#include "stetro_msgs/FleetState.hpp"
#include "stetro_msgs/RangeArray.hpp"
#include "stetro_msgs/all_messages.hpp"

namespace stetro_dds
{
namespace
{

using eprosima::fastrtps::rtps::SerializedPayload_t;

template <class Message>
std::vector<std::uint8_t> bytes_of(const Message & message)
{
  GuardedType<Message> type;
  auto * untyped = const_cast<Message *>(&message);
  SerializedPayload_t payload(type.getSerializedSizeProvider(untyped)());
  EXPECT_TRUE(type.serialize(untyped, &payload));
  return {payload.data, payload.data + payload.length};
}

template <class Message>
bool accepts(const std::vector<std::uint8_t> & bytes, Message * into = nullptr)
{
  GuardedType<Message> type;
  Message message;
  SerializedPayload_t payload(static_cast<std::uint32_t>(std::max<std::size_t>(bytes.size(), 1)));
  std::copy(bytes.begin(), bytes.end(), payload.data);
  payload.length = static_cast<std::uint32_t>(bytes.size());
  return type.deserialize(&payload, into != nullptr ? into : &message);
}

TEST(GuardedType, ReadsBackWhatItWrote)
{
  rmf_fleet_msgs::msg::Location there;
  there.x(1.5F);
  there.level_name("L1");
  rmf_fleet_msgs::msg::Location back;
  EXPECT_TRUE(accepts(bytes_of(there), &back));
  EXPECT_EQ(back.x(), 1.5F);
  EXPECT_EQ(back.level_name(), "L1");
}

TEST(GuardedType, DropsABooleanThatIsNone)
{
  rmf_fleet_msgs::msg::Location message;
  message.obey_approach_speed_limit(true);
  auto bytes = bytes_of(message);
  const auto flag = std::find(bytes.begin() + 4, bytes.end(), 1);  // the only 1 after the header
  ASSERT_NE(flag, bytes.end());
  EXPECT_TRUE(accepts<rmf_fleet_msgs::msg::Location>(bytes));
  *flag = 2;
  const auto before = detail::malformed_on_this_thread();
  EXPECT_FALSE(accepts<rmf_fleet_msgs::msg::Location>(bytes));
  EXPECT_EQ(detail::malformed_on_this_thread(), before + 1);
}

TEST(GuardedType, DropsEveryEncapsulationButPlainCdr)
{
  auto bytes = bytes_of(std_msgs::msg::String{});
  for (int first = 0; first < 256; ++first) {
    for (int second = 0; second < 256; ++second) {
      bytes[0] = static_cast<std::uint8_t>(first);
      bytes[1] = static_cast<std::uint8_t>(second);
      const bool accepted = accepts<std_msgs::msg::String>(bytes);
      if (first != 0 || second > 1) {
        ASSERT_FALSE(accepted) << first << " " << second;
      }
    }
  }
}

TEST(GuardedType, DropsASequenceBeyondItsBound)
{
  stetro_msgs::msg::RangeArray message;
  ASSERT_TRUE(accepts<stetro_msgs::msg::RangeArray>(bytes_of(message)));
  message.readings().resize(1000);
  ASSERT_FALSE(stetro_msgs::within_bounds(message)) << "the bound is smaller than this test thinks";
  EXPECT_FALSE(accepts<stetro_msgs::msg::RangeArray>(bytes_of(message)));
}

TEST(GuardedType, DropsEveryTruncation)
{
  stetro_msgs::for_each_message_type([](const char * file, auto type) {
    using Message = typename decltype(type)::type;
    auto bytes = bytes_of(Message{});
    while (bytes.size() > 5) {  // the last member may be padding's neighbour: stop at one byte
      bytes.resize(bytes.size() - 1);
      EXPECT_FALSE(accepts<Message>(bytes)) << file << " at " << bytes.size();
    }
  });
}

// Property: whatever the bytes, decoding returns.
TEST(GuardedType, SurvivesRandomBytesAndDamagedMessages)
{
  std::mt19937 random{20261122};
  std::uniform_int_distribution<int> byte{0, 255};
  stetro_msgs::for_each_message_type([&](const char * /*file*/, auto type) {
    using Message = typename decltype(type)::type;
    const auto good = bytes_of(Message{});
    for (int i = 0; i < 300; ++i) {
      std::vector<std::uint8_t> noise(static_cast<std::size_t>(byte(random)));
      std::generate(
        noise.begin(), noise.end(), [&] { return static_cast<std::uint8_t>(byte(random)); });
      if (noise.size() > 4) {
        noise[0] = 0;
        noise[1] = 1;  // past the first check
      }
      accepts<Message>(noise);
      auto damaged = good;
      damaged[random() % damaged.size()] = static_cast<std::uint8_t>(byte(random));
      accepts<Message>(damaged);
    }
  });
}

}  // namespace
}  // namespace stetro_dds
