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

#ifndef STETRO_DDS__STAMP_HPP_
#define STETRO_DDS__STAMP_HPP_

#include "stetro_dds/monotone_time.hpp"
#include "stetro_msgs/Time.hpp"

namespace stetro_dds
{

/// The time that a stamp says, since the epoch or since the simulation's origin [ns].
/**
 * \return zero, which no guard lets pass, if the stamp is none: `sec` is negative, or `nanosec` is a
 *   whole second or more
 */
[[nodiscard]] Time time_of(const builtin_interfaces::msg::Time & stamp);

/// The inverse of `time_of`, for times from 0 to less than 2^31 s (January 2038).
/** \return the zero stamp for a time that a stamp cannot say */
[[nodiscard]] builtin_interfaces::msg::Time stamp_of(Time time);

}  // namespace stetro_dds

#endif  // STETRO_DDS__STAMP_HPP_
