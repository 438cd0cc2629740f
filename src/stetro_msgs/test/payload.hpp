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

#ifndef PAYLOAD_HPP_
#define PAYLOAD_HPP_

#include <fastdds/rtps/common/SerializedPayload.h>

#include <cstdint>
#include <stdexcept>
#include <string>

#include "stetro_msgs/support.hpp"

namespace stetro_msgs
{

using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

/// The bytes a writer would put on the wire, as hexadecimal digits. \throws std::runtime_error
template <class Message>
std::string to_hex(Message message)
{
  SupportOf<Message> support;
  Payload payload{support.getSerializedSizeProvider(&message)()};
  if (!support.serialize(&message, &payload)) {
    throw std::runtime_error("a message does not fit the size computed for it");
  }
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string hex;
  for (std::uint32_t i = 0; i < payload.length; ++i) {
    hex += kDigits[payload.data[i] >> 4];
    hex += kDigits[payload.data[i] & 15];
  }
  return hex;
}

/// The message a reader would make of these bytes. \throws std::runtime_error
template <class Message>
Message from_hex(const std::string & hex)
{
  Payload payload{static_cast<std::uint32_t>(hex.size() / 2)};
  payload.length = payload.max_size;
  for (std::uint32_t i = 0; i < payload.length; ++i) {
    payload.data[i] = static_cast<std::uint8_t>(std::stoi(hex.substr(2 * i, 2), nullptr, 16));
  }
  Message message;
  if (!SupportOf<Message>{}.deserialize(&payload, &message)) {
    throw std::runtime_error("the bytes end before the message does");
  }
  return message;
}

}  // namespace stetro_msgs

#endif  // PAYLOAD_HPP_
