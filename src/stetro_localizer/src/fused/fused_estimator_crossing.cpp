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

#include "stetro_localizer/fused_estimator.hpp"

namespace stetro_localizer
{
namespace
{

// The states that a floor's filter has as well, in its order.
constexpr std::array<int, kFloorCount> kShared{
  kStateX, kStateY, kStateYaw, kStateGyroBias, kStateOdomScale};

}  // namespace

Legacy FusedEstimator::legacy() const { return legacy_of(estimate_, reports_, state_to_store()); }

std::optional<Crossing> FusedEstimator::leave() const
{
  const FusedCore & core = history_.core();
  if (!core.located_on) {
    return std::nullopt;
  }
  Crossing crossing;
  crossing.time = estimate_.stamp;
  crossing.pose = segment_.T_map_segment.to_map(estimate_.pose);
  const ErrorStateFilter & filter = core.filter;
  crossing.state << crossing.pose.x_m, crossing.pose.y_m, crossing.pose.yaw_rad,
    filter[kStateGyroBias], filter[kStateOdomScale];
  FloorMatrix covariance;
  for (int i = 0; i < kFloorCount; ++i) {
    for (int j = 0; j < kFloorCount; ++j) {
      covariance(i, j) = filter.covariance()(
        kShared[static_cast<std::size_t>(i)], kShared[static_cast<std::size_t>(j)]);
    }
  }
  // In the flight frame x is edge + x, and what is published differs by what is withheld: as
  // published for the pose, and the edge's own share for the rest.
  covariance.topLeftCorner<3, 3>() = stetro_site::planar(estimate_.covariance);
  for (const int i : {kFloorGyroBias, kFloorOdomScale}) {
    const double edge = filter.edge_covariance()[kShared[static_cast<std::size_t>(i)]];
    covariance(i, kFloorX) += edge;
    covariance(kFloorX, i) += edge;
  }
  crossing.covariance = turned(covariance, flight_.spec().pose_in_map.yaw_rad);
  crossing.z_variance = estimate_.covariance(2, 2);
  crossing.legacy = legacy();
  return crossing;
}

void FusedEstimator::enter(const Legacy & legacy)
{
  take_over(estimate_, legacy);
  reports_ = legacy.reports;
  FusedCore core = model_.begin();
  core.reports = legacy.reports;
  if (legacy.calibration.fused) {
    core.filter.set_calibration(*legacy.calibration.fused);
  }
  const ScalarEstimate & bias = legacy.calibration.calibration.gyro_bias;
  core.filter.set(kStateGyroBias, bias.value, bias.variance);
  history_.restart(core, legacy.stamp);
  jumps_counted_ = core.jumps;
  begin_reasons_ = kNotInitialised;
  located_once_ = true;
  watch_ = InputWatch(params_.silence_s);
}

// The blocks stood level on the floor: the step filter hears of it at once, and counts from there.
void FusedEstimator::enter(const Crossing & crossing, const LastSamples & last)
{
  enter(crossing.legacy);
  FusedCore core = history_.core();
  core.contacts = last.contacts();
  core.steps.tell(0);
  model_.locate(core, 0);
  for (const BlockSample & blocks : last.blocks()) {
    const double age_s = seconds(crossing.time - blocks.stamp);
    if (blocks.stamp != Nanoseconds{0} && age_s >= 0.0 && age_s <= params_.silence_s) {
      model_.take(core, blocks);
    }
  }
  if (!core.located_on) {  // they stand as they cannot at a foot: as if told, they will be heard
    core.steps.tell(0);
    model_.locate(core, 0);
  }
  if (last.wheels().stamp != Nanoseconds{0}) {
    model_.take(core, last.wheels());
  }
  core.rate_radps = last.gyro().rate_radps;
  core.gyro_time = core.gyro_lived_at = last.gyro().stamp;
  core.time = core.since = crossing.time;

  const stetro_site::Pose pose = segment_.T_map_segment.to_frame(crossing.pose);
  FloorVector state = crossing.state;
  state.head<3>() << pose.x_m - core.edge_x_m, pose.y_m, pose.yaw_rad;
  core.filter.set<kFloorCount>(
    kShared, state, turned(crossing.covariance, -flight_.spec().pose_in_map.yaw_rad));
  core.rise_m = pose.z_m;
  jumps_counted_ = core.jumps;
  history_.restart(core, crossing.time);
  refresh();
}

}  // namespace stetro_localizer
