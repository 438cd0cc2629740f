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

// What the estimator on floors answers: pose, protection levels and integrity.

#include <cmath>

#include "stetro_localizer/floor_estimator.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kTilt = 0.0175;  // the body stands level within this [rad]

std::uint32_t flag(bool raised, std::uint32_t reason) { return raised ? reason : 0u; }

}  // namespace

void FloorEstimator::refresh_pose()
{
  const FloorFilter & filter = now_.filter;
  const bool on_floor = now_.gate.floor() >= 0;
  estimate_.step = on_floor ? std::optional<int>(0) : std::nullopt;
  estimate_.step_probability = kUnknown;
  estimate_.covariance.setZero();
  estimate_.pose = {kUnknown, kUnknown, kUnknown, kUnknown};
  estimate_.block_heights_m = {kUnknown, kUnknown, kUnknown};
  if (!pose_told_) {
    return;
  }
  estimate_.pose = {filter[kFloorX], filter[kFloorY], z_m_, filter[kFloorYaw]};
  stetro_site::set_planar(estimate_.covariance, filter.covariance().topLeftCorner<3, 3>());
  estimate_.covariance(2, 2) = z_variance_;
  estimate_.covariance(3, 3) = estimate_.covariance(4, 4) = kTilt * kTilt;
  estimate_.tread_covariance = estimate_.covariance;
  for (std::size_t i = 0; i < block_heights_m_.size(); ++i) {
    estimate_.block_heights_m[i] = z_m_ + block_heights_m_[i];
  }
}

// The doubt of the filter at the integrity risk, along and across the body. A slip is rare and
// long, no part of a normal distribution, and nothing sees it at once: it adds as a whole.
void FloorEstimator::refresh_protection()
{
  estimate_.integrity_risk = params_.fused.integrity_risk;
  estimate_.protection_along_m = estimate_.protection_across_m = kUnknown;
  estimate_.protection_heading_rad = kUnknown;
  if (!located()) {
    return;
  }
  const FloorFilter & filter = now_.filter;
  const FloorMatrix of_body = turned(filter.covariance(), -filter[kFloorYaw]);
  const auto bound = [&](int index) { return risk_quantile_ * std::sqrt(of_body(index, index)); };
  const FloorAlerts & alert = params_.floor.alerts;
  estimate_.protection_along_m = bound(kFloorX) + alert.unseen_slip_m;
  estimate_.protection_across_m = bound(kFloorY) + alert.unseen_slip_m;
  estimate_.protection_heading_rad = bound(kFloorYaw) + alert.unseen_turn_rad;
}

void FloorEstimator::refresh_integrity()
{
  const FloorAlerts & alert = params_.floor.alerts;
  const CorrectionGate & gate = now_.gate;
  std::uint32_t reasons = flag(silent_, kInputSilent);
  reasons |= flag(model_.gyro_stuck(now_), kSensorStuck);
  const bool gyro_gated = now_.reports[0].reject_streak >= params_.fused.alerts.reject_streak;
  reasons |= flag(gyro_gated || model_.turns_conflict(now_), kSlip);
  reasons |= flag(gate.trust() == CorrectionGate::Trust::kNever, begin_reasons_);
  reasons |=
    flag(gate.trust() == CorrectionGate::Trust::kLost || gate.refused() > 0, kProfileDisagrees);
  const bool exceeded = estimate_.protection_along_m > alert.along_m ||
                        estimate_.protection_across_m > alert.along_m ||
                        estimate_.protection_heading_rad > alert.heading_rad;
  reasons |= flag(exceeded, kProtectionExceeded);
  estimate_.reasons = reasons;
  estimate_.integrity = integrity_of(reasons, located());
}

const std::vector<Source> & FloorEstimator::compared() const
{
  static const std::vector<Source> kCompared{
    Source::kCorrectionX, Source::kCorrectionY, Source::kCorrectionHeading};
  return kCompared;
}

std::vector<Bias> FloorEstimator::biases() const
{
  const FloorFilter & filter = now_.filter;
  return {
    {"gyro", {filter[kFloorGyroBias], filter.variance(kFloorGyroBias)}},
    {"odometry_scale", {filter[kFloorOdomScale], filter.variance(kFloorOdomScale)}}};
}

}  // namespace stetro_localizer
