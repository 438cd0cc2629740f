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

#include "stetro_localizer/floor_estimator.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "stetro_localizer/fused/normal_quantile.hpp"
#include "stetro_localizer/sample_fault.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kSamplesPerSecond = 300.0;  // gyroscope and wheels at 100 Hz, and some room

std::size_t capacity_for(double window_s)
{
  return static_cast<std::size_t>(window_s * kSamplesPerSecond) + 64;
}

std::vector<Segment> segments_of(const std::vector<stetro_site::Floor> & floors)
{
  std::vector<Segment> segments;
  for (const stetro_site::Floor & floor : floors) {
    segments.push_back(segment_of(floor));
  }
  return segments;
}

PoseFix fix_of(const stetro_site::Pose & pose, const stetro_site::Covariance & covariance)
{
  PoseFix fix;
  fix.pose << pose.x_m, pose.y_m, pose.yaw_rad;
  fix.covariance = stetro_site::planar(covariance);
  return fix;
}

bool is_fit(const PoseFix & fix)
{
  const bool finite = fix.pose.allFinite() && fix.covariance.allFinite();
  const Eigen::Matrix3d & R = fix.covariance;
  return finite && (R - R.transpose()).cwiseAbs().maxCoeff() <= 1e-9 * R.cwiseAbs().maxCoeff() &&
         Eigen::LDLT<Eigen::Matrix3d>(R).isPositive();
}

}  // namespace

FloorEstimator::FloorEstimator(const LocalizerParams & params, const stetro_site::Site & site)
: params_(params),
  floors_(segments_of(site.floors())),
  model_(params),
  history_(
    model_, model_.begin(), nanoseconds(params.floor.window_s),
    capacity_for(params.floor.window_s)),
  now_(model_.begin()),
  watch_(params.silence_s),
  risk_quantile_(protection_quantile(params.fused.integrity_risk))
{
}

const Segment & FloorEstimator::segment() const
{
  const int floor = now_.gate.floor();
  return floor < 0 ? nowhere_ : floors_[static_cast<std::size_t>(floor)];
}

Refusal FloorEstimator::fault_of_stamp(Nanoseconds stamp, Nanoseconds now) const
{
  if (stamp <= Nanoseconds{0}) {
    return Refusal::kZeroStamp;
  }
  if (stamp - now > nanoseconds(params_.future_tolerance_s)) {
    return Refusal::kFuture;
  }
  return now - stamp > nanoseconds(params_.max_sample_age_s) ? Refusal::kTooOld : Refusal::kNone;
}

Verdict FloorEstimator::take(
  Source input, const FloorSample & sample, Nanoseconds now, Refusal fault)
{
  fault = fault == Refusal::kNone ? fault_of_stamp(stamp_of(sample), now) : fault;
  Verdict verdict{Outcome::kFused, Refusal::kNone};
  if (fault != Refusal::kNone) {
    verdict = Verdict::refused(fault);
  } else {
    switch (history_.take(sample)) {
      case SampleHistory<FloorModel>::Taken::kYes:
        watch_.note(input, now);
        break;
      case SampleHistory<FloorModel>::Taken::kStale:
        verdict = {Outcome::kStale, Refusal::kNone};
        break;
      case SampleHistory<FloorModel>::Taken::kTwice:
        verdict = Verdict::refused(Refusal::kOutOfOrder);
        break;
    }
  }
  reports_[input].note(verdict);
  return verdict;
}

Verdict FloorEstimator::add_gyro(const GyroSample & sample, Nanoseconds now)
{
  return take(Source::kGyro, sample, now, fault_of(sample));
}

Verdict FloorEstimator::add_odometry(const OdometrySample & sample, Nanoseconds now)
{
  return take(Source::kOdometry, sample, now, fault_of(sample));
}

Verdict FloorEstimator::add_contacts(const ContactSample & sample, Nanoseconds now)
{
  return take(Source::kContacts, sample, now, Refusal::kNone);
}

// What the filter does not use must come nevertheless: the next flight needs it.
Verdict FloorEstimator::note(Source input, Nanoseconds stamp, Nanoseconds now, Refusal fault)
{
  fault = fault == Refusal::kNone ? fault_of_stamp(stamp, now) : fault;
  Nanoseconds & last = last_stamp_[static_cast<std::size_t>(input)];
  fault = fault == Refusal::kNone && stamp <= last ? Refusal::kOutOfOrder : fault;
  Verdict verdict{Outcome::kFused, Refusal::kNone};
  if (fault != Refusal::kNone) {
    verdict = Verdict::refused(fault);
  } else {
    last = stamp;
    watch_.note(input, now);
  }
  reports_[input].note(verdict);
  return verdict;
}

Verdict FloorEstimator::add_blocks(const BlockSample & sample, Nanoseconds now)
{
  const Verdict verdict = note(Source::kBlocks, sample.stamp, now, fault_of(sample));
  for (std::size_t i = 0; i < sample.blocks.size() && !verdict.is_refused(); ++i) {
    block_heights_m_[i] = sample.blocks[i].fault ? kUnknown : sample.blocks[i].height_m;
  }
  return verdict;
}

Verdict FloorEstimator::add_ranges(const RangeSample & sample, Nanoseconds now)
{
  const Verdict verdict = note(Source::kRanges, sample.stamp, now, Refusal::kNone);
  if (!verdict.is_refused()) {
    refresh();
  }
  return verdict;
}

void FloorEstimator::tick(Nanoseconds now)
{
  silent_ = watch_.any_silent(now);
  if (silent_ && now_.time > Nanoseconds{0}) {
    history_.look_ahead(now);
    refresh();
  } else {
    refresh_integrity();
  }
}

CorrectionOutcome FloorEstimator::take_correction(
  const PoseCorrection & correction, int floor, Nanoseconds now)
{
  PoseFix fix = fix_of(correction.pose, correction.covariance);
  const FloorParams & params = params_.floor;
  const double common_m2 = params.correction_sigma_m * params.correction_sigma_m;
  if (!is_fit(fix) || correction.stamp <= Nanoseconds{0}) {
    return CorrectionOutcome::kUnfit;
  }
  fix.covariance.diagonal() += Eigen::Vector3d(
    common_m2, common_m2, params.correction_sigma_rad * params.correction_sigma_rad);
  if (!(fix.covariance.ldlt().vectorD().minCoeff() > 0.0)) {
    return CorrectionOutcome::kUnfit;
  }
  if (correction.stamp - now > nanoseconds(params_.future_tolerance_s)) {
    return CorrectionOutcome::kFuture;
  }
  if (correction.reset_counter != estimate_.reset_counter) {
    return CorrectionOutcome::kStaleCounter;
  }
  if (correction.stamp <= last_fix_) {
    return CorrectionOutcome::kOutOfOrder;
  }
  if (history_.take(FloorFix{correction.stamp, floor, fix}) != decltype(history_)::Taken::kYes) {
    return CorrectionOutcome::kTooOld;
  }
  last_fix_ = correction.stamp;
  refresh();
  return now_.answer;
}

// The newest state, with heading and position brought to one time.
void FloorEstimator::refresh(ResetCause cause)
{
  const int floor_before = now_.gate.floor();
  now_ = history_.core();
  model_.advance(now_, now_.time);
  stetro_site::Pose before = estimate_.pose;
  const std::array<Source, 4> from{
    Source::kGyro, Source::kCorrectionX, Source::kCorrectionY, Source::kCorrectionHeading};
  for (std::size_t i = 1; i < from.size(); ++i) {
    reports_[from[i]] = now_.reports[i];
  }
  pose_told_ = pose_told_ || located();
  estimate_.stamp = std::max(estimate_.stamp, now_.time);
  if (now_.resets != resets_counted_) {
    resets_counted_ = now_.resets;
    cause = ResetCause::kCorrected;
    if (now_.gate.floor() != floor_before) {  // between two frames there is no distance
      before = {kUnknown, kUnknown, kUnknown, kUnknown};
      z_m_ = 0.0;
    }
  }
  refresh_pose();
  refresh_protection();
  refresh_integrity();
  if (cause != ResetCause::kNone) {
    note_reset(estimate_, cause, before);
  }
}

}  // namespace stetro_localizer
