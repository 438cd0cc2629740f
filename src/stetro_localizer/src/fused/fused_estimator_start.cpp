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

// How the estimator begins, is told where it is, and what it leaves for the next time.

#include <algorithm>
#include <cmath>

#include "stetro_localizer/fused_estimator.hpp"

namespace stetro_localizer
{
namespace
{

double squared(double value) { return value * value; }

}  // namespace

void FusedEstimator::begin(const StateReading & stored)
{
  FusedCore core = model_.begin();
  switch (stored.kind) {
    case StateReading::Kind::kMissing:
      if (params_.initial_step == 0) {
        core.steps.assume_foot();
      } else if (params_.initial_step > 0) {
        core.steps.tell(static_cast<int>(params_.initial_step));
      }
      break;
    case StateReading::Kind::kDamaged:
      begin_reasons_ = kNotInitialised | kCalibrationDamaged;
      break;
    case StateReading::Kind::kFound: {
      const ScalarEstimate & bias = stored.state.calibration.gyro_bias;
      core.filter.set(kStateGyroBias, bias.value, bias.variance);
      if (stored.state.fused) {
        core.filter.set_calibration(*stored.state.fused);
      }
      estimate_.reset_counter = stored.state.reset_counter;
      note_reset(estimate_, ResetCause::kRestarted, estimate_.pose);
      const auto & step = stored.state.step;
      if (step && stored.state.segment_id == flight_.id() && core.steps.has(step->step)) {
        core.steps.restore(*step);
        core.filter.set(kStateYaw, 0.0, squared(params_.heading.restart_sigma_rad));
      }
      break;
    }
  }
  history_.restart(core);
}

std::optional<std::string> FusedEstimator::tell_pose(
  const stetro_site::Pose & pose, const stetro_site::Covariance & covariance)
{
  if (const auto why = implausible(pose, flight_, params_.heading.max_incidence_rad)) {
    return why;
  }
  const int step = flight_.step_at(pose.x_m);
  FusedCore core = history_.core();
  core.steps.tell(step);
  model_.locate(core, step);
  core.filter.set(kStateX, pose.x_m - core.edge_x_m, told_variance(covariance, 0));
  core.filter.set(kStateY, pose.y_m, told_variance(covariance, 1));
  core.filter.set(kStateYaw, pose.yaw_rad, told_variance(covariance, 5));
  history_.restart(core);
  refresh(ResetCause::kTold);
  return std::nullopt;
}

StoredState FusedEstimator::state_to_store() const
{
  const FusedCore & core = history_.core();
  StoredState state;
  state.segment_id = flight_.id();
  state.step = core.steps.state_to_store();
  state.calibration.gyro_bias = {core.filter[kStateGyroBias], core.filter.variance(kStateGyroBias)};
  state.fused = core.filter.calibration();
  state.reset_counter = estimate_.reset_counter;
  return state;
}

// A late sample may take landmarks back; resets only grow.
std::uint64_t FusedEstimator::state_version() const
{
  return (std::uint64_t{estimate_.reset_counter} << 32) + history_.core().landmarks;
}

}  // namespace stetro_localizer
