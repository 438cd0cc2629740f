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

#include "node/convert.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stetro_localizer
{
namespace
{

using Rejection = std::optional<stetro_dds::Refusal>;

double yaw_of(const geometry_msgs::msg::Quaternion & q)
{
  return std::atan2(
    2.0 * (q.w() * q.z() + q.x() * q.y()), 1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
}

/// Of a body turned by yaw, then by pitch about its own y axis. All zeros, as a message that was
/// not filled in has them, are no attitude, nor is NaN.
std::optional<double> pitch_of(const geometry_msgs::msg::Quaternion & q)
{
  const double norm = q.x() * q.x() + q.y() * q.y() + q.z() * q.z() + q.w() * q.w();
  if (!(std::abs(norm - 1.0) < 1e-3)) {
    return std::nullopt;
  }
  return std::asin(std::clamp(2.0 * (q.w() * q.y() - q.z() * q.x()), -1.0, 1.0));
}

/// A unit quaternion that turns about z only; false for NaN.
bool is_upright(const geometry_msgs::msg::Quaternion & q)
{
  const double norm = q.x() * q.x() + q.y() * q.y() + q.z() * q.z() + q.w() * q.w();
  return std::abs(norm - 1.0) < 1e-3 && std::hypot(q.x(), q.y()) < 0.05;
}

std::optional<RangeStatus> status_of(std::uint8_t status)
{
  namespace wire = stetro_msgs::msg::RangeReading_Constants;
  switch (status) {
    case wire::STATUS_VALID:
      return RangeStatus::kValid;
    case wire::STATUS_TOO_NEAR:
      return RangeStatus::kTooNear;
    case wire::STATUS_NO_TARGET:
      return RangeStatus::kNoTarget;
    case wire::STATUS_WEAK:
      return RangeStatus::kWeak;
    case wire::STATUS_STALE:
      return RangeStatus::kStale;
    case wire::STATUS_FAULT:
    case wire::STATUS_UNKNOWN:
      return RangeStatus::kFault;
    default:
      return std::nullopt;
  }
}

Rejection take_reading(
  const stetro_msgs::msg::RangeReading & message, Nanoseconds stale_after, RangeSample & sample)
{
  const std::string name = message.sensor().c_str();
  const auto place = stetro_site::place_named(name);
  const auto status = status_of(message.status());
  if (!place || sample[*place].status != RangeStatus::kAbsent) {
    return stetro_dds::Refusal{"unknown_sensor", "'" + name + "', accepted: each place once"};
  }
  if (!status) {
    return stetro_dds::Refusal{"bad_status", name + ": " + std::to_string(message.status())};
  }
  if (*status == RangeStatus::kValid && !std::isfinite(message.range())) {
    return stetro_dds::Refusal{"not_finite", name + " calls itself valid"};
  }
  if (std::isfinite(message.range()) && message.range() < 0.0) {
    return stetro_dds::Refusal{"negative", name + ": " + std::to_string(message.range()) + " m"};
  }
  const Nanoseconds stamp = time_of(message.stamp());
  if (*status == RangeStatus::kValid && (stamp <= Nanoseconds{0} || stamp > sample.stamp)) {
    return stetro_dds::Refusal{"reading_stamp", name + " is not stamped up to its array"};
  }
  const bool stale = *status == RangeStatus::kValid && stamp + stale_after < sample.stamp;
  const double sigma_m = message.standard_deviation();
  sample[*place] = {
    stamp, message.range(), sigma_m > 0.0 && std::isfinite(sigma_m) ? sigma_m : 0.0,
    stale ? RangeStatus::kStale : *status};
  return std::nullopt;
}

std::optional<Switch> switch_of(const stetro_msgs::msg::ContactState & message)
{
  namespace wire = stetro_msgs::msg::ContactState_Constants;
  if (message.state() > wire::STATE_CLOSED) {
    return std::nullopt;
  }
  const bool known = message.state() != wire::STATE_UNKNOWN && !message.fault();
  return Switch{known, message.state() == wire::STATE_CLOSED};
}

Rejection take_block(const stetro_msgs::msg::BlockState & message, BlockReading & block)
{
  const double load = message.load();
  const bool fault = message.fault() || std::isnan(message.height());  // NaN: unknown
  if (std::isinf(message.height()) || std::isinf(load)) {
    return stetro_dds::Refusal{"not_finite", "a height or a load"};
  }
  if (message.height() < 0.0 || load < 0.0 || load > 1.0) {
    return stetro_dds::Refusal{"out_of_bounds", "a height below 0, or a load outside 0 to 1"};
  }
  block = {
    fault ? 0.0 : message.height(), std::isnan(load) ? 0.0 : load, !std::isnan(load),
    message.moving(), fault};
  return std::nullopt;
}

Rejection take_pose(
  const geometry_msgs::msg::PoseWithCovariance & message, stetro_site::Pose & pose,
  stetro_site::Covariance & covariance)
{
  const auto & at = message.pose().position();
  if (!std::isfinite(at.x() + at.y() + at.z()) || !is_upright(message.pose().orientation())) {
    return stetro_dds::Refusal{"not_finite", "the position, or an orientation that is not upright"};
  }
  for (int i = 0; i < 36; ++i) {
    const double element = message.covariance()[static_cast<std::size_t>(i)];
    if (!std::isfinite(element) || (i % 7 == 0 && element < 0.0)) {
      return stetro_dds::Refusal{"covariance", "an element not finite, or a negative variance"};
    }
    covariance(i / 6, i % 6) = element;
  }
  pose = {at.x(), at.y(), at.z(), yaw_of(message.pose().orientation())};
  return std::nullopt;
}

}  // namespace

Rejection take(
  const stetro_msgs::msg::RangeArray & message, Nanoseconds stale_after, RangeSample & sample)
{
  sample = RangeSample{};
  sample.stamp = time_of(message.header().stamp());
  for (const auto & reading : message.readings()) {
    if (auto rejection = take_reading(reading, stale_after, sample)) {
      return rejection;
    }
  }
  return std::nullopt;
}

Rejection take(const stetro_msgs::msg::Contacts & m, ContactSample & sample)
{
  const std::array<std::optional<Switch>, 8> all{
    switch_of(m.left_front()),  switch_of(m.left_middle()),  switch_of(m.left_rear()),
    switch_of(m.right_front()), switch_of(m.right_middle()), switch_of(m.right_rear()),
    switch_of(m.riser_left()),  switch_of(m.riser_right())};
  for (const auto & one : all) {
    if (!one) {
      return stetro_dds::Refusal{"bad_state", "a switch is in none of the states defined"};
    }
  }
  sample = {
    time_of(m.header().stamp()),
    {*all[0], *all[1], *all[2]},
    {*all[3], *all[4], *all[5]},
    *all[6],
    *all[7]};
  return std::nullopt;
}

Rejection take(const stetro_msgs::msg::BlockStates & message, BlockSample & sample)
{
  sample.stamp = time_of(message.header().stamp());
  const std::array<const stetro_msgs::msg::BlockState *, 3> blocks{
    &message.block1(), &message.block2(), &message.block3()};
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (auto rejection = take_block(*blocks[i], sample.blocks[i])) {
      return rejection;
    }
  }
  return std::nullopt;
}

Rejection take(const sensor_msgs::msg::Imu & message, GyroSample & sample)
{
  sample = {time_of(message.header().stamp()), message.angular_velocity().z()};
  if (!std::isfinite(sample.rate_radps)) {
    return stetro_dds::Refusal{"not_finite", "angular_velocity.z"};
  }
  if (message.orientation_covariance()[0] != -1.0) {  // that would mean: not measured
    sample.pitch_rad = pitch_of(message.orientation());
  }
  return std::nullopt;
}

Rejection take(
  const nav_msgs::msg::Odometry & message, OdometrySample & sample, stetro_site::Pose & odom)
{
  const auto & twist = message.twist().twist();
  const auto & pose = message.pose().pose();
  const auto & at = pose.position();
  sample = {
    time_of(message.header().stamp()), twist.linear().x(), twist.linear().y(), twist.angular().z()};
  const double sum = sample.vx_mps + sample.vy_mps + sample.wz_radps + at.x() + at.y() + at.z();
  if (!std::isfinite(sum) || !is_upright(pose.orientation())) {
    return stetro_dds::Refusal{"not_finite", "a speed, the position or the orientation"};
  }
  odom = {at.x(), at.y(), at.z(), yaw_of(pose.orientation())};
  return std::nullopt;
}

Rejection take(
  const geometry_msgs::msg::PoseWithCovarianceStamped & message, stetro_site::Pose & pose,
  stetro_site::Covariance & covariance)
{
  return take_pose(message.pose(), pose, covariance);
}

Rejection take(const stetro_msgs::msg::PoseCorrection & message, PoseCorrection & correction)
{
  const std::string frame = message.header().frame_id().c_str();
  const std::string segment = message.segment_id().c_str();
  if (frame.empty() || frame != segment) {
    return stetro_dds::Refusal{
      "frame", "'" + frame + "' of segment '" + segment + "', accepted: a floor's own frame"};
  }
  correction.stamp = time_of(message.header().stamp());
  correction.floor_id = segment;
  correction.reset_counter = message.reset_counter();
  return take_pose(message.pose(), correction.pose, correction.covariance);
}

Rejection refusal_of(Verdict verdict)
{
  if (!verdict.is_refused()) {
    return std::nullopt;
  }
  return stetro_dds::Refusal{to_string(verdict.refusal)};
}

}  // namespace stetro_localizer
