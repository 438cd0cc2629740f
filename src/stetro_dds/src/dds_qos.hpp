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

#ifndef DDS_QOS_HPP_
#define DDS_QOS_HPP_

#include "fastdds/dds/domain/qos/DomainParticipantQos.hpp"
#include "fastdds/dds/publisher/qos/DataWriterQos.hpp"
#include "fastdds/dds/subscriber/qos/DataReaderQos.hpp"
#include "fastdds/dds/topic/TopicDataType.hpp"
#include "stetro_dds/context.hpp"
#include "stetro_dds/qos.hpp"

namespace stetro_dds
{

/// Transports, discovery and USER_DATA of the one participant, as the scope and distro ask.
/// \throws std::invalid_argument naming a static peer that is no IPv4 address
eprosima::fastdds::dds::DomainParticipantQos participant_qos(const ContextOptions & options);

eprosima::fastdds::dds::DataWriterQos writer_qos(
  const QosProfile & profile, const eprosima::fastdds::dds::TopicDataType & type);

eprosima::fastdds::dds::DataReaderQos reader_qos(
  const QosProfile & profile, const eprosima::fastdds::dds::TopicDataType & type);

}  // namespace stetro_dds

#endif  // DDS_QOS_HPP_
