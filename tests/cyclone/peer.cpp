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

#include "cyclone/peer.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "stetro_tests/deadline.hpp"

namespace stetro_tests::cyclone
{

namespace
{

/// Unicast over the loopback, and a lease as short as the robot's own.
constexpr const char * kLoopbackOnly = R"(<CycloneDDS><Domain Id="any">
  <General>
    <Interfaces><NetworkInterface address="127.0.0.1" multicast="false"/></Interfaces>
    <AllowMulticast>false</AllowMulticast>
  </General>
  <Discovery>
    <ParticipantIndex>auto</ParticipantIndex>
    <MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>
    <Peers><Peer address="127.0.0.1"/></Peers>
    <LeaseDuration>3s</LeaseDuration>
  </Discovery>
</Domain></CycloneDDS>)";

dds_entity_t checked(dds_entity_t entity, const std::string & what)
{
  if (entity < 0) {
    throw std::runtime_error(what + ": " + dds_strretcode(entity));
  }
  return entity;
}

Guid guid_of(const dds_guid_t & key)
{
  Guid result{};
  std::copy(std::begin(key.v), std::end(key.v), result.begin());
  return result;
}

std::string user_data_of(const dds_qos_t * qos)
{
  void * bytes = nullptr;
  std::size_t size = 0;
  if (!dds_qget_userdata(qos, &bytes, &size) || bytes == nullptr) {
    return "";
  }
  std::string result(static_cast<const char *>(bytes), size);
  dds_free(bytes);
  return result;
}

std::vector<std::string> partitions_of(const dds_qos_t * qos)
{
  std::uint32_t count = 0;
  char ** names = nullptr;
  std::vector<std::string> result;
  if (dds_qget_partition(qos, &count, &names)) {
    for (std::uint32_t i = 0; i < count; ++i) {
      result.emplace_back(names[i]);
      dds_free(names[i]);
    }
    dds_free(names);
  }
  return result;
}

bool is_plain_cdr(const dds_qos_t * qos)
{
  std::uint32_t count = 0;
  dds_data_representation_id_t * ids = nullptr;
  if (!dds_qget_data_representation(qos, &count, &ids)) {
    return true;  // nothing said means XCDR1
  }
  const bool plain = count == 1 && ids[0] == DDS_DATA_REPRESENTATION_XCDR1;
  dds_free(ids);
  return plain;
}

SeenEndpoint seen(const dds_builtintopic_endpoint_t & endpoint)
{
  dds_reliability_kind_t reliability = DDS_RELIABILITY_BEST_EFFORT;
  dds_durability_kind_t durability = DDS_DURABILITY_VOLATILE;
  dds_duration_t blocking = 0;
  dds_qget_reliability(endpoint.qos, &reliability, &blocking);
  dds_qget_durability(endpoint.qos, &durability);
  return {
    guid_of(endpoint.key),
    guid_of(endpoint.participant_key),
    endpoint.topic_name,
    endpoint.type_name,
    reliability == DDS_RELIABILITY_RELIABLE,
    durability == DDS_DURABILITY_TRANSIENT_LOCAL,
    user_data_of(endpoint.qos),
    partitions_of(endpoint.qos),
    is_plain_cdr(endpoint.qos)};
}

/// Reads what a builtin reader holds and hands each living sample on.
void for_each_alive(dds_entity_t reader, const std::function<void(const void *)> & look)
{
  constexpr std::uint32_t kMost = 512;
  std::vector<void *> samples(kMost, nullptr);
  std::vector<dds_sample_info_t> infos(kMost);
  const dds_return_t count = dds_read(reader, samples.data(), infos.data(), kMost, kMost);
  for (std::size_t i = 0; static_cast<dds_return_t>(i) < count; ++i) {
    if (infos[i].valid_data && infos[i].instance_state == DDS_IST_ALIVE) {
      look(samples[i]);
    }
  }
  if (count > 0) {
    dds_return_loan(reader, samples.data(), count);
  }
}

dds_qos_t * make_qos(const Quality & quality)
{
  dds_qos_t * qos = dds_create_qos();
  dds_qset_reliability(
    qos, quality.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT, DDS_SECS(1));
  dds_qset_durability(
    qos, quality.transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, quality.depth);
  const dds_data_representation_id_t plain = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos, 1, &plain);
  return qos;
}

}  // namespace

Peer::Peer(std::uint32_t domain_id)
: domain_(checked(dds_create_domain(domain_id, kLoopbackOnly), "domain")),
  participant_(checked(dds_create_participant(domain_id, nullptr, nullptr), "participant")),
  participants_(checked(
    dds_create_reader(participant_, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, nullptr, nullptr),
    "builtin reader")),
  publications_(checked(
    dds_create_reader(participant_, DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr),
    "builtin reader")),
  subscriptions_(checked(
    dds_create_reader(participant_, DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION, nullptr, nullptr),
    "builtin reader"))
{
}

Peer::~Peer() { dds_delete(domain_); }

Guid Peer::guid() const
{
  dds_guid_t key{};
  dds_get_guid(participant_, &key);
  return guid_of(key);
}

std::vector<SeenParticipant> Peer::participants() const
{
  std::vector<SeenParticipant> result;
  for_each_alive(participants_, [&](const void * sample) {
    const auto & seen = *static_cast<const dds_builtintopic_participant_t *>(sample);
    if (guid_of(seen.key) != guid()) {
      result.push_back({guid_of(seen.key), user_data_of(seen.qos)});
    }
  });
  return result;
}

std::vector<SeenEndpoint> Peer::endpoints(dds_entity_t builtin) const
{
  std::vector<SeenEndpoint> result;
  for_each_alive(builtin, [&](const void * sample) {
    SeenEndpoint endpoint = seen(*static_cast<const dds_builtintopic_endpoint_t *>(sample));
    if (endpoint.participant != guid()) {
      result.push_back(std::move(endpoint));
    }
  });
  return result;
}

std::vector<SeenEndpoint> Peer::publications() const { return endpoints(publications_); }
std::vector<SeenEndpoint> Peer::subscriptions() const { return endpoints(subscriptions_); }

dds_entity_t Peer::make_topic(const dds_topic_descriptor_t & type, const std::string & name)
{
  return checked(dds_create_topic(participant_, &type, name.c_str(), nullptr, nullptr), name);
}

dds_entity_t Peer::make_reader(dds_entity_t topic, const Quality & quality)
{
  dds_qos_t * qos = make_qos(quality);
  const dds_entity_t reader = dds_create_reader(participant_, topic, qos, nullptr);
  dds_delete_qos(qos);
  return checked(reader, "reader");
}

dds_entity_t Peer::make_writer(dds_entity_t topic, const Quality & quality)
{
  dds_qos_t * qos = make_qos(quality);
  const dds_entity_t writer = dds_create_writer(participant_, topic, qos, nullptr);
  dds_delete_qos(qos);
  return checked(writer, "writer");
}

bool wait_for_sample(
  dds_entity_t reader, const std::function<bool(const void *)> & look,
  std::chrono::nanoseconds limit)
{
  bool found = false;
  const auto take_one = [&]() {
    void * sample = nullptr;
    dds_sample_info_t info;
    while (!found && dds_take(reader, &sample, &info, 1, 1) == 1) {
      found = info.valid_data && look(sample);
      dds_return_loan(reader, &sample, 1);
      sample = nullptr;
    }
    return found;
  };
  return poll_until(take_one, limit);
}

dds_topic_descriptor_t renamed(const dds_topic_descriptor_t & type, const char * name)
{
  dds_topic_descriptor_t result = type;
  result.m_typename = name;
  return result;
}

}  // namespace stetro_tests::cyclone
