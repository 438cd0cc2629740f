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

#include "peers.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stetro_dds
{

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

namespace
{

constexpr std::size_t kMostRemembered = 4096;  // endpoints; a runaway peer may not grow us

template <class Proxy>
PeerEndpoint endpoint_of(const Proxy & proxy, PeerEndpoint::Role role)
{
  const auto & qos = proxy.m_qos;
  PeerEndpoint endpoint;
  endpoint.guid = to_guid(proxy.guid());
  endpoint.role = role;
  endpoint.dds_topic = proxy.topicName().to_string();
  endpoint.type_name = proxy.typeName().to_string();
  endpoint.reliability = qos.m_reliability.kind == dds::RELIABLE_RELIABILITY_QOS
                           ? Reliability::kReliable
                           : Reliability::kBestEffort;
  endpoint.durability = qos.m_durability.kind == dds::VOLATILE_DURABILITY_QOS
                          ? Durability::kVolatile
                          : Durability::kTransientLocal;
  endpoint.deadline = qos.m_deadline.period != eprosima::fastrtps::c_TimeInfinite;
  endpoint.liveliness = qos.m_liveliness.kind != dds::AUTOMATIC_LIVELINESS_QOS ||
                        qos.m_liveliness.lease_duration != eprosima::fastrtps::c_TimeInfinite;
  endpoint.exclusive = qos.m_ownership.kind == dds::EXCLUSIVE_OWNERSHIP_QOS;
  endpoint.partitioned = !qos.m_partition.empty();
  endpoint.keyed = proxy.topicKind() == rtps::WITH_KEY;
  return endpoint;
}

}  // namespace

Guid to_guid(const rtps::GUID_t & guid)
{
  Guid bytes{};
  const auto prefix_end =
    std::copy_n(guid.guidPrefix.value, rtps::GuidPrefix_t::size, bytes.begin());
  std::copy_n(guid.entityId.value, rtps::EntityId_t::size, prefix_end);
  return bytes;
}

std::string to_string(const Guid & guid)
{
  std::string text;
  for (std::size_t i = 0; i < guid.size(); ++i) {
    if (i == 4 || i == 8) {
      text += '.';
    } else if (i == 12) {
      text += '|';
    }
    std::array<char, 3> hex{};
    std::snprintf(hex.data(), hex.size(), "%02x", guid[i]);
    text += hex.data();
  }
  return text;
}

std::optional<std::string> mismatch(const PeerEndpoint & writer, const PeerEndpoint & reader)
{
  if (writer.type_name != reader.type_name) {
    return "type: '" + writer.type_name + "' is written, '" + reader.type_name + "' is read";
  }
  if (writer.keyed != reader.keyed) {
    return std::string("key: the ") + (writer.keyed ? "written" : "read") + " type has one";
  }
  if (
    writer.reliability == Reliability::kBestEffort &&
    reader.reliability == Reliability::kReliable) {
    return "reliability: best effort is offered, reliable is requested";
  }
  if (
    writer.durability == Durability::kVolatile &&
    reader.durability == Durability::kTransientLocal) {
    return "durability: volatile is offered, transient local is requested";
  }
  if (reader.deadline && !writer.deadline) {
    return "deadline: none is offered, one is requested";
  }
  if (reader.liveliness && !writer.liveliness) {
    return "liveliness: automatic without a lease is offered, more is requested";
  }
  if (writer.exclusive != reader.exclusive) {
    return std::string("ownership: the ") + (writer.exclusive ? "writer" : "reader") +
           " wants it exclusive";
  }
  if (writer.partitioned != reader.partitioned) {
    return std::string("partition: the ") + (writer.partitioned ? "writer" : "reader") +
           " is in one";
  }
  return std::nullopt;
}

void Peers::add(PeerEndpoint endpoint)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (endpoints_.size() < kMostRemembered || endpoints_.count(endpoint.guid) > 0) {
    endpoints_[endpoint.guid] = std::move(endpoint);
  }
  ++revision_;
}

void Peers::remove(const Guid & guid)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  endpoints_.erase(guid);
  ++revision_;
}

std::vector<PeerEndpoint> Peers::on(const std::string & dds_topic, PeerEndpoint::Role role) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<PeerEndpoint> found;
  for (const auto & [guid, endpoint] : endpoints_) {
    if (endpoint.role == role && endpoint.dds_topic == dds_topic) {
      found.push_back(endpoint);
    }
  }
  return found;
}

void Peers::on_publisher_discovery(
  dds::DomainParticipant * /*participant*/, rtps::WriterDiscoveryInfo && found)
{
  if (found.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER) {
    remove(to_guid(found.info.guid()));
  } else {
    add(endpoint_of(found.info, PeerEndpoint::Role::kWriter));
  }
}

void Peers::on_subscriber_discovery(
  dds::DomainParticipant * /*participant*/, rtps::ReaderDiscoveryInfo && found)
{
  if (found.status == rtps::ReaderDiscoveryInfo::REMOVED_READER) {
    remove(to_guid(found.info.guid()));
  } else {
    add(endpoint_of(found.info, PeerEndpoint::Role::kReader));
  }
}

}  // namespace stetro_dds
