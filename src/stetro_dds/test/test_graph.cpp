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
#include <optional>
#include <string>
#include <vector>

#include "participant.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_msgs/HumbleParticipantEntitiesInfo.hpp"
#include "stetro_msgs/IronParticipantEntitiesInfo.hpp"
#include "stetro_msgs/String.hpp"
#include "support/test_domain.hpp"

namespace stetro_dds
{
namespace
{

using std::chrono_literals::operator""s;
using std_msgs::msg::String;
namespace humble = rmw_dds_common::msg::humble;
namespace iron = rmw_dds_common::msg::iron;

ContextOptions options_for(RosDistro distro)
{
  auto options = test_options();
  options.distro = distro;
  return options;
}

/// What ROS 2's graph cache would hold of another process, seen from this one.
template <class Info>
class GraphReader
{
public:
  explicit GraphReader(RosDistro distro) : context_(options_for(distro)) {}

  /// Reads until the last message satisfies. \return it, or nothing if the time is up
  template <class Condition>
  std::optional<Info> wait_for(const Condition & condition)
  {
    const auto deadline = Clock::steady_now() + 10s;
    while (Clock::steady_now() < deadline) {
      subscription_.take(100);
      if (last_ && condition(*last_)) {
        return last_;
      }
    }
    return std::nullopt;
  }

private:
  Context context_;
  std::optional<Info> last_;
  Subscription<Info> subscription_{
    context_.participant(), "ros_discovery_info", "ros_discovery_info", qos::kDiscoveryInfo,
    make_handler<Info>([this](const Info & info) {
      if (!info.node_entities_info_seq().empty()) {  // our own participant has no nodes
        last_ = info;
      }
    })};
};

template <class Gid>
bool holds(const Gid & gid, const Guid & guid)
{
  return std::equal(guid.begin(), guid.end(), gid.data().begin()) &&
         std::all_of(
           gid.data().begin() + 16, gid.data().end(), [](auto byte) { return byte == 0; });
}

template <class Info>
void announces_nodes_and_endpoints(RosDistro distro)
{
  GraphReader<Info> reader(distro);
  Context context(options_for(distro));
  Node talker(context, {"talker", "/robot1"});
  auto & words = talker.advertise<String>("words", qos::kPose);
  std::optional<Node> listener(std::in_place, context, NodeOptions{"listener", "/"});
  auto & heard = listener->subscribe<String>("words", qos::kPose, [](const String &) {});

  const auto info = reader.wait_for([](const Info & last) {
    const auto & nodes = last.node_entities_info_seq();
    return nodes.size() == 2 && nodes[1].reader_gid_seq().size() == 1;
  });
  ASSERT_TRUE(info);
  const auto & nodes = info->node_entities_info_seq();
  EXPECT_EQ(nodes[0].node_namespace(), "/robot1");
  EXPECT_EQ(nodes[0].node_name(), "talker");
  EXPECT_TRUE(nodes[0].reader_gid_seq().empty());
  ASSERT_EQ(nodes[0].writer_gid_seq().size(), 2U) << "/diagnostics and words, not the graph itself";
  EXPECT_TRUE(holds(nodes[0].writer_gid_seq()[1], words.guid()));
  EXPECT_EQ(nodes[1].node_namespace(), "/");
  EXPECT_EQ(nodes[1].node_name(), "listener");
  EXPECT_TRUE(holds(nodes[1].reader_gid_seq()[0], heard.guid()));
  auto participant = words.guid();
  const Guid entity{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0xc1};
  std::copy(entity.begin() + 12, entity.end(), participant.begin() + 12);
  EXPECT_TRUE(holds(info->gid(), participant));

  listener.reset();
  EXPECT_TRUE(
    reader.wait_for([](const Info & last) { return last.node_entities_info_seq().size() == 1; }))
    << "a node that left";
}

TEST(Graph, AnnouncesNodesToHumbleWith24ByteIds)
{
  EXPECT_EQ(humble::Gid{}.data().size(), 24U);
  announces_nodes_and_endpoints<humble::ParticipantEntitiesInfo>(RosDistro::kHumble);
}

TEST(Graph, AnnouncesNodesToIronAndLaterWith16ByteIds)
{
  EXPECT_EQ(iron::Gid{}.data().size(), 16U);
  announces_nodes_and_endpoints<iron::ParticipantEntitiesInfo>(RosDistro::kIron);
  announces_nodes_and_endpoints<iron::ParticipantEntitiesInfo>(RosDistro::kJazzy);
}

TEST(Graph, TakesOneNodeOfAName)
{
  Context context(test_options());
  const Node first(context, {"twin", "/a"});
  EXPECT_THROW(Node(context, {"twin", "/a"}), std::invalid_argument);
  EXPECT_NO_THROW(Node(context, {"twin", "/b"}));
}

}  // namespace
}  // namespace stetro_dds
