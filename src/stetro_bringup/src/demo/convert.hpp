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
#ifndef DEMO__CONVERT_HPP_
#define DEMO__CONVERT_HPP_

#include <optional>
#include <string>

#include "journey_files.hpp"
#include "stetro_bringup/recorder.hpp"
#include "stetro_bringup/staircase_found.hpp"
#include "stetro_dds/refusal.hpp"
#include "stetro_dds/stamp.hpp"
#include "stetro_msgs/DiagnosticStatus.hpp"
#include "stetro_msgs/ProfileCheck.hpp"
#include "stetro_msgs/StairPose.hpp"

namespace stetro_bringup
{

using stetro_dds::stamp_of;
using stetro_dds::time_of;

/// Where a StairPose says the robot is.
/**
 * What is unknown, as a pose that is lost or a place on the tread while on the floor, stays NaN.
 *
 * \return nothing if the stamp is not after zero or a number is infinite; `why` says which then
 */
[[nodiscard]] std::optional<StairSample> sample_of(
  const stetro_msgs::msg::StairPose & message, stetro_dds::Refusal & why);

/// The estimate in a StairPose; `sample` is what sample_of() made of it.
[[nodiscard]] Estimate estimate_of(
  const stetro_msgs::msg::StairPose & message, const StairSample & sample);

/// The staircase in the localizer's diagnostic status of that name.
[[nodiscard]] StaircaseFound staircase_of(const diagnostic_msgs::msg::DiagnosticStatus & message);

[[nodiscard]] std::string integrity_name(std::uint8_t integrity);
[[nodiscard]] std::string outcome_name(std::uint8_t outcome);

/// An answer of the profile check.
[[nodiscard]] CheckSample check_of(const stetro_msgs::msg::ProfileCheck & message);

}  // namespace stetro_bringup

#endif  // DEMO__CONVERT_HPP_
