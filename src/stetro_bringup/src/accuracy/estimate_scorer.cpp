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

#include "accuracy/estimate_scorer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stetro_bringup
{
namespace
{

using stetro_driver::Time;
using stetro_localizer::Integrity;
using stetro_supervisor::Phase;
using stetro_supervisor::State;

constexpr double kConfirmation_s = 0.5;  // a touch-down not counted by then is a wrong step

bool works(State state)
{
  const Phase phase = stetro_supervisor::phase_of(state);
  return phase == Phase::kFollowing || phase == Phase::kSweeping || phase == Phase::kStepping;
}

bool complete(const TreadErrors & e)
{
  return std::isfinite(e.x_m + e.x_behind_m + e.y_m + e.z_m + e.heading_rad);
}

bool exceeds(const ScoredEstimate & sample)
{
  // False for a level that is not given.
  return std::abs(sample.errors.x_m) > sample.protection.along_m ||
         std::abs(sample.errors.y_m) > sample.protection.across_m ||
         std::abs(sample.errors.heading_rad) > sample.protection.heading_rad;
}

}  // namespace

EstimateScorer::EstimateScorer(
  const stetro_site::Flight & flight, const std::optional<FaultOnset> & onset)
: flight_(flight), onset_(onset)
{
  if (onset) {
    fault_.emplace(*onset);
  }
}

void EstimateScorer::watch(const Moment & now)
{
  if (now.accepted) {
    watch_confirmation(now);
    watch_integrity(now);
    steps_.watch(now);
    watch_closure(now);
    if (now.refreshed) {
      score(now);
    }
  }
  if (fault_) {
    fault_->watch(now);
  }
  last_step_ = now.truth.step;
}

ClimbScore EstimateScorer::take()
{
  end_closure();
  end_tread();
  score_.steps = steps_.take();
  if (fault_) {
    score_.detection = fault_->detection();
  }
  return std::move(score_);
}

void EstimateScorer::watch_integrity(const Moment & now)
{
  const Integrity integrity = now.estimate.integrity;
  const bool ok = integrity == Integrity::kOk;
  score_.ticks_ok += ok ? 1 : 0;
  score_.ticks_degraded += integrity == Integrity::kDegraded ? 1 : 0;
  score_.ticks_lost += integrity == Integrity::kLost ? 1 : 0;
  score_.resets = now.estimate.reset_counter;
  score_.stated_risk = now.estimate.integrity_risk;
  score_.alarms += was_ok_ && !ok && !steps_.first_tread() ? 1 : 0;
  was_ok_ = ok;
  if (now.truth.step != tread_) {
    end_tread();
    tread_ = now.truth.step;
  }
  if (!ok) {  // with or without a new estimate
    alarmed_ = true;
    exceeds_since_.reset();
  }
}

void EstimateScorer::end_tread()
{
  if (tread_ > 0) {
    ++score_.treads;
    score_.treads_alarmed += alarmed_ ? 1 : 0;
    score_.treads_exceeded += exceeded_ ? 1 : 0;
    score_.treads_misled += misled_ ? 1 : 0;
  }
  alarmed_ = false;
  exceeded_ = false;
  misled_ = false;
}

void EstimateScorer::watch_confirmation(const Moment & now)
{
  const int step = now.truth.step;
  if (step != last_step_) {
    confirming_ = true;
    came_down_ = now.time;
  }
  if (!confirming_) {
    return;
  }
  const double since_s = stetro_driver::time_to_seconds(now.time - came_down_);
  confirming_ = now.estimate.step != step && since_s <= kConfirmation_s;
  score_.longest_confirmation_s = std::max(score_.longest_confirmation_s, since_s);
}

// The last closure that an estimator gives on a tread is the tread's.
void EstimateScorer::watch_closure(const Moment & now)
{
  const int step = now.estimate.step.value_or(0);
  if (step != closing_step_) {
    end_closure();
    closing_step_ = step;
  }
  closure_m_ = now.estimate.contact_closure_m;
}

void EstimateScorer::end_closure()
{
  if (closure_m_ && closing_step_ > 0) {
    (closing_step_ == 1 ? score_.first_closures_m : score_.closures_m).push_back(*closure_m_);
  }
  closure_m_.reset();
}

void EstimateScorer::score(const Moment & now)
{
  score_.out_of_truth += now.truth_at_stamp ? 0 : 1;
  if (!now.truth_at_stamp) {
    last_.reset();
    return;
  }
  if (now.truth_at_stamp->step <= 0) {
    last_.reset();
    exceeds_since_.reset();
    return;
  }
  const ScoredEstimate sample = scored(now);
  watch_exceedance(sample, now.estimate.stamp);
  if (!works(now.state)) {
    last_.reset();
    return;
  }
  if (!complete(sample.errors)) {
    ++score_.without_value;
    last_.reset();
    return;
  }
  watch_hand_over(now, sample);
  score_.samples.push_back(sample);
}

ScoredEstimate EstimateScorer::scored(const Moment & now) const
{
  const stetro_localizer::StairEstimate & estimate = now.estimate;
  ScoredEstimate sample;
  sample.step = now.truth_at_stamp->step;
  sample.first_tread = steps_.first_tread();
  sample.after_onset = onset_ && now.elapsed_s >= onset_->at_s;
  sample.confirming = confirming_;
  sample.integrity = estimate.integrity;
  sample.errors = errors_of(estimate, *now.truth_at_stamp, flight_);
  sample.nees = nees_of(sample.errors, estimate.tread_covariance);
  sample.protection = protection_of(estimate);
  sample.sigma_x_m = std::sqrt(estimate.tread_covariance(0, 0));
  sample.sigma_y_m = std::sqrt(estimate.tread_covariance(1, 1));
  sample.sigma_heading_rad = std::sqrt(estimate.tread_covariance(5, 5));
  sample.sigma_flight_x_m = std::sqrt(estimate.covariance(0, 0));
  sample.sigma_flight_z_m = std::sqrt(estimate.covariance(2, 2));
  return sample;
}

// A change of tread is no hand-over: both the estimate and its origin move there.
void EstimateScorer::watch_hand_over(const Moment & now, const ScoredEstimate & sample)
{
  const auto step = now.estimate.step;
  const bool same_tread = last_ && last_->step == sample.step && last_estimated_step_ == step;
  if (same_tread && !sample.first_tread && now.in_sight != last_in_sight_) {
    score_.hand_overs.push_back(
      {sample.errors.x_m - last_->errors.x_m, sample.errors.y_m - last_->errors.y_m});
  }
  last_ = sample;
  last_estimated_step_ = step;
  last_in_sight_ = now.in_sight;
}

// An estimate that waits for its touch-down to be counted neither begins nor ends one.
void EstimateScorer::watch_exceedance(const ScoredEstimate & sample, Time stamp)
{
  if (sample.confirming) {
    return;
  }
  if (sample.integrity != Integrity::kOk || !exceeds(sample)) {
    exceeds_since_.reset();
    return;
  }
  if (!exceeds_since_) {
    exceeds_since_ = stamp;
  }
  exceeded_ = true;
  const double lasted_s = stetro_driver::time_to_seconds(stamp - *exceeds_since_);
  misled_ = misled_ || lasted_s > stetro_localizer::kTimeToAlert_s;
  score_.longest_exceedance_s = std::max(score_.longest_exceedance_s, lasted_s);
}

}  // namespace stetro_bringup
