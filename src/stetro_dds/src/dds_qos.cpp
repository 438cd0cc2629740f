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

#include "dds_qos.hpp"

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "fastdds/rtps/transport/UDPv4TransportDescriptor.h"
#include "fastrtps/utils/IPLocator.h"

namespace stetro_dds
{

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::Duration_t;

namespace
{

constexpr std::uint32_t kParticipantsPerHost = 32;  // ROS 2's choice; beyond it peers stay unseen
constexpr std::uint32_t kSocketBuffer_bytes = 1024 * 1024;
constexpr std::size_t kMostParticipants = 64;        // a runaway peer may not grow us without end
constexpr std::size_t kMostEndpoints = 256;          // per participant
constexpr std::uint32_t kPreallocated_bytes = 4096;  // larger samples are allocated as they come

std::vector<rtps::octet> bytes_of(const std::string & text) { return {text.begin(), text.end()}; }

rtps::Locator_t ipv4(const std::string & address)
{
  rtps::Locator_t locator;
  if (!rtps::IPLocator::isIPv4(address) || !rtps::IPLocator::setIPv4(locator, address)) {
    throw std::invalid_argument("static peer '" + address + "': accepted is an IPv4 address");
  }
  return locator;  // port 0: the well-known ports of the first participants there
}

/// Unicast announcements to this computer, and no multicast group joined.
void discover_on_localhost(
  RosDistro distro, rtps::BuiltinAttributes & builtin,
  eprosima::fastdds::rtps::UDPv4TransportDescriptor & udp)
{
  builtin.initialPeersList.push_back(ipv4("127.0.0.1"));
  if (distro == RosDistro::kHumble) {
    udp.interfaceWhiteList.emplace_back("127.0.0.1");
    builtin.metatrafficUnicastLocatorList.push_back(ipv4("127.0.0.1"));
  } else {
    builtin.metatrafficUnicastLocatorList.push_back(rtps::Locator_t{});
  }
}

void discover_on_subnet(const std::vector<std::string> & peers, rtps::BuiltinAttributes & builtin)
{
  for (const auto & peer : peers) {
    builtin.initialPeersList.push_back(ipv4(peer));
  }
  if (!peers.empty()) {  // a list replaces the default one, which is the multicast group
    builtin.initialPeersList.push_back(ipv4("239.255.0.1"));
  }
}

dds::ReliabilityQosPolicyKind kind_of(Reliability reliability)
{
  return reliability == Reliability::kReliable ? dds::RELIABLE_RELIABILITY_QOS
                                               : dds::BEST_EFFORT_RELIABILITY_QOS;
}

dds::DurabilityQosPolicyKind kind_of(Durability durability)
{
  return durability == Durability::kTransientLocal ? dds::TRANSIENT_LOCAL_DURABILITY_QOS
                                                   : dds::VOLATILE_DURABILITY_QOS;
}

/// Small bounded types never allocate again and refuse what is larger; the others reuse what grew.
rtps::MemoryManagementPolicy_t memory_for(const dds::TopicDataType & type)
{
  return type.is_bounded() && type.m_typeSize <= kPreallocated_bytes
           ? rtps::PREALLOCATED_MEMORY_MODE
           : rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
}

template <class Qos>
void apply(const EndpointQos & from, Qos & to)
{
  to.reliability().kind = kind_of(from.reliability);
  to.durability().kind = kind_of(from.durability);
  to.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  to.history().depth = from.depth;
  to.resource_limits().allocated_samples = from.depth;
  to.data_sharing().off();
  to.user_data().setValue(bytes_of("stetro=1;"));  // empty would make Jazzy's graph warn
}

}  // namespace

dds::DomainParticipantQos participant_qos(const ContextOptions & options)
{
  dds::DomainParticipantQos qos;
  qos.name("/");  // the enclave, as rmw_fastrtps names its participants
  qos.user_data().setValue(bytes_of("enclave=/;"));

  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->maxInitialPeersRange = kParticipantsPerHost;
  udp->sendBufferSize = kSocketBuffer_bytes;
  udp->receiveBufferSize = kSocketBuffer_bytes;
  qos.transport().use_builtin_transports = false;  // no shared memory: it outlives a kill badly
  qos.transport().user_transports.push_back(udp);

  auto & builtin = qos.wire_protocol().builtin;
  builtin.discovery_config.leaseDuration = {3, 0};
  builtin.discovery_config.leaseDuration_announcementperiod = {1, 0};
  builtin.readerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  builtin.writerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  if (options.scope == NetworkScope::kLocalhost) {
    discover_on_localhost(options.distro, builtin, *udp);
  } else {
    discover_on_subnet(options.static_peers, builtin);
  }

  qos.allocation().participants.maximum = kMostParticipants;
  qos.allocation().readers.maximum = kMostEndpoints;
  qos.allocation().writers.maximum = kMostEndpoints;
  return qos;
}

dds::DataWriterQos writer_qos(const QosProfile & profile, const dds::TopicDataType & type)
{
  dds::DataWriterQos qos;
  apply(profile.offered, qos);
  qos.endpoint().history_memory_policy = memory_for(type);
  qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
  const auto heartbeat = std::chrono::duration<long double>(profile.heartbeat).count();
  qos.reliable_writer_qos().times.heartbeatPeriod = Duration_t(heartbeat);
  qos.writer_resource_limits().reader_filters_allocation.maximum = 0;  // no filters from afar
  return qos;
}

dds::DataReaderQos reader_qos(const QosProfile & profile, const dds::TopicDataType & type)
{
  dds::DataReaderQos qos;
  apply(profile.requested, qos);
  qos.endpoint().history_memory_policy = memory_for(type);
  return qos;
}

}  // namespace stetro_dds
