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

// How the estimator on floors begins, is told where it is, and what it hands on.

#include <cmath>

#include "stetro_localizer/floor_estimator.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kLevel = 0.003;  // a floor against its elevation [m]
constexpr double kHeight = 0.10;  // a told z is that of the floor within this [m]
constexpr std::size_t kScale = FusedCalibration::kSize - 1;  // of the wheels

}  // namespace

std::optional<std::string> implausible_on_floor(const stetro_site::Pose & pose)
{
  if (!std::isfinite(pose.x_m + pose.y_m + pose.z_m + pose.yaw_rad)) {
    return "a number of the pose is not finite";
  }
  if (std::abs(pose.z_m) > kHeight) {
    return "z " + std::to_string(pose.z_m) + " m is not the floor's, accepted: -0.1 to 0.1 m";
  }
  return std::nullopt;
}

FloorCore FloorEstimator::core_with_calibration(const StoredState & stored) const
{
  FloorCore core = model_.begin();
  FloorVector state = core.filter.state();
  FloorMatrix covariance = core.filter.covariance();
  const ScalarEstimate & bias = stored.calibration.gyro_bias;
  if (bias.variance > 0.0) {
    state[kFloorGyroBias] = bias.value;
    covariance(kFloorGyroBias, kFloorGyroBias) = bias.variance;
  }
  if (stored.fused) {
    state[kFloorOdomScale] = stored.fused->value[kScale];
    covariance(kFloorOdomScale, kFloorOdomScale) = stored.fused->covariance[kScale][kScale];
  }
  core.filter.set(state, covariance);
  core.gate.distrust(CorrectionGate::Trust::kNever, chosen_);
  return core;
}

// A robot may have been carried while nobody watched: what was stored is no pose.
void FloorEstimator::begin(const StateReading & stored)
{
  begin_reasons_ = kNotInitialised;
  if (stored.kind == StateReading::Kind::kDamaged) {
    begin_reasons_ |= kCalibrationDamaged;
  }
  if (stored.kind == StateReading::Kind::kFound) {
    stored_ = stored.state;
    estimate_.reset_counter = stored.state.reset_counter;
  }
  history_.restart(core_with_calibration(stored_));
  refresh();
  if (stored.kind == StateReading::Kind::kFound) {
    note_reset(estimate_, ResetCause::kRestarted, estimate_.pose);
  }
}

void FloorEstimator::enter(const Legacy & legacy)
{
  take_over(estimate_, legacy);
  reports_ = legacy.reports;
  stored_ = legacy.calibration;
  begin_reasons_ = kNotInitialised;
  FloorCore core = core_with_calibration(stored_);
  for (std::size_t i = 1; i < core.reports.size(); ++i) {
    const std::size_t first = static_cast<std::size_t>(Source::kCorrectionX);
    core.reports[i] = reports_[static_cast<Source>(first + i - 1)];
  }
  resets_counted_ = core.resets;
  pose_told_ = false;
  z_m_ = 0.0;
  z_variance_ = kLevel * kLevel;
  last_fix_ = Nanoseconds{0};
  last_stamp_.fill(legacy.stamp);
  block_heights_m_.fill(kUnknown);
  watch_ = InputWatch(params_.silence_s);
  silent_ = false;
  history_.restart(core, legacy.stamp);
  refresh();
}

void FloorEstimator::enter(const Crossing & crossing, const LastSamples & last)
{
  enter(crossing.legacy);
  FloorCore core = history_.core();
  const Segment & floor = floors_.at(static_cast<std::size_t>(chosen_));
  const stetro_site::Pose pose = floor.T_map_segment.to_frame(crossing.pose);
  const double turn_rad = floor.T_map_segment.to_frame(stetro_site::Pose{}).yaw_rad;
  FloorVector state = crossing.state;
  state.head<3>() << pose.x_m, pose.y_m, pose.yaw_rad;
  core.filter.set(state, turned(crossing.covariance, turn_rad));
  core.gate.trust(chosen_);
  core.time = core.turned_to = core.moved_to = crossing.time;
  core.contacts = last.contacts();
  if (last.wheels().stamp != Nanoseconds{0}) {
    core.standstill.note(last.wheels());
    core.wheels = last.wheels();
  }
  core.rate_radps = last.gyro().rate_radps;
  core.gyro_time = core.gyro_lived_at = last.gyro().stamp;
  z_m_ = pose.z_m;
  z_variance_ = crossing.z_variance;
  for (std::size_t i = 0; i < block_heights_m_.size(); ++i) {
    block_heights_m_[i] = last.block().blocks[i].height_m;
  }
  history_.restart(core, crossing.time);
  refresh();
}

std::optional<std::string> FloorEstimator::tell_pose(
  const stetro_site::Pose & pose, const stetro_site::Covariance & covariance)
{
  if (auto why = implausible_on_floor(pose)) {
    return why;
  }
  if (chosen_ < 0) {
    return "no floor was named";
  }
  PoseFix fix;
  fix.pose << pose.x_m, pose.y_m, pose.yaw_rad;
  fix.covariance =
    Eigen::Vector3d(
      told_variance(covariance, 0), told_variance(covariance, 1), told_variance(covariance, 5))
      .asDiagonal();
  FloorCore core = history_.core();
  model_.advance(core, core.time);
  core.filter.set_pose(fix);
  core.gate.trust(chosen_);
  z_m_ = 0.0;
  z_variance_ = kLevel * kLevel;
  history_.restart(core, core.time);
  last_fix_ = core.time;
  refresh(ResetCause::kTold);
  return std::nullopt;
}

Legacy FloorEstimator::legacy() const { return legacy_of(estimate_, reports_, state_to_store()); }

std::optional<Crossing> FloorEstimator::leave() const
{
  if (!located() || now_.gate.refused() > 0) {
    return std::nullopt;
  }
  Crossing crossing;
  crossing.time = now_.time;
  const stetro_site::FrameTransform & T_map_floor = segment().T_map_segment;
  crossing.pose = T_map_floor.to_map(estimate_.pose);
  crossing.state = now_.filter.state();
  crossing.state.head<3>() << crossing.pose.x_m, crossing.pose.y_m, crossing.pose.yaw_rad;
  crossing.covariance =
    turned(now_.filter.covariance(), T_map_floor.to_map(stetro_site::Pose{}).yaw_rad);
  crossing.z_variance = z_variance_;
  crossing.legacy = legacy();
  return crossing;
}

StoredState FloorEstimator::state_to_store() const
{
  StoredState state = stored_;
  state.segment_id = segment().id;
  state.step.reset();
  const FloorFilter & filter = now_.filter;
  state.calibration.gyro_bias = {filter[kFloorGyroBias], filter.variance(kFloorGyroBias)};
  if (state.fused) {  // what the scale has in common with the range sensors is past
    for (std::size_t i = 0; i < kScale; ++i) {
      state.fused->covariance[i][kScale] = state.fused->covariance[kScale][i] = 0.0;
    }
    state.fused->value[kScale] = filter[kFloorOdomScale];
    state.fused->covariance[kScale][kScale] = filter.variance(kFloorOdomScale);
  }
  state.reset_counter = estimate_.reset_counter;
  return state;
}

std::uint64_t FloorEstimator::state_version() const
{
  return (std::uint64_t{estimate_.reset_counter} << 32) + now_.landmarks;
}

}  // namespace stetro_localizer
