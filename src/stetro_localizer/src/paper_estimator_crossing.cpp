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

// How the estimator begins at the foot of its flight, and hands over to the floor above.

#include <cmath>

#include "stetro_localizer/paper_estimator.hpp"

namespace stetro_localizer
{
namespace
{

// Block 3 meets the riser while block 2 is lowered: where base_link then is on its tread [m].
constexpr double kTouchDown = 0.075;

}  // namespace

Legacy PaperEstimator::legacy() const { return legacy_of(estimate_, reports_, state_to_store()); }

std::optional<Crossing> PaperEstimator::leave() const
{
  stetro_site::Pose pose = estimate_.pose;
  const auto & step = estimate_.step;
  if (step == flight_.steps()) {
    pose.x_m = flight_.tread_start_m(*step) + kTouchDown + travel_x_m_ - climbed_travel_m_;
  }
  if (!step || !std::isfinite(pose.x_m + pose.y_m + pose.z_m + pose.yaw_rad)) {
    return std::nullopt;
  }
  Crossing crossing;
  crossing.time = estimate_.stamp;
  crossing.pose = segment_.T_map_segment.to_map(pose);
  const ScalarEstimate bias = heading_.gyro_bias();
  crossing.state << crossing.pose.x_m, crossing.pose.y_m, crossing.pose.yaw_rad, bias.value, 0.0;
  FloorMatrix covariance = FloorMatrix::Zero();
  covariance.topLeftCorner<3, 3>() = stetro_site::planar(estimate_.covariance);
  covariance(kFloorGyroBias, kFloorGyroBias) = bias.variance;
  covariance(kFloorOdomScale, kFloorOdomScale) =
    params_.fused.priors.odom_scale * params_.fused.priors.odom_scale;
  crossing.covariance = turned(covariance, flight_.spec().pose_in_map.yaw_rad);
  crossing.z_variance = estimate_.covariance(2, 2);
  crossing.legacy = legacy();
  return crossing;
}

void PaperEstimator::enter(const Legacy & legacy)
{
  *this = PaperEstimator(params_, robot_, flight_);
  take_over(estimate_, legacy);
  reports_ = legacy.reports;
  const Calibration & calibration = legacy.calibration.calibration;
  heading_.set_calibration(calibration.front_difference, calibration.gyro_bias);
  lateral_.set_offset(Side::kLeft, calibration.left);
  lateral_.set_offset(Side::kRight, calibration.right);
}

void PaperEstimator::enter(const Crossing & crossing, const LastSamples & last)
{
  enter(crossing.legacy);
  const stetro_site::Pose pose = segment_.T_map_segment.to_frame(crossing.pose);
  steps_.tell(0);
  told_step_ = 0;
  for (const BlockSample & blocks : last.blocks()) {
    const double age_s = seconds(crossing.time - blocks.stamp);
    if (blocks.stamp != Nanoseconds{0} && age_s >= 0.0 && age_s <= params_.silence_s) {
      take_step_event(steps_.add(blocks, std::nullopt));
    }
  }
  floor_x_m_ = pose.x_m;
  floor_travel_m_ = travel_x_m_;
  lateral_.reset(pose.y_m, crossing.covariance(kFloorY, kFloorY));
  heading_.reset(pose.yaw_rad, crossing.covariance(kFloorYaw, kFloorYaw));
  jumps_.across = jumps_counted_.across = lateral_.restarts();
  jumps_.heading = jumps_counted_.heading = heading_.restarts();
  refresh(crossing.time);
}

}  // namespace stetro_localizer
