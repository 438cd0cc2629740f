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

#ifndef SUPPORT__RAW_PUBLISHER_HPP_
#define SUPPORT__RAW_PUBLISHER_HPP_

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fastdds/dds/topic/TopicDataType.hpp"
#include "fastdds/dds/topic/TypeSupport.hpp"
#include "participant.hpp"
#include "stetro_dds/publisher.hpp"

namespace stetro_dds
{

using Bytes = std::vector<std::uint8_t>;

/// Puts bytes on the wire as they are, under whatever type name.
class RawType : public eprosima::fastdds::dds::TopicDataType
{
public:
  using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

  explicit RawType(const std::string & name)
  {
    setName(name.c_str());
    m_typeSize = 65000;
  }
  bool serialize(void * bytes, Payload * payload) override
  {
    const auto & from = *static_cast<Bytes *>(bytes);
    std::copy(from.begin(), from.end(), payload->data);
    payload->length = static_cast<std::uint32_t>(from.size());
    return true;
  }
  bool deserialize(Payload * payload, void * bytes) override
  {
    static_cast<Bytes *>(bytes)->assign(payload->data, payload->data + payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void * bytes) override
  {
    return [bytes] {
      return static_cast<std::uint32_t>(
        std::max<std::size_t>(static_cast<Bytes *>(bytes)->size(), 1));
    };
  }
  void * createData() override { return new Bytes(); }
  void deleteData(void * bytes) override { delete static_cast<Bytes *>(bytes); }
  bool getKey(void *, eprosima::fastrtps::rtps::InstanceHandle_t *, bool) override { return false; }
};

/// A peer that writes what it likes.
class RawPublisher : public PublisherBase
{
public:
  RawPublisher(
    Context & context, const std::string & topic, const std::string & type_name,
    const QosProfile & profile)
  : PublisherBase(
      context.participant(), topic, dds_topic_name(topic),
      eprosima::fastdds::dds::TypeSupport(new RawType(type_name)), profile)
  {
  }

  bool publish(const Bytes & bytes) { return write(&bytes); }
};

}  // namespace stetro_dds

#endif  // SUPPORT__RAW_PUBLISHER_HPP_
