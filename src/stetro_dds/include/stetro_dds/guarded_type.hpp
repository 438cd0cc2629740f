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

#ifndef STETRO_DDS__GUARDED_TYPE_HPP_
#define STETRO_DDS__GUARDED_TYPE_HPP_

#include <cstdint>

#include "fastdds/dds/topic/TypeSupport.hpp"
#include "fastdds/rtps/common/InstanceHandle.h"
#include "fastdds/rtps/common/SerializedPayload.h"
#include "stetro_msgs/bounds.hpp"
#include "stetro_msgs/support.hpp"

namespace stetro_dds
{

namespace detail
{

/// Samples that this thread could not decode; a subscription looks at it around each take.
std::uint64_t & malformed_on_this_thread();

}  // namespace detail

/// A generated type that survives hostile bytes.
/**
 * Generated code lets a boolean byte of 2 or an unknown encapsulation abort the process, and takes
 * sequences longer than their bound. Here such a sample is dropped and counted. Every type is
 * registered through this wrapper, never bare.
 */
template <class Message>
class GuardedType : public stetro_msgs::SupportOf<Message>
{
public:
  using Generated = stetro_msgs::SupportOf<Message>;
  using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;
  using InstanceHandle = eprosima::fastrtps::rtps::InstanceHandle_t;

  bool deserialize(Payload * payload, void * message) override
  {
    if (is_plain_cdr(*payload) && decode(payload, message)) {
      return true;
    }
    ++detail::malformed_on_this_thread();
    return false;
  }

  bool getKey(void * message, InstanceHandle * handle, bool force_md5) override
  {
    try {
      return Generated::getKey(message, handle, force_md5);
    } catch (...) {
      return false;
    }
  }

private:
  /// Encapsulation CDR_BE (0) or CDR_LE (1): the only two that every ROS 2 peer writes.
  static bool is_plain_cdr(const Payload & payload)
  {
    return payload.length >= 4 && payload.data[0] == 0 && payload.data[1] <= 1;
  }

  bool decode(Payload * payload, void * message)
  {
    try {
      return Generated::deserialize(payload, message) &&
             stetro_msgs::within_bounds(*static_cast<const Message *>(message));
    } catch (...) {
      return false;
    }
  }
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__GUARDED_TYPE_HPP_
