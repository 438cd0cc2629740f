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

#include "benchmark/bare_endpoints.hpp"

#include <memory>
#include <stdexcept>

#include "fastdds/dds/core/condition/WaitSet.hpp"
#include "fastdds/dds/domain/DomainParticipantFactory.hpp"
#include "fastdds/rtps/transport/UDPv4TransportDescriptor.h"
#include "fastrtps/utils/IPLocator.h"

namespace bare
{

namespace
{

using eprosima::fastrtps::rtps::Locator_t;

dds::DomainParticipantQos loopback_qos()
{
  dds::DomainParticipantQos qos;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.emplace_back("127.0.0.1");
  udp->maxInitialPeersRange = 32;
  udp->sendBufferSize = udp->receiveBufferSize = 1024 * 1024;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);
  Locator_t loopback;
  eprosima::fastrtps::rtps::IPLocator::setIPv4(loopback, 127, 0, 0, 1);
  auto & builtin = qos.wire_protocol().builtin;
  builtin.initialPeersList.push_back(loopback);
  builtin.metatrafficUnicastLocatorList.push_back(loopback);
  builtin.discovery_config.leaseDuration = {3, 0};
  builtin.discovery_config.leaseDuration_announcementperiod = {1, 0};
  return qos;
}

template <class Qos>
void apply(const stetro_dds::EndpointQos & from, const dds::TopicDataType & type, Qos & to)
{
  to.reliability().kind = from.reliability == stetro_dds::Reliability::kReliable
                            ? dds::RELIABLE_RELIABILITY_QOS
                            : dds::BEST_EFFORT_RELIABILITY_QOS;
  to.durability().kind = from.durability == stetro_dds::Durability::kTransientLocal
                           ? dds::TRANSIENT_LOCAL_DURABILITY_QOS
                           : dds::VOLATILE_DURABILITY_QOS;
  to.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  to.history().depth = from.depth;
  to.resource_limits().allocated_samples = from.depth;
  to.data_sharing().off();
  to.endpoint().history_memory_policy = type.is_bounded() && type.m_typeSize <= 4096
                                          ? eprosima::fastrtps::rtps::PREALLOCATED_MEMORY_MODE
                                          : eprosima::fastrtps::rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
}

template <class Entity>
Entity * made(Entity * entity, const std::string & what)
{
  if (entity == nullptr) {
    throw std::runtime_error("Fast DDS makes no " + what);
  }
  return entity;
}

}  // namespace

Participant::Participant(std::uint32_t domain_id)
: participant_(made(
    dds::DomainParticipantFactory::get_instance()->create_participant(domain_id, loopback_qos()),
    "participant")),
  publisher_(made(participant_->create_publisher(dds::PublisherQos()), "publisher")),
  subscriber_(made(participant_->create_subscriber(dds::SubscriberQos()), "subscriber"))
{
}

Participant::~Participant()
{
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

dds::Topic * Participant::topic_for(dds::TypeSupport & type, const std::string & topic)
{
  const std::string name = "rt" + topic;
  if (auto * known = participant_->lookup_topicdescription(name)) {
    return static_cast<dds::Topic *>(known);
  }
  type.register_type(participant_);
  return made(participant_->create_topic(name, type.get_type_name(), dds::TopicQos()), name);
}

dds::DataWriter * Participant::make_writer(
  dds::TypeSupport type, const std::string & topic, const stetro_dds::QosProfile & profile)
{
  dds::DataWriterQos qos;
  apply(profile.offered, *type, qos);
  const auto heartbeat = std::chrono::duration<long double>(profile.heartbeat).count();
  qos.reliable_writer_qos().times.heartbeatPeriod = eprosima::fastrtps::Duration_t(heartbeat);
  qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
  return made(publisher_->create_datawriter(topic_for(type, topic), qos), "writer of " + topic);
}

dds::DataReader * Participant::make_reader(
  dds::TypeSupport type, const std::string & topic, const stetro_dds::QosProfile & profile)
{
  dds::DataReaderQos qos;
  apply(profile.requested, *type, qos);
  return made(subscriber_->create_datareader(topic_for(type, topic), qos), "reader of " + topic);
}

Dispatch::~Dispatch() { stop(); }

void Dispatch::start()
{
  thread_ = std::thread([this] { run(); });
}

void Dispatch::stop()
{
  stopped_ = true;
  leave_.set_trigger_value(true);
  if (thread_.joinable()) {
    thread_.join();
  }
}

void Dispatch::run()
{
  dds::WaitSet wait_set;
  wait_set.attach_condition(leave_);
  for (const Reading & reading : readers_) {
    auto & condition = reading.reader->get_statuscondition();
    condition.set_enabled_statuses(dds::StatusMask::data_available());
    wait_set.attach_condition(condition);
  }
  dds::ConditionSeq active;
  while (!stopped_) {
    wait_set.wait(active, eprosima::fastrtps::Duration_t(0.1L));
    for (Reading & reading : readers_) {
      reading.take_all();
    }
  }
  for (const Reading & reading : readers_) {
    wait_set.detach_condition(reading.reader->get_statuscondition());
  }
  wait_set.detach_condition(leave_);
}

}  // namespace bare
