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

#ifndef STETRO_SUPERVISOR__ROBOT_HEALTH_HPP_
#define STETRO_SUPERVISOR__ROBOT_HEALTH_HPP_

#include <cmath>
#include <optional>

#include "stetro_supervisor/observation.hpp"

namespace stetro_supervisor
{

// What stops the robot wherever it is, on a step or on a floor.

/// Not there, or not from now: a sample from the future is as unusable as an old one.
template <class Sample>
bool older_than(const std::optional<Sample> & sample, Time now, double limit_s)
{
  return !sample || std::abs(seconds_between(sample->time, now)) > limit_s;
}

/// Ranges, contacts, blocks or odometry have not come for longer than the limit.
[[nodiscard]] bool is_driver_silent(const Observation & seen, Time now, double limit_s);

[[nodiscard]] bool is_emergency_stop_closed(const Observation & seen);
[[nodiscard]] bool is_block_broken(const Observation & seen);

/// A bumper, a riser switch or the emergency stop is broken or unknown.
[[nodiscard]] bool is_switch_broken(const Observation & seen);

/// All three blocks stand on one level, as far as their heights tell.
[[nodiscard]] bool is_level(const Observation & seen, double tolerance_m);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__ROBOT_HEALTH_HPP_
