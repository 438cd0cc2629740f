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

#ifndef NODE__CONVERT_HPP_
#define NODE__CONVERT_HPP_

#include <array>
#include <optional>
#include <string>

#include "stetro_dds/refusal.hpp"
#include "stetro_dds/stamp.hpp"
#include "stetro_localizer/estimator.hpp"
#include "stetro_localizer/pose_correction.hpp"
#include "stetro_localizer/samples.hpp"
#include "stetro_localizer/segment.hpp"
#include "stetro_msgs/BlockStates.hpp"
#include "stetro_msgs/Contacts.hpp"
#include "stetro_msgs/Imu.hpp"
#include "stetro_msgs/Innovations.hpp"
#include "stetro_msgs/Odometry.hpp"
#include "stetro_msgs/PoseCorrection.hpp"
#include "stetro_msgs/PoseWithCovarianceStamped.hpp"
#include "stetro_msgs/RangeArray.hpp"
#include "stetro_msgs/StairPose.hpp"
#include "stetro_msgs/TFMessage.hpp"
#include "stetro_site/site.hpp"

/// \file
/// The only place that knows both the messages and the types of the core.

namespace stetro_localizer
{

using stetro_dds::stamp_of;
using stetro_dds::time_of;

/// \name Messages into samples
/**
 * They return why a message is not used, and then the sample means nothing. What is not finite,
 * negative, contradicts its own status or names nothing known stops here; the order of the stamps
 * and their distance from now is for the estimator to judge.
 */
///@{

/// A valid range is finite and not negative; the infinities of REP 117 come with their status only.
/** A reading that is older than its array by more than `stale_after` becomes stale. */
[[nodiscard]] std::optional<stetro_dds::Refusal> take(
  const stetro_msgs::msg::RangeArray & message, Nanoseconds stale_after, RangeSample & sample);
[[nodiscard]] std::optional<stetro_dds::Refusal> take(
  const stetro_msgs::msg::Contacts & message, ContactSample & sample);
[[nodiscard]] std::optional<stetro_dds::Refusal> take(
  const stetro_msgs::msg::BlockStates & message, BlockSample & sample);
[[nodiscard]] std::optional<stetro_dds::Refusal> take(
  const sensor_msgs::msg::Imu & message, GyroSample & sample);
/// \param odom where the wheels say that `base_link` is, in `odom`
[[nodiscard]] std::optional<stetro_dds::Refusal> take(
  const nav_msgs::msg::Odometry & message, OdometrySample & sample, stetro_site::Pose & odom);

/// A pose and its covariance, in the frame that the header names.
[[nodiscard]] std::optional<stetro_dds::Refusal> take(
  const geometry_msgs::msg::PoseWithCovarianceStamped & message, stetro_site::Pose & pose,
  stetro_site::Covariance & covariance);

/// The frame of a correction is the floor that it is of; any other is refused.
[[nodiscard]] std::optional<stetro_dds::Refusal> take(
  const stetro_msgs::msg::PoseCorrection & message, PoseCorrection & correction);

/// What the estimator refused, for the counters of the topic; nothing if it was taken.
[[nodiscard]] std::optional<stetro_dds::Refusal> refusal_of(Verdict verdict);
///@}

/// True if every number of the pose is known.
[[nodiscard]] bool is_known(const stetro_site::Pose & pose);

/// \name Estimates into messages, which are filled anew and keep their memory
///@{
void fill(
  geometry_msgs::msg::PoseWithCovarianceStamped & message, const StairEstimate & estimate,
  const Segment & segment);
void fill(
  stetro_msgs::msg::StairPose & message, const StairEstimate & estimate, const Segment & segment);
/// What is compared with an expectation there: ranges and contacts on a flight, else corrections.
void fill(
  stetro_msgs::msg::Innovations & message, const Estimator & estimator, const Segment & segment);
/// map -> odom, such that map -> odom -> base_link is the estimate.
void fill(
  tf2_msgs::msg::TFMessage & message, const StairEstimate & estimate, const Segment & segment,
  const stetro_site::Pose & odom);
///@}

/// map -> the frame of every flight and drawn floor of the site.
/** In one message: /tf_static keeps only the last. */
[[nodiscard]] tf2_msgs::msg::TFMessage to_static_transforms(
  Nanoseconds now, const stetro_site::Site & site);

}  // namespace stetro_localizer

#endif  // NODE__CONVERT_HPP_
