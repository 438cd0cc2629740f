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

#ifndef NODE__CONVERT_FLOOR_HPP_
#define NODE__CONVERT_FLOOR_HPP_

#include <cstdint>
#include <memory>
#include <optional>

#include "stetro_dds/refusal.hpp"
#include "stetro_msgs/LaserScan.hpp"
#include "stetro_msgs/PoseCorrection.hpp"
#include "stetro_msgs/ProfileCheck.hpp"
#include "stetro_site/floor.hpp"
#include "stetro_supervisor/floor/floor_check.hpp"

/// What `convert.hpp` is for the climb, for floors: scans, checks and corrections.
namespace stetro_supervisor
{

using stetro_dds::Refusal;

/// Takes a scan with the time of its first beam.
/**
 * Refused are angles that are not finite or do not fit the number of ranges, more than a turn of
 * them, fewer than 16, and a span of ranges that is none. A range outside the span is none: nearer
 * is too near to tell, farther or NaN says nothing (REP 117).
 */
std::optional<Refusal> take(
  const sensor_msgs::msg::LaserScan & message, Time measured, std::shared_ptr<const Scan> & scan);

/// Everything in `map`. \param floor whose plan was used; null if none
stetro_msgs::msg::ProfileCheck to_message(
  const CheckReport & report, const stetro_site::Floor * floor);

/// In the floor's own frame. \param sequence grows by one with each correction
stetro_msgs::msg::PoseCorrection to_message(const Correction & correction, std::uint64_t sequence);

}  // namespace stetro_supervisor

#endif  // NODE__CONVERT_FLOOR_HPP_
