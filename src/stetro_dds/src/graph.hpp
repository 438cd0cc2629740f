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

#ifndef GRAPH_HPP_
#define GRAPH_HPP_

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "stetro_dds/context.hpp"
#include "stetro_dds/endpoint.hpp"
#include "stetro_dds/topic_name.hpp"

namespace stetro_dds
{

class Participant;

/// What the graph says about one node.
struct GraphNode
{
  NodeName name;
  std::vector<Guid> readers{};
  std::vector<Guid> writers{};
};

/// Announces this process's nodes and their endpoints on `ros_discovery_info`.
/**
 * `ros2 node list` and `ros2 node info` live on it. The whole state goes out at every change,
 * under one lock, so that the last message on the wire is the latest state. GIDs have 24 bytes for
 * Humble (8 zeros at the end) and 16 for Iron and Jazzy. The endpoint of this topic is not listed.
 */
class Graph
{
public:
  Graph(Participant & participant, const Guid & participant_guid, RosDistro distro);
  ~Graph();
  Graph(const Graph &) = delete;
  Graph & operator=(const Graph &) = delete;

  /// \throws std::invalid_argument if the process has a node of that name
  void add_node(const NodeName & name);
  void remove_node(const NodeName & name);
  void add_reader(const NodeName & node, const Guid & guid);
  void add_writer(const NodeName & node, const Guid & guid);

  class Announcer;  ///< writes the message in the distribution's layout

private:
  GraphNode & find(const NodeName & name);

  std::mutex mutex_;
  std::vector<GraphNode> nodes_;
  std::unique_ptr<Announcer> announcer_;
};

}  // namespace stetro_dds

#endif  // GRAPH_HPP_
