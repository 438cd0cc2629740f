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

#include "stetro_localizer/paper_estimator.hpp"

namespace stetro_localizer
{

void PaperEstimator::begin(const StateReading & stored)
{
  switch (stored.kind) {
    case StateReading::Kind::kMissing:
      if (params_.initial_step == 0) {
        steps_.assume_foot();
        foot_assumed_ = true;
      } else if (params_.initial_step > 0) {
        steps_.tell(static_cast<int>(params_.initial_step));
      }
      return;
    case StateReading::Kind::kDamaged:
      step_reasons_ = kNotInitialised | kCalibrationDamaged;
      return;
    case StateReading::Kind::kFound:
      break;
  }
  const Calibration & calibration = stored.state.calibration;
  heading_.set_calibration(calibration.front_difference, calibration.gyro_bias);
  lateral_.set_offset(Side::kLeft, calibration.left);
  lateral_.set_offset(Side::kRight, calibration.right);
  estimate_.reset_counter = stored.state.reset_counter;
  note_reset(estimate_, ResetCause::kRestarted, estimate_.pose);
  const auto & step = stored.state.step;
  if (step && stored.state.segment_id == flight_.id() && steps_.has(step->step)) {
    steps_.restore(*step);
    heading_.assume_aligned(params_.heading.restart_sigma_rad);
  }
}

std::optional<std::string> PaperEstimator::tell_pose(
  const stetro_site::Pose & pose, const stetro_site::Covariance & covariance)
{
  if (const auto why = implausible(pose, flight_, params_.heading.max_incidence_rad)) {
    return why;
  }
  const int step = flight_.step_at(pose.x_m);
  steps_.tell(step);
  told_step_ = step;
  foot_assumed_ = false;
  floor_x_m_ = pose.x_m;
  floor_travel_m_ = travel_x_m_;
  lateral_.reset(pose.y_m, told_variance(covariance, 1));
  heading_.reset(pose.yaw_rad, told_variance(covariance, 5));
  closure_.clear();
  ++jumps_.told;
  ++step_changes_;
  refresh(estimate_.stamp);
  return std::nullopt;
}

StoredState PaperEstimator::state_to_store() const
{
  StoredState state;
  state.segment_id = flight_.id();
  state.step = steps_.state_to_store();
  state.calibration = {
    lateral_.offset(Side::kLeft), lateral_.offset(Side::kRight), heading_.difference_offset(),
    heading_.gyro_bias()};
  state.reset_counter = estimate_.reset_counter;
  return state;
}

std::uint64_t PaperEstimator::state_version() const
{
  return step_changes_ + lateral_.calibrations() + heading_.calibrations() +
         estimate_.reset_counter;
}

}  // namespace stetro_localizer
