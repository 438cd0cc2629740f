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

#include "stetro_localizer/fused_estimator.hpp"

#include <algorithm>
#include <cmath>

#include "stetro_localizer/fused/normal_quantile.hpp"
#include "stetro_localizer/sample_fault.hpp"

namespace stetro_localizer
{
namespace
{

constexpr std::size_t kMostInWindow = 256;  // samples: a quarter second of every source, twice

}  // namespace

FusedEstimator::FusedEstimator(
  const LocalizerParams & params, const stetro_site::RobotGeometry & robot,
  const stetro_site::Flight & flight, bool floors_drawn)
: params_(params),
  flight_(flight),
  segment_(segment_of(flight)),
  floors_drawn_(floors_drawn),
  model_(params, robot, flight),
  history_(model_, model_.begin(), nanoseconds(params.fused.window_s), kMostInWindow),
  as_built_(flight.steps()),
  watch_(params.silence_s),
  ranges_(robot, params.fused.steps.bearing_load),
  switches_(robot),
  front_edge_m_(robot.block_x_m(2) + robot.block_length_m / 2.0),
  risk_quantile_(protection_quantile(params.fused.integrity_risk))
{
}

Refusal FusedEstimator::fault_of_stamp(Nanoseconds stamp, Nanoseconds now) const
{
  if (stamp <= Nanoseconds{0}) {
    return Refusal::kZeroStamp;
  }
  if (stamp - now > nanoseconds(params_.future_tolerance_s)) {
    return Refusal::kFuture;
  }
  return now - stamp > nanoseconds(params_.max_sample_age_s) ? Refusal::kTooOld : Refusal::kNone;
}

Verdict FusedEstimator::take(Source input, const Sample & sample, Nanoseconds now, Refusal fault)
{
  fault = fault == Refusal::kNone ? fault_of_stamp(stamp_of(sample), now) : fault;
  Verdict verdict{Outcome::kFused, Refusal::kNone};
  if (fault != Refusal::kNone) {
    verdict = Verdict::refused(fault);
  } else {
    switch (history_.take(sample)) {
      case History::Taken::kYes:
        as_built_.follow(history_.settled());
        watch_.note(input, now);
        watch_devices(sample);
        break;
      case History::Taken::kStale:
        verdict = {Outcome::kStale, Refusal::kNone};
        break;
      case History::Taken::kTwice:
        verdict = Verdict::refused(Refusal::kOutOfOrder);
        break;
    }
  }
  reports_[input].note(verdict);
  return verdict;
}

Verdict FusedEstimator::add_gyro(const GyroSample & sample, Nanoseconds now)
{
  const Verdict verdict = take(Source::kGyro, sample, now, fault_of(sample));
  if (verdict.outcome == Outcome::kFused) {
    follow_motion(turned_until_, sample.stamp);
  }
  return verdict;
}

Verdict FusedEstimator::add_odometry(const OdometrySample & sample, Nanoseconds now)
{
  const Verdict verdict = take(Source::kOdometry, sample, now, fault_of(sample));
  if (verdict.outcome == Outcome::kFused) {
    follow_motion(rolled_until_, sample.stamp);
  }
  return verdict;
}

// With one of the two alone the pose would turn and roll in turns.
void FusedEstimator::follow_motion(Nanoseconds & newest, Nanoseconds stamp)
{
  newest = std::max(newest, stamp);
  const bool begun = estimate_.stamp > Nanoseconds{0};
  if (begun && std::min(rolled_until_, turned_until_) > estimate_.stamp) {
    refresh();
  }
}

Verdict FusedEstimator::add_contacts(const ContactSample & sample, Nanoseconds now)
{
  const Verdict verdict = take(Source::kContacts, sample, now, Refusal::kNone);
  refresh_integrity();  // a switch that has died is told at once
  return verdict;
}

Verdict FusedEstimator::add_blocks(const BlockSample & sample, Nanoseconds now)
{
  return take(Source::kBlocks, sample, now, fault_of(sample));
}

// Every reading counts at its own time: those of one time make one sample of the filter.
Verdict FusedEstimator::add_ranges(const RangeSample & sample, Nanoseconds now)
{
  Refusal fault = fault_of_stamp(sample.stamp, now);
  fault = sample.stamp == last_array_ ? Refusal::kOutOfOrder : fault;
  if (fault != Refusal::kNone) {
    reports_[Source::kRanges].note(Verdict::refused(fault));
    return Verdict::refused(fault);
  }
  last_array_ = sample.stamp;
  RangeSample rest = new_readings(sample);
  Verdict verdict{Outcome::kNotVisible, Refusal::kNone};
  for (;;) {
    RangeSample one;
    for (const RangeReading & reading : rest.readings) {
      const bool earlier = one.stamp == Nanoseconds{0} || reading.stamp < one.stamp;
      one.stamp = reading.status != RangeStatus::kAbsent && earlier ? reading.stamp : one.stamp;
    }
    if (one.stamp == Nanoseconds{0}) {
      break;
    }
    for (std::size_t i = 0; i < rest.readings.size(); ++i) {
      if (rest.readings[i].stamp == one.stamp) {
        std::swap(one.readings[i], rest.readings[i]);
      }
    }
    verdict = take(Source::kRanges, one, now, Refusal::kNone);
  }
  refresh();
  return verdict;
}

// Those that the array before has not brought already and that are readings at all.
RangeSample FusedEstimator::new_readings(const RangeSample & sample)
{
  RangeSample fresh = sample;
  for (std::size_t i = 0; i < fresh.readings.size(); ++i) {
    RangeReading & reading = fresh.readings[i];
    if (reading.status == RangeStatus::kAbsent) {
      continue;
    }
    Refusal fault = reading.stamp == Nanoseconds{0} ? Refusal::kZeroStamp : Refusal::kNone;
    fault = fault == Refusal::kNone ? fault_of(reading) : fault;
    if (fault != Refusal::kNone) {
      reports_[Source::kRanges].note(Verdict::refused(fault));
    }
    const bool repeated = reading.stamp == last_reading_[i];
    last_reading_[i] = reading.stamp;
    reading.status = repeated || fault != Refusal::kNone ? RangeStatus::kAbsent : reading.status;
  }
  return fresh;
}

// Samples bring the next estimate; without them it is the prediction.
void FusedEstimator::tick(Nanoseconds now)
{
  silent_ = watch_.any_silent(now);
  if (silent_) {
    history_.look_ahead(now);
    refresh();
  } else {
    refresh_integrity();
  }
}

void FusedEstimator::refresh(ResetCause cause)
{
  const FusedCore & core = history_.core();
  const stetro_site::Pose before = estimate_.pose;
  const std::optional<int> step_before = estimate_.step;
  for (std::size_t i = static_cast<std::size_t>(Source::kSideLeft); i < kSourceCount; ++i) {
    reports_[static_cast<Source>(i)] = core.reports[static_cast<Source>(i)];
  }
  estimate_.stamp = std::max(estimate_.stamp, core.time);
  refresh_position();
  refresh_covariance();
  refresh_protection();
  refresh_integrity();
  estimate_.contact_closure_m = core.closure.error_m();
  const ResetCause own = jumped(step_before);
  cause = cause == ResetCause::kNone ? own : cause;
  if (cause != ResetCause::kNone) {
    note_reset(estimate_, cause, before);
  }
}

// The core counts how often x began anew. A late sample that makes such a jump undone is another
// jump of what was published. The first time is the beginning, not a jump.
ResetCause FusedEstimator::jumped(std::optional<int> step_before)
{
  const FusedCore & core = history_.core();
  const bool anew = core.jumps != jumps_counted_;
  const bool first = !located_once_;
  jumps_counted_ = core.jumps;
  located_once_ = located_once_ || core.located_on;
  if (anew && !first) {
    return ResetCause::kLocatedAgain;
  }
  const bool undone = step_before && core.located_on && *core.located_on < *step_before;
  return undone ? ResetCause::kStepUndone : ResetCause::kNone;
}

void FusedEstimator::refresh_position()
{
  const FusedCore & core = history_.core();
  const ErrorStateFilter & filter = core.filter;
  const double x_m = filter[kStateX] + core.hand_over.withheld_m(kStateX, core.time);
  const double y_m = filter[kStateY] + core.hand_over.withheld_m(kStateY, core.time);
  estimate_.step = core.located_on;
  estimate_.step_probability = core.steps.probability();
  estimate_.pose = {kUnknown, y_m, kUnknown, filter[kStateYaw]};
  estimate_.tread_y_m = y_m;
  estimate_.tread_x_m = estimate_.riser_ahead_m = kUnknown;
  estimate_.measured_x_m.reset();
  estimate_.block_heights_m =
    core.steps.heights_in_flight().value_or(std::array<double, 3>{kUnknown, kUnknown, kUnknown});
  if (!core.located_on) {
    return;
  }
  const int step = *core.located_on;
  estimate_.pose.x_m = core.edge_x_m + x_m;
  estimate_.pose.z_m = core.rise_m;  // base_link is on the tread, block 2 may be above it
  if (step > 0) {
    estimate_.tread_x_m = x_m + filter[kStateTreadHere];
  }
  if (step < flight_.steps()) {
    const double off_middle_m = y_m - filter[kStateWidth] / 2.0;
    estimate_.riser_ahead_m = off_middle_m * std::tan(filter[kStateRiserAhead]) - x_m;
  }
}

// Of -(riser ahead), or of the place behind the tread's own riser where there is none ahead.
StateVector FusedEstimator::slopes_along() const
{
  const FusedCore & core = history_.core();
  const ErrorStateFilter & filter = core.filter;
  StateVector slopes = StateVector::Unit(kStateX);
  if (core.located_on && *core.located_on >= flight_.steps()) {
    slopes[kStateTreadHere] = 1.0;
    return slopes;
  }
  const double slope = std::tan(filter[kStateRiserAhead]);
  slopes[kStateY] = -slope;
  slopes[kStateWidth] = slope / 2.0;
  slopes[kStateRiserAhead] = -(filter[kStateY] - filter[kStateWidth] / 2.0) * (1.0 + slope * slope);
  return slopes;
}

void FusedEstimator::refresh_covariance()
{
  const FusedCore & core = history_.core();
  const StateMatrix & P = core.filter.covariance();
  constexpr double kTilt = 0.0175;  // a block stands level within this [rad]
  constexpr double kLevel = 0.001;  // and at the height of its tread within this [m]
  auto & on_tread = estimate_.tread_covariance;
  on_tread.setZero();
  const std::array<std::pair<int, int>, 3> map{
    {{0, kStateX}, {1, kStateY}, {5, kStateYaw}}};  // of the pose, of the state
  for (const auto & [row, i] : map) {
    for (const auto & [column, j] : map) {
      on_tread(row, column) = P(i, j);
    }
  }
  estimate_.covariance = on_tread;
  const StateVector along = slopes_along();  // what tells the place on the tread, to a state
  const StateVector of_along = P * along;
  on_tread(0, 0) = along.dot(of_along);
  for (const auto & [row, i] : {map[1], map[2]}) {
    on_tread(row, 0) = on_tread(0, row) = of_along[i];
  }
  for (auto * covariance : {&estimate_.tread_covariance, &estimate_.covariance}) {
    for (const int axis : {kStateX, kStateY}) {  // of the pose, too
      const double withheld_m =
        core.hand_over.withheld_m(static_cast<std::size_t>(axis), core.time);
      (*covariance)(axis, axis) += withheld_m * withheld_m;
    }
    (*covariance)(2, 2) = kLevel * kLevel;
    (*covariance)(3, 3) = (*covariance)(4, 4) = kTilt * kTilt;
  }
  // In the flight frame x is edge + x, and every riser below adds its own doubt to z.
  auto & covariance = estimate_.covariance;
  const StateVector & edge = core.filter.edge_covariance();
  for (const auto & [row, i] : map) {
    covariance(row, 0) += edge[i];
    covariance(0, row) += edge[i];
  }
  covariance(0, 0) += core.filter.edge_variance();
  const double riser_m = params_.fused.priors.riser_m;
  covariance(2, 2) += core.located_on.value_or(0) * riser_m * riser_m;
}

std::vector<StepAsBuilt> FusedEstimator::staircase_as_built() const
{
  const FusedCore & core = history_.core();
  return as_built_.steps(core, model_.as_built_here(core));
}

const std::vector<Source> & FusedEstimator::compared() const
{
  static const std::vector<Source> kCompared{
    Source::kSideLeft,     Source::kSideRight,   Source::kFrontLeft,   Source::kFrontRight,
    Source::kBlock3Front,  Source::kBumperLeft,  Source::kBumperRight, Source::kRiserSwitches,
    Source::kStandingGyro, Source::kWheelsAlong, Source::kWheelsAcross};
  return kCompared;
}

std::vector<Bias> FusedEstimator::biases() const
{
  struct Named
  {
    const char * name;
    int index;
  };
  static constexpr std::array<Named, 12> kLearned{{
    {"side_left", offset_index(Ranger::kSideLeft)},
    {"side_left_gain", gain_index(Ranger::kSideLeft)},
    {"side_right", offset_index(Ranger::kSideRight)},
    {"side_right_gain", gain_index(Ranger::kSideRight)},
    {"front_left", offset_index(Ranger::kFrontLeft)},
    {"front_left_gain", gain_index(Ranger::kFrontLeft)},
    {"front_right", offset_index(Ranger::kFrontRight)},
    {"front_right_gain", gain_index(Ranger::kFrontRight)},
    {"block3_front", offset_index(Ranger::kBlock3Front)},
    {"block3_front_gain", gain_index(Ranger::kBlock3Front)},
    {"gyro", kStateGyroBias},
    {"odometry_scale", kStateOdomScale},
  }};
  const ErrorStateFilter & filter = history_.core().filter;
  std::vector<Bias> biases;
  for (const Named & one : kLearned) {
    biases.push_back({one.name, {filter[one.index], filter.variance(one.index)}});
  }
  return biases;
}

}  // namespace stetro_localizer
