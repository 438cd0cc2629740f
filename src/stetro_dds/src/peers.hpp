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

#ifndef PEERS_HPP_
#define PEERS_HPP_

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "fastdds/dds/domain/DomainParticipantListener.hpp"
#include "stetro_dds/endpoint.hpp"

namespace stetro_dds
{

/// What discovery tells about an endpoint, as far as it decides about a match.
struct PeerEndpoint
{
  enum class Role { kWriter, kReader };

  Guid guid{};
  Role role = Role::kWriter;
  std::string dds_topic;
  std::string type_name;
  Reliability reliability = Reliability::kReliable;
  Durability durability = Durability::kVolatile;
  // ROS 2 has none of these, so one that does is at odds with us.
  bool deadline = false;    ///< promises (writer) or demands (reader) a sample within some time
  bool liveliness = false;  ///< promises or demands more than the process being alive
  bool exclusive = false;   ///< exclusive ownership
  bool partitioned = false;
  bool keyed = false;
};

/// Why the two never exchange data; nothing if they do.
/**
 * Different type names and keyed against keyless raise no event in the middleware, so the rules of
 * matching are applied here again.
 */
std::optional<std::string> mismatch(const PeerEndpoint & writer, const PeerEndpoint & reader);

/// Every endpoint in the domain, this process's own included.
/** Written by the middleware's threads, read by any. */
class Peers : public eprosima::fastdds::dds::DomainParticipantListener
{
public:
  void add(PeerEndpoint endpoint);
  void remove(const Guid & guid);

  /// Grows with every change, so that nobody has to look without need.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  /// Endpoints of a role on a topic.
  [[nodiscard]] std::vector<PeerEndpoint> on(
    const std::string & dds_topic, PeerEndpoint::Role role) const;

  void on_publisher_discovery(
    eprosima::fastdds::dds::DomainParticipant * participant,
    eprosima::fastrtps::rtps::WriterDiscoveryInfo && found) override;
  void on_subscriber_discovery(
    eprosima::fastdds::dds::DomainParticipant * participant,
    eprosima::fastrtps::rtps::ReaderDiscoveryInfo && found) override;

private:
  mutable std::mutex mutex_;
  std::map<Guid, PeerEndpoint> endpoints_;
  std::atomic<std::uint64_t> revision_{0};
};

/// A middleware GUID as its 16 wire bytes.
Guid to_guid(const eprosima::fastrtps::rtps::GUID_t & guid);

}  // namespace stetro_dds

#endif  // PEERS_HPP_
