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

#ifndef STETRO_MSGS__SUPPORT_HPP_
#define STETRO_MSGS__SUPPORT_HPP_

namespace stetro_msgs
{

/// The class that carries a message over DDS: Support<stetro_msgs::msg::RangeArray>::type.
/**
 * Specialised by the generated header of each type, "stetro_msgs/RangeArray.hpp" and so on. The
 * class's name for DDS is the one ROS 2 looks for.
 */
template <class Message>
struct Support;

template <class Message>
using SupportOf = typename Support<Message>::type;

}  // namespace stetro_msgs

#endif  // STETRO_MSGS__SUPPORT_HPP_
