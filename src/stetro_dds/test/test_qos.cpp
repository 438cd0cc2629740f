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
#include <string_view>

#include "dds_qos.hpp"
#include "peers.hpp"
#include "stetro_dds/guarded_type.hpp"
#include "stetro_dds/qos.hpp"
#include "stetro_msgs/all_messages.hpp"

namespace stetro_dds
{
namespace
{

namespace dds = eprosima::fastdds::dds;

PeerEndpoint peer(const EndpointQos & qos, PeerEndpoint::Role role)
{
  PeerEndpoint endpoint;
  endpoint.role = role;
  endpoint.reliability = qos.reliability;
  endpoint.durability = qos.durability;
  return endpoint;
}

TEST(QosTable, HasNoTwoProfilesOfOneName)
{
  std::set<std::string_view> names;
  for (const auto & profile : qos::table()) {
    EXPECT_TRUE(names.insert(profile.name).second) << profile.name;
    EXPECT_FALSE(profile.used_for.empty()) << profile.name;
  }
}

TEST(QosTable, WritersMatchOurReadersAndEveryVolatileOne)
{
  for (const auto & profile : qos::table()) {
    const auto writer = peer(profile.offered, PeerEndpoint::Role::kWriter);
    for (const auto & requested : {profile.requested, qos::reliable(1), qos::best_effort(1)}) {
      EXPECT_FALSE(mismatch(writer, peer(requested, PeerEndpoint::Role::kReader))) << profile.name;
    }
  }
}

TEST(QosTable, SensorReadersTakeBestEffortWriters)
{
  const auto writer = peer(qos::best_effort(5), PeerEndpoint::Role::kWriter);
  EXPECT_FALSE(mismatch(writer, peer(qos::kSensor.requested, PeerEndpoint::Role::kReader)));
  EXPECT_FALSE(mismatch(writer, peer(qos::kClock.requested, PeerEndpoint::Role::kReader)));
}

TEST(QosTable, LatchedProfilesKeepTheirLastSample)
{
  for (const auto & profile : {qos::kContacts, qos::kLatched, qos::kTfStatic}) {
    EXPECT_EQ(profile.offered.durability, Durability::kTransientLocal) << profile.name;
    EXPECT_EQ(profile.requested.durability, Durability::kTransientLocal) << profile.name;
  }
}

TEST(QosTable, ReachesTheMiddlewareUnchanged)
{
  const GuardedType<std_msgs::msg::String> type;
  for (const auto & profile : qos::table()) {
    const auto writer = writer_qos(profile, type);
    const auto reader = reader_qos(profile, type);
    const bool reliable = profile.offered.reliability == Reliability::kReliable;
    EXPECT_EQ(writer.reliability().kind == dds::RELIABLE_RELIABILITY_QOS, reliable);
    EXPECT_EQ(writer.history().depth, profile.offered.depth);
    EXPECT_EQ(reader.history().depth, profile.requested.depth);
    EXPECT_EQ(writer.history().kind, dds::KEEP_LAST_HISTORY_QOS);
    EXPECT_EQ(reader.history().kind, dds::KEEP_LAST_HISTORY_QOS);
    EXPECT_EQ(writer.data_sharing().kind(), dds::OFF);
    EXPECT_EQ(reader.data_sharing().kind(), dds::OFF);
    EXPECT_GT(writer.user_data().size(), 0U);
    const auto heartbeat = writer.reliable_writer_qos().times.heartbeatPeriod.to_ns();
    EXPECT_EQ(heartbeat, std::chrono::nanoseconds(profile.heartbeat).count());
    EXPECT_GE(profile.heartbeat.count(), 20);
    EXPECT_LE(profile.heartbeat.count(), 100);
  }
}

TEST(MessageTypes, AreKeyless)
{
  stetro_msgs::for_each_message_type([](const char * file, auto type) {
    using Message = typename decltype(type)::type;
    const GuardedType<Message> guarded;
    EXPECT_FALSE(guarded.m_isGetKeyDefined) << file << ": a keyed type never meets ROS 2";
  });
}

}  // namespace
}  // namespace stetro_dds
