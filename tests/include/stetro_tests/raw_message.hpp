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

#ifndef STETRO_TESTS__RAW_MESSAGE_HPP_
#define STETRO_TESTS__RAW_MESSAGE_HPP_

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "fastdds/dds/topic/TopicDataType.hpp"
#include "stetro_msgs/support.hpp"

namespace stetro_tests
{

/// The bytes of a sample, encapsulation header included: whatever a hostile peer may send.
using Bytes = std::vector<std::uint8_t>;

/// Bytes to be sent as they are, under the name and on the topics of a real message.
/** For a participant of its own: one participant knows one type of a name. */
template <class Message>
struct Raw
{
  Bytes bytes;
};

/// Its bounds are not known, which is the point.
template <class Message, class Visitor>
void for_each_member(const Raw<Message> &, Visitor &&)
{
}

/// Carries raw bytes over DDS.
template <class Message>
class RawSupport : public eprosima::fastdds::dds::TopicDataType
{
public:
  using type = Raw<Message>;
  using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

  RawSupport()
  {
    setName(stetro_msgs::SupportOf<Message>().getName());
    m_typeSize = kMostBytes;
    m_isGetKeyDefined = false;
  }

  bool serialize(void * message, Payload * payload) override
  {
    const Bytes & bytes = static_cast<type *>(message)->bytes;
    if (bytes.size() > payload->max_size) {
      return false;
    }
    std::copy(bytes.begin(), bytes.end(), payload->data);
    payload->length = static_cast<std::uint32_t>(bytes.size());
    payload->encapsulation = bytes.size() > 1 && bytes[1] == 0 ? CDR_BE : CDR_LE;
    return true;
  }

  bool deserialize(Payload * payload, void * message) override
  {
    static_cast<type *>(message)->bytes.assign(payload->data, payload->data + payload->length);
    return true;
  }

  std::function<std::uint32_t()> getSerializedSizeProvider(void * message) override
  {
    const Bytes & bytes = static_cast<type *>(message)->bytes;
    return [&bytes] { return static_cast<std::uint32_t>(bytes.size()); };
  }

  void * createData() override { return new type; }
  void deleteData(void * message) override { delete static_cast<type *>(message); }
  bool getKey(void *, eprosima::fastrtps::rtps::InstanceHandle_t *, bool) override { return false; }

private:
  static constexpr std::uint32_t kMostBytes = 65536;
};

/// A message as it goes over the wire.
template <class Message>
Bytes bytes_of(const Message & message)
{
  stetro_msgs::SupportOf<Message> support;
  Message copy = message;
  eprosima::fastrtps::rtps::SerializedPayload_t payload(support.getSerializedSizeProvider(&copy)());
  if (!support.serialize(&copy, &payload)) {
    throw std::logic_error(std::string("cannot serialize ") + support.getName());
  }
  return {payload.data, payload.data + payload.length};
}

}  // namespace stetro_tests

namespace stetro_msgs
{

template <class Message>
struct Support<stetro_tests::Raw<Message>>
{
  using type = stetro_tests::RawSupport<Message>;
};

}  // namespace stetro_msgs

#endif  // STETRO_TESTS__RAW_MESSAGE_HPP_
