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

// What the estimator answers: position, covariance, integrity and jumps.

#include <algorithm>
#include <cmath>

#include "stetro_localizer/paper_estimator.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kTilt = 0.0175;  // a block stands level within this [rad]

double squared(double value) { return value * value; }

}  // namespace

void PaperEstimator::refresh(Nanoseconds stamp)
{
  const stetro_site::Pose before = estimate_.pose;
  estimate_.stamp = std::max(estimate_.stamp, stamp);
  refresh_position();
  refresh_covariance();
  refresh_integrity();
  estimate_.contact_closure_m = closure_.error_m();
  count_resets(before);
}

void PaperEstimator::refresh_position()
{
  const auto step = steps_.awaiting_blocks() ? told_step_ : steps_.step();
  estimate_.step = step;
  estimate_.pose = {kUnknown, lateral_.y_m().value_or(kUnknown), kUnknown, heading_.yaw_rad()};
  estimate_.tread_x_m = kUnknown;
  estimate_.tread_y_m = estimate_.pose.y_m;
  estimate_.block_heights_m =
    steps_.heights_in_flight().value_or(std::array<double, 3>{kUnknown, kUnknown, kUnknown});
  if (!step) {
    return;
  }
  estimate_.pose.z_m = flight_.tread_z_m(*step);
  if (*step == 0) {
    estimate_.pose.x_m = floor_x_m_ + travel_x_m_ - floor_travel_m_;
  } else {
    estimate_.pose.x_m = flight_.tread_centre_m(*step);
    estimate_.tread_x_m = estimate_.pose.x_m - flight_.tread_start_m(*step);
  }
}

void PaperEstimator::refresh_covariance()
{
  const LateralView view = lateral_view();
  auto & covariance = estimate_.covariance;
  covariance.setZero();
  // x is a choice, not a measurement: the robot is anywhere on its tread.
  const int step = estimate_.step.value_or(0);
  const double room_m = flight_.tread_m(std::max(step, 1));
  covariance(0, 0) = squared(room_m) / 12.0;
  covariance(1, 1) = lateral_.variance_m2(view);
  covariance(2, 2) = squared(params_.rise_sigma_m) * std::max(step, 1);
  covariance(3, 3) = squared(kTilt);
  covariance(4, 4) = squared(kTilt);
  covariance(5, 5) = view.yaw_variance;
  covariance(1, 5) = covariance(5, 1) = lateral_.slope_yaw() * view.yaw_variance;
  // A whole tread of doubt in x: what the treads below differ is nothing beside it.
  estimate_.tread_covariance = covariance;
  estimate_.tread_covariance(2, 2) = squared(params_.rise_sigma_m);
}

void PaperEstimator::refresh_integrity()
{
  const auto flag = [](bool raised, std::uint32_t reason) { return raised ? reason : 0u; };
  const bool known = steps_.step().has_value();
  std::uint32_t reasons = 0;
  if (!known) {
    reasons |= steps_.awaiting_blocks() ? std::uint32_t{kNotInitialised} : step_reasons_;
  }
  const double yaw_sigma = std::sqrt(heading_.reference_variance());
  reasons |= flag(!lateral_.measured(), kNoSideRange);
  const bool x_unknown = known && std::isnan(estimate_.pose.x_m);  // on the floor, no riser seen
  reasons |= flag(yaw_sigma > params_.heading.sigma_limit_rad || x_unknown, kNoFrontReference);
  reasons |= flag(silent_, kInputSilent);
  reasons |= flag(!lateral_.closes(), kClosureViolated);
  reasons |= flag(known && (outside_tread_ || foot_assumed_), kStepUncertain);
  const bool conflict = switch_conflict_ || steps_.evidence_conflicts() ||
                        reports_[Source::kBumperLeft].outcome == Outcome::kGated ||
                        reports_[Source::kBumperRight].outcome == Outcome::kGated;
  reasons |= flag(conflict, kContactConflict);
  estimate_.reasons = reasons;
  estimate_.integrity = integrity_of(reasons, known);
}

void PaperEstimator::count_resets(const stetro_site::Pose & before)
{
  if (std::isnan(estimate_.pose.y_m)) {
    return;  // it is counted when there is something to have jumped to
  }
  const ResetCause cause = jumped();
  if (cause != ResetCause::kNone) {
    note_reset(estimate_, cause, before);
  }
}

// What happens between two answers is one jump; the first that applies names it.
ResetCause PaperEstimator::jumped()
{
  const Jumps counted = jumps_counted_;
  jumps_.across = lateral_.restarts();
  jumps_.heading = heading_.restarts();
  jumps_counted_ = jumps_;
  if (jumps_.told != counted.told) {
    return ResetCause::kTold;
  }
  if (jumps_.undone != counted.undone) {
    return ResetCause::kStepUndone;
  }
  if (jumps_.across != counted.across) {
    return ResetCause::kAcrossAnew;
  }
  return jumps_.heading != counted.heading ? ResetCause::kHeadingAnew : ResetCause::kNone;
}

const std::vector<Source> & PaperEstimator::compared() const
{
  static const std::vector<Source> kCompared{Source::kSideLeft,    Source::kSideRight,
                                             Source::kFrontPair,   Source::kBumperLeft,
                                             Source::kBumperRight, Source::kRiserSwitches};
  return kCompared;
}

std::vector<Bias> PaperEstimator::biases() const
{
  return {
    {"side_left", lateral_.offset(Side::kLeft).offset},
    {"side_right", lateral_.offset(Side::kRight).offset},
    {"front_pair", heading_.difference_offset().offset},
    {"gyro", heading_.gyro_bias()}};
}

}  // namespace stetro_localizer
