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
#include <chrono>
#include <memory>
#include <random>
#include <string>

#include "stetro_dds/node.hpp"
#include "stetro_msgs/Location.hpp"
#include "stetro_msgs/RangeArray.hpp"
#include "support/raw_publisher.hpp"
#include "support/spin_until.hpp"
#include "support/test_domain.hpp"

namespace stetro_dds
{
namespace
{

using rmf_fleet_msgs::msg::Location;
using std::chrono_literals::operator""s;

constexpr char kLocation[] = "rmf_fleet_msgs::msg::dds_::Location_";

constexpr std::size_t kLevelNameLength = 4 + 28;  // after the header, and all that comes before

/// A well-formed Location: header, 8 bytes of time, 3 floats, the boolean, and the rest zero.
Bytes location(std::uint8_t boolean)
{
  Bytes bytes{0, 1, 0, 0};
  bytes.resize(4 + 8 + 12);
  bytes.push_back(boolean);
  bytes.resize(kLevelNameLength);
  bytes.insert(bytes.end(), {1, 0, 0, 0, 0});  // an empty string
  bytes.resize(4 + 48);
  return bytes;
}

/// Hostile bytes come over the network (false) or through intra-process delivery (true).
class HostilePayloads : public testing::TestWithParam<bool>
{
protected:
  HostilePayloads()
  {
    subscription_ =
      &node_.subscribe<Location>("/hostile", qos::kPose, [this](const Location &) { ++handled_; });
    executor_.add(node_);
  }

  /// A volatile sample written before the writer knows the reader reaches nobody.
  bool both_sides_matched()
  {
    return node_.wait_matched({"/hostile"}, 5s) &&
           attackers_context_.wait_for([this] { return attacker_.matched() > 0; }, 5s);
  }

  /// Sends one sample, reliably, and waits until it has been taken.
  void send(const Bytes & bytes)
  {
    const auto before = subscription_->counts().received();
    ASSERT_TRUE(attacker_.publish(bytes));
    ASSERT_TRUE(spin_until(
      executor_, [&] { return subscription_->counts().received() > before; }, 5s))
      << bytes.size() << " bytes";
  }

  Context victims_context_{test_options(GetParam())};
  Context attackers_context_{test_options(GetParam())};
  Node node_{victims_context_, {"victim"}};
  Executor executor_;
  int handled_ = 0;
  Subscription<Location> * subscription_ = nullptr;
  RawPublisher attacker_{attackers_context_, "/hostile", kLocation, qos::kPose};
};

TEST_P(HostilePayloads, AreDroppedCountedAndForgotten)
{
  ASSERT_TRUE(both_sides_matched());
  send(location(1));
  EXPECT_EQ(handled_, 1) << "the well-formed one";

  std::uint64_t malformed = 0;
  Bytes encapsulation = location(1);
  encapsulation[1] = 9;
  Bytes truncated = location(1);
  truncated.resize(20);
  Bytes endless = location(1);
  std::fill_n(endless.begin() + kLevelNameLength, 4, 0xff);
  for (const Bytes & bytes : {location(2), encapsulation, truncated, endless, Bytes{0, 1, 0, 0}}) {
    send(bytes);
    EXPECT_EQ(subscription_->counts().malformed, ++malformed) << bytes.size() << " bytes";
  }
  send(location(0));
  EXPECT_EQ(handled_, 2) << "and life goes on";
}

TEST_P(HostilePayloads, OfRandomBytesDoNoHarm)
{
  ASSERT_TRUE(both_sides_matched());
  std::mt19937 random{7};
  for (int i = 0; i < 500; ++i) {
    Bytes bytes(4 + random() % 200);
    for (auto & byte : bytes) {
      byte = static_cast<std::uint8_t>(random());
    }
    bytes[0] = 0;
    bytes[1] = 1;
    send(bytes);
  }
  const auto counts = subscription_->counts();
  EXPECT_EQ(counts.received(), 500U);
  EXPECT_GT(counts.malformed, 0U);
}

INSTANTIATE_TEST_SUITE_P(NetworkAndIntraProcess, HostilePayloads, testing::Bool());

}  // namespace
}  // namespace stetro_dds
