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

// What ROS 2 would see of the running robot, told by another vendor's discovery.

#include <HumbleParticipantEntitiesInfo.h>
#include <IronParticipantEntitiesInfo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "cyclone/known_topics.hpp"
#include "cyclone/peer.hpp"
#include "integration/simulated_time.hpp"

namespace stetro_tests
{

using cyclone::Guid;
using cyclone::SeenEndpoint;

constexpr const char * kDiscovery = "ros_discovery_info";
constexpr const char * kEntitiesInfo = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";
constexpr cyclone::Quality kLatched{true, true, 100};

/// One node as ros_discovery_info lists it.
struct ListedNode
{
  std::string name;  ///< with its namespace
  std::vector<Guid> readers;
  std::vector<Guid> writers;
};

/// What a GID of this distribution's size says; the bytes behind the GUID must be zero.
template <class Gid>
Guid guid_of(const Gid & gid)
{
  Guid guid{};
  std::copy_n(gid.data, guid.size(), guid.begin());
  EXPECT_TRUE(std::all_of(gid.data + 16, std::end(gid.data), [](auto byte) { return byte == 0; }));
  return guid;
}

template <class Sequence>
std::vector<Guid> guids_of(const Sequence & gids)
{
  std::vector<Guid> result;
  for (std::uint32_t i = 0; i < gids._length; ++i) {
    result.push_back(guid_of(gids._buffer[i]));
  }
  return result;
}

template <class Info>
std::vector<ListedNode> nodes_of(const Info & info)
{
  std::vector<ListedNode> result;
  for (std::uint32_t i = 0; i < info.node_entities_info_seq._length; ++i) {
    const auto & node = info.node_entities_info_seq._buffer[i];
    result.push_back(
      {std::string(node.node_namespace) + "/" + node.node_name, guids_of(node.reader_gid_seq),
       guids_of(node.writer_gid_seq)});
  }
  return result;
}

/// A running robot of one distribution's style, and what another vendor discovers of it.
class RosGraph : public testing::Test
{
protected:
  void start(const std::string & distro)
  {
    StackOptions options;
    options.ros_distro = distro;
    stack_ = std::make_unique<Stack>(domain_, options);
    theirs_ = std::make_unique<cyclone::Peer>(domain_.id());
    // The slowest to appear; each endpoint is announced to whoever knows its participant.
    ASSERT_TRUE(poll_until([this] { return complete(); }, 20s)) << stack_->tails();
  }

  bool complete() const
  {
    const auto publications = theirs_->publications();
    const auto & topics = cyclone::published_topics();
    return theirs_->participants().size() == 3 &&
           std::all_of(topics.begin(), topics.end(), [&](const auto & topic) {
             return std::any_of(publications.begin(), publications.end(), [&](const auto & seen) {
               return seen.topic == topic.dds_name();
             });
           });
  }

  /// Reads the latest ros_discovery_info of each of the three participants.
  template <class Info>
  std::map<Guid, std::vector<ListedNode>> listed(const dds_topic_descriptor_t & type)
  {
    std::map<Guid, std::vector<ListedNode>> result;
    cyclone::Reader<Info> reader(
      *theirs_, cyclone::renamed(type, kEntitiesInfo), kDiscovery, kLatched);
    reader.wait_for(
      [&](const Info & info) {
        result[guid_of(info.gid)] = nodes_of(info);
        return result.size() == 3 && everything_listed(result);
      },
      10s);
    return result;
  }

  bool everything_listed(const std::map<Guid, std::vector<ListedNode>> & graph) const
  {
    std::size_t count = 0;
    for (const auto & [participant, nodes] : graph) {
      for (const auto & node : nodes) {
        count += node.readers.size() + node.writers.size();
      }
    }
    return count >= ros_endpoints(theirs_->publications()).size() +
                      ros_endpoints(theirs_->subscriptions()).size();
  }

  static std::vector<SeenEndpoint> ros_endpoints(std::vector<SeenEndpoint> endpoints)
  {
    endpoints.erase(
      std::remove_if(
        endpoints.begin(), endpoints.end(), [](const auto & e) { return e.topic == kDiscovery; }),
      endpoints.end());
    return endpoints;
  }

  void expect_listed_once(
    const std::vector<SeenEndpoint> & endpoints, std::vector<Guid> ListedNode::*which,
    const std::map<Guid, std::vector<ListedNode>> & graph)
  {
    std::map<Guid, std::set<std::string>> times;
    std::map<Guid, int> count;
    for (const auto & [participant, nodes] : graph) {
      for (const auto & node : nodes) {
        for (const Guid & guid : node.*which) {
          times[guid].insert(node.name);
          ++count[guid];
        }
      }
    }
    for (const auto & endpoint : ros_endpoints(endpoints)) {
      EXPECT_EQ(count[endpoint.guid], 1) << endpoint.topic;
    }
    EXPECT_EQ(count.size(), ros_endpoints(endpoints).size()) << "listed, but not there";
    expect_right_node(endpoints, times);
  }

  static void expect_right_node(
    const std::vector<SeenEndpoint> & endpoints,
    const std::map<Guid, std::set<std::string>> & nodes_of_endpoint)
  {
    for (const auto & topic : cyclone::published_topics()) {
      for (const auto & endpoint : endpoints) {
        const bool writer = endpoint.guid.back() == 0x03;
        if (writer && endpoint.topic == topic.dds_name() && !topic.node.empty()) {
          const auto found = nodes_of_endpoint.find(endpoint.guid);
          ASSERT_NE(found, nodes_of_endpoint.end()) << topic.name;
          EXPECT_EQ(*found->second.begin(), "/stetro/" + topic.node) << topic.name;
        }
      }
    }
  }

  LoopbackDomain domain_;
  std::unique_ptr<Stack> stack_;
  std::unique_ptr<cyclone::Peer> theirs_;
};

TEST_F(RosGraph, ParticipantsAndEndpointsLookLikeRos2)
{
  start("");
  for (const auto & participant : theirs_->participants()) {
    EXPECT_EQ(participant.user_data.rfind("enclave=/;", 0), 0U) << participant.user_data;
  }
  const std::regex type_name("[a-z0-9_]+::msg::dds_::[A-Za-z]+_");
  auto all = theirs_->publications();
  const auto readers = theirs_->subscriptions();
  const std::size_t writers = all.size();
  all.insert(all.end(), readers.begin(), readers.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const SeenEndpoint & endpoint = all[i];
    EXPECT_TRUE(endpoint.topic.rfind("rt/", 0) == 0 || endpoint.topic == kDiscovery)
      << endpoint.topic;
    EXPECT_TRUE(std::regex_match(endpoint.type, type_name)) << endpoint.type;
    EXPECT_EQ(endpoint.guid.back(), i < writers ? 0x03 : 0x04) << endpoint.topic << " has a key";
    EXPECT_TRUE(endpoint.partitions.empty()) << endpoint.topic;
    EXPECT_TRUE(endpoint.plain_cdr) << endpoint.topic;
    EXPECT_FALSE(endpoint.user_data.empty()) << endpoint.topic;
  }
}

TEST_F(RosGraph, WritersOfferWhatTheTableOfTheWireSays)
{
  start("");
  for (const auto & topic : cyclone::published_topics()) {
    int count = 0;
    for (const auto & endpoint : theirs_->publications()) {
      if (endpoint.topic == topic.dds_name()) {
        ++count;
        EXPECT_EQ(endpoint.type, topic.type->m_typename) << topic.name;
        EXPECT_TRUE(endpoint.reliable) << topic.name;
        EXPECT_EQ(endpoint.transient_local, topic.latched) << topic.name;
      }
    }
    if (!topic.node.empty()) {
      EXPECT_EQ(count, 1) << topic.name;
    }
  }
}

TEST_F(RosGraph, DiscoveryInfoWithHumblesGidsListsEachEndpointOnce)
{
  start("humble");
  const auto graph = listed<rmw_dds_common_msg_humble_dds__ParticipantEntitiesInfo_>(
    rmw_dds_common_msg_humble_dds__ParticipantEntitiesInfo__desc);
  ASSERT_EQ(graph.size(), 3U);
  expect_listed_once(theirs_->publications(), &ListedNode::writers, graph);
  expect_listed_once(theirs_->subscriptions(), &ListedNode::readers, graph);
}

TEST_F(RosGraph, DiscoveryInfoWithIronsGidsListsEachEndpointOnce)
{
  start("jazzy");
  const auto graph = listed<rmw_dds_common_msg_iron_dds__ParticipantEntitiesInfo_>(
    rmw_dds_common_msg_iron_dds__ParticipantEntitiesInfo__desc);
  ASSERT_EQ(graph.size(), 3U);
  expect_listed_once(theirs_->publications(), &ListedNode::writers, graph);
  expect_listed_once(theirs_->subscriptions(), &ListedNode::readers, graph);
}

}  // namespace stetro_tests
