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

#include "graph.hpp"

#include <algorithm>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "participant.hpp"
#include "stetro_dds/publisher.hpp"
#include "stetro_msgs/HumbleParticipantEntitiesInfo.hpp"
#include "stetro_msgs/IronParticipantEntitiesInfo.hpp"

namespace stetro_dds
{

class Graph::Announcer
{
public:
  virtual ~Announcer() = default;
  virtual void announce(const std::vector<GraphNode> & nodes) = 0;
};

namespace
{

constexpr char kTopic[] = "ros_discovery_info";  // the one topic without a prefix

/// Layout is rmw_dds_common/ParticipantEntitiesInfo of Humble, or of Iron and later.
template <class Info, class NodeInfo, class Gid>
class AnnouncerOf : public Graph::Announcer
{
public:
  AnnouncerOf(Participant & participant, const Guid & own)
  : publisher_(participant, kTopic, kTopic, qos::kDiscoveryInfo)
  {
    message_.gid(gid(own));
  }

  void announce(const std::vector<GraphNode> & nodes) override
  {
    message_.node_entities_info_seq().clear();
    for (const auto & node : nodes) {
      NodeInfo info;
      info.node_namespace(node.name.ns);
      info.node_name(node.name.name);
      info.reader_gid_seq(gids(node.readers));
      info.writer_gid_seq(gids(node.writers));
      message_.node_entities_info_seq().push_back(info);
    }
    publisher_.publish(message_);
  }

private:
  static Gid gid(const Guid & guid)
  {
    Gid result;
    result.data().fill(0);
    std::copy(guid.begin(), guid.end(), result.data().begin());
    return result;
  }

  static std::vector<Gid> gids(const std::vector<Guid> & guids)
  {
    std::vector<Gid> result;
    std::transform(guids.begin(), guids.end(), std::back_inserter(result), gid);
    return result;
  }

  Publisher<Info> publisher_;
  Info message_;
};

namespace humble = rmw_dds_common::msg::humble;
namespace iron = rmw_dds_common::msg::iron;
using HumbleAnnouncer =
  AnnouncerOf<humble::ParticipantEntitiesInfo, humble::NodeEntitiesInfo, humble::Gid>;
using IronAnnouncer = AnnouncerOf<iron::ParticipantEntitiesInfo, iron::NodeEntitiesInfo, iron::Gid>;

}  // namespace

Graph::Graph(Participant & participant, const Guid & participant_guid, RosDistro distro)
{
  if (distro == RosDistro::kHumble) {
    announcer_ = std::make_unique<HumbleAnnouncer>(participant, participant_guid);
  } else {
    announcer_ = std::make_unique<IronAnnouncer>(participant, participant_guid);
  }
}

Graph::~Graph() = default;

void Graph::add_node(const NodeName & name)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto same = [&](const GraphNode & node) { return node.name.full() == name.full(); };
  if (std::any_of(nodes_.begin(), nodes_.end(), same)) {
    throw std::invalid_argument(
      "node '" + name.full() + "': accepted is a name that no other node of the process has");
  }
  nodes_.push_back({name});
  announcer_->announce(nodes_);
}

void Graph::remove_node(const NodeName & name)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto same = [&](const GraphNode & node) { return node.name.full() == name.full(); };
  nodes_.erase(std::remove_if(nodes_.begin(), nodes_.end(), same), nodes_.end());
  announcer_->announce(nodes_);
}

void Graph::add_reader(const NodeName & node, const Guid & guid)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  find(node).readers.push_back(guid);
  announcer_->announce(nodes_);
}

void Graph::add_writer(const NodeName & node, const Guid & guid)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  find(node).writers.push_back(guid);
  announcer_->announce(nodes_);
}

GraphNode & Graph::find(const NodeName & name)
{
  const auto node = std::find_if(nodes_.begin(), nodes_.end(), [&](const GraphNode & candidate) {
    return candidate.name.full() == name.full();
  });
  if (node == nodes_.end()) {
    throw std::logic_error("node '" + name.full() + "' is not in the graph");
  }
  return *node;
}

}  // namespace stetro_dds
