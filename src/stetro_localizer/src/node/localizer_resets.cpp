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

// Poses that a person tells, corrections, and what is said of each jump of the estimate.

#include <cmath>
#include <cstdio>
#include <string>

#include "node/localizer_parts.hpp"

namespace stetro_localizer
{
namespace
{

using Rejection = std::optional<stetro_dds::Refusal>;

constexpr std::chrono::seconds kSaidAgain{1};  // a refusal like the last one, in the log

std::string moved(const char * axis, double by, const char * unit)
{
  char text[48];
  if (std::isfinite(by)) {
    std::snprintf(text, sizeof(text), "%s %+.3f %s", axis, by, unit);
  } else {
    std::snprintf(text, sizeof(text), "%s from unknown", axis);
  }
  return text;
}

}  // namespace

Rejection LocalizerNode::Parts::take_told_pose(
  const geometry_msgs::msg::PoseWithCovarianceStamped & message)
{
  auto rejection = judge_told_pose(message);
  if (!rejection) {
    ++told_poses_.taken;
    const auto & at = message.pose().pose().position();
    node_.log().info(
      "initialpose taken: x {:.3f} m, y {:.3f} m in {}", at.x(), at.y(),
      message.header().frame_id().c_str());
    if (estimator_->estimate().stamp > Nanoseconds{0}) {
      publish();
    }
    store();
    return rejection;
  }
  ++told_poses_.refused;
  const Nanoseconds now = stetro_dds::Clock::steady_now();
  const bool another = rejection->reason != told_poses_.last_refusal.reason;
  if (another || now - told_poses_.last_logged > kSaidAgain) {
    node_.log().warn("initialpose refused, {}: {}", rejection->reason, rejection->detail);
    told_poses_.last_logged = now;
  }
  told_poses_.last_refusal = *rejection;
  return rejection;
}

Rejection LocalizerNode::Parts::judge_told_pose(
  const geometry_msgs::msg::PoseWithCovarianceStamped & message)
{
  StampGuard order = told_poses_.order;  // one that is refused leaves no trace in it
  const Nanoseconds stamp = time_of(message.header().stamp());
  const Nanoseconds now = node_.clock().now();
  if (const Refusal unfit = order.accept(stamp, now); unfit != Refusal::kNone) {
    return stetro_dds::Refusal{
      to_string(unfit), "stamped " + std::to_string(seconds(now - stamp)) +
                          " s before the robot's clock, accepted: 0 to " +
                          std::to_string(ToldPoses::kOldest.count()) +
                          " s, and after the last one taken"};
  }
  stetro_site::Pose pose;
  stetro_site::Covariance covariance;
  if (auto rejection = take(message, pose, covariance)) {
    return rejection;
  }
  const std::string frame = message.header().frame_id().c_str();
  if (const auto refused = estimator_->tell_pose(frame, pose, covariance)) {
    return stetro_dds::Refusal{refused->reason, refused->detail};
  }
  told_poses_.order = order;
  return std::nullopt;
}

Rejection LocalizerNode::Parts::take_correction(const stetro_msgs::msg::PoseCorrection & message)
{
  PoseCorrection correction;
  if (auto rejection = take(message, correction)) {
    ++unfit_corrections_;
    return rejection;
  }
  const CorrectionOutcome outcome = estimator_->take_correction(correction, node_.clock().now());
  if (outcome != told_correction_) {
    node_.log().log(
      was_taken(outcome) ? spdlog::level::info : spdlog::level::warn, "pose_correction on {}: {}",
      correction.floor_id, to_string(outcome));
    told_correction_ = outcome;
  }
  if (outcome == CorrectionOutcome::kReset || outcome == CorrectionOutcome::kGatedLost) {
    publish();
    store();
  }
  if (was_taken(outcome)) {
    return std::nullopt;
  }
  return stetro_dds::Refusal{to_string(outcome), "of " + correction.floor_id};
}

void LocalizerNode::Parts::tell_resets(const StairEstimate & estimate)
{
  if (estimate.reset_counter == told_resets_) {
    return;
  }
  told_resets_ = estimate.reset_counter;
  const bool meant =
    estimate.reset_cause == ResetCause::kTold || estimate.reset_cause == ResetCause::kRestarted;
  const stetro_site::Pose & delta = estimate.reset_delta;
  node_.log().log(
    meant ? spdlog::level::info : spdlog::level::warn, "reset {}: {}, moved {}, {}, {}, {}",
    estimate.reset_counter, to_string(estimate.reset_cause), moved("x", delta.x_m, "m"),
    moved("y", delta.y_m, "m"), moved("z", delta.z_m, "m"),
    moved("heading", delta.yaw_rad * 180.0 / M_PI, "deg"));
}

}  // namespace stetro_localizer
