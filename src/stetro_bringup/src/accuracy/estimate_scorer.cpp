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
#include <string>
#include <utility>
#include <vector>

namespace stetro_bringup
{
namespace
{

using stetro_driver::GroundTruth;
using stetro_driver::Time;
using stetro_localizer::Estimator;
using stetro_localizer::Integrity;
using stetro_localizer::Outcome;
using stetro_localizer::Source;
using stetro_supervisor::Phase;
using stetro_supervisor::State;

constexpr double kTick_s = 0.01;
constexpr double kConfirmation_s = 0.5;  // a touch-down not counted by then is a wrong step
// A tenth of what the slowest motion, 2 cm/s and 0.1 rad/s, makes of a tick.
constexpr double kMoved_m = 2e-5;
constexpr double kTurned_rad = 1e-4;

bool works(State state)
{
  const Phase phase = stetro_supervisor::phase_of(state);
  return phase == Phase::kFollowing || phase == Phase::kSweeping || phase == Phase::kStepping;
}

bool complete(const TreadErrors & e)
{
  return std::isfinite(e.x_m + e.x_behind_m + e.y_m + e.z_m + e.heading_rad);
}

/// Which of the side and front sensors have their target in sight, believed or not.
std::uint32_t sensors_in_use(const Estimator & estimator)
{
  static const auto kSources = [] {
    std::vector<Source> sources;
    for (std::size_t i = 0; i < stetro_localizer::kSourceCount; ++i) {
      const std::string name = stetro_localizer::to_string(static_cast<Source>(i));
      if (name.rfind("side_", 0) == 0 || name.rfind("front_", 0) == 0) {
        sources.push_back(static_cast<Source>(i));
      }
    }
    return sources;
  }();
  std::uint32_t in_use = 0;
  for (const Source source : kSources) {
    const Outcome outcome = estimator.reports()[source].outcome;
    const bool sees = outcome == Outcome::kFused || outcome == Outcome::kGated;
    in_use = in_use << 1U | (sees ? 1U : 0U);
  }
  return in_use;
}

bool exceeds(const ScoredEstimate & sample)
{
  // False for a level that is not given.
  return std::abs(sample.errors.x_m) > sample.protection.along_m ||
         std::abs(sample.errors.y_m) > sample.protection.across_m ||
         std::abs(sample.errors.heading_rad) > sample.protection.heading_rad;
}

bool tells(TellingMotion telling, bool along, bool across, bool turning)
{
  switch (telling) {
    case TellingMotion::kAcross:
      return across;
    case TellingMotion::kAlong:
      return along || turning;
    case TellingMotion::kTurning:
      return turning;
    case TellingMotion::kAny:
      break;
  }
  return along || across || turning;
}

}  // namespace

EstimateScorer::EstimateScorer(
  std::size_t estimator, const stetro_site::Flight & flight,
  const std::optional<FaultOnset> & onset)
: estimator_(estimator), flight_(flight), onset_(onset)
{
  if (onset_) {
    score_.detection = Detection{};
  }
}

void EstimateScorer::watch(const ClosedLoop & loop)
{
  if (loop.accepted()) {
    watch_confirmation(loop);
    watch_integrity(loop);
    watch_steps(loop);
    watch_closure(loop);
    watch_fault(loop);
    if (loop.refreshed(estimator_)) {
      score(loop);
    }
  }
  last_truth_ = loop.truth();
}

ClimbScore EstimateScorer::take()
{
  end_closure();
  end_tread();
  return std::move(score_);
}

void EstimateScorer::watch_integrity(const ClosedLoop & loop)
{
  const Integrity integrity = estimate(loop).integrity;
  score_.ticks_ok += integrity == Integrity::kOk ? 1 : 0;
  score_.ticks_degraded += integrity == Integrity::kDegraded ? 1 : 0;
  score_.ticks_lost += integrity == Integrity::kLost ? 1 : 0;
  score_.resets = estimate(loop).reset_counter;
  if (loop.truth().step != tread_) {
    end_tread();
    tread_ = loop.truth().step;
  }
  alarmed_ = alarmed_ || integrity != Integrity::kOk;
}

void EstimateScorer::end_tread()
{
  if (tread_ > 0) {
    ++score_.treads;
    score_.treads_alarmed += alarmed_ ? 1 : 0;
    score_.treads_exceeded += exceeded_ ? 1 : 0;
  }
  alarmed_ = false;
  exceeded_ = false;
}

void EstimateScorer::watch_confirmation(const ClosedLoop & loop)
{
  const int step = loop.truth().step;
  if (step != last_truth_.step) {
    confirming_ = true;
    came_down_ = loop.time();
  }
  if (!confirming_) {
    return;
  }
  const double since_s = stetro_driver::time_to_seconds(loop.time() - came_down_);
  confirming_ = estimate(loop).step != step && since_s <= kConfirmation_s;
  score_.longest_confirmation_s = std::max(score_.longest_confirmation_s, since_s);
}

void EstimateScorer::watch_steps(const ClosedLoop & loop)
{
  const State state = loop.climb().state();
  const bool lifts_now = state == State::kLiftBlock2 && state_ != state;
  state_ = state;
  if (!lifts_now) {
    return;
  }
  const int step = loop.truth().step;
  first_tread_ = first_tread_ && step == 0;
  const bool wrong = estimate(loop).step != step;
  ++score_.step_checks;
  score_.wrong_steps += wrong ? 1 : 0;
  score_.undetected_steps += wrong && estimate(loop).integrity == Integrity::kOk ? 1 : 0;
}

// The last closure that an estimator gives on a tread is the tread's.
void EstimateScorer::watch_closure(const ClosedLoop & loop)
{
  const int step = estimate(loop).step.value_or(0);
  if (step != closing_step_) {
    end_closure();
    closing_step_ = step;
  }
  closure_m_ = estimate(loop).contact_closure_m;
}

void EstimateScorer::end_closure()
{
  if (closure_m_ && closing_step_ > 0) {
    (closing_step_ == 1 ? score_.first_closures_m : score_.closures_m).push_back(*closure_m_);
  }
  closure_m_.reset();
}

void EstimateScorer::watch_fault(const ClosedLoop & loop)
{
  if (!onset_ || loop.elapsed_s() < onset_->at_s || score_.detection->detected) {
    return;
  }
  Detection & detection = *score_.detection;
  detection.struck = true;
  if (estimate(loop).integrity != Integrity::kOk) {
    detection.detected = true;
    return;
  }
  const GroundTruth truth = loop.truth();
  const bool along = std::abs(truth.x_m - last_truth_.x_m) > kMoved_m;
  const bool across = std::abs(truth.y_m - last_truth_.y_m) > kMoved_m;
  const bool turning = std::abs(truth.yaw_rad - last_truth_.yaw_rad) > kTurned_rad;
  detection.time_s += kTick_s;
  detection.motion_s += along || across || turning ? kTick_s : 0.0;
  detection.telling_motion_s += tells(onset_->telling, along, across, turning) ? kTick_s : 0.0;
}

void EstimateScorer::score(const ClosedLoop & loop)
{
  const stetro_localizer::StairEstimate & now = estimate(loop);
  const auto truth = loop.truths().at(now.stamp);
  const bool counts = truth && truth->step > 0 && works(loop.climb().state());
  score_.out_of_truth += truth ? 0 : 1;
  if (!counts) {
    last_.reset();
    return;
  }
  ScoredEstimate sample;
  sample.step = truth->step;
  sample.first_tread = first_tread_;
  sample.after_onset = onset_ && loop.elapsed_s() >= onset_->at_s;
  sample.confirming = confirming_;
  sample.integrity = now.integrity;
  sample.errors = errors_of(now, *truth, flight_);
  sample.nees = nees_of(sample.errors, now.covariance);
  sample.protection = protection_of(now);
  sample.sigma_x_m = std::sqrt(now.covariance(0, 0));
  sample.sigma_y_m = std::sqrt(now.covariance(1, 1));
  sample.sigma_heading_rad = std::sqrt(now.covariance(5, 5));
  watch_exceedance(sample, now.stamp);
  if (!complete(sample.errors)) {
    ++score_.without_value;
    last_.reset();
    return;
  }
  watch_hand_over(loop, sample, now.step);
  score_.samples.push_back(sample);
}

// A change of tread is no hand-over: both the estimate and its origin move there.
void EstimateScorer::watch_hand_over(
  const ClosedLoop & loop, const ScoredEstimate & sample, std::optional<int> step)
{
  const std::uint32_t in_use = sensors_in_use(loop.estimator(estimator_));
  const bool same_tread = last_ && last_->step == sample.step && last_estimated_step_ == step;
  if (same_tread && !sample.first_tread && in_use != last_in_use_) {
    score_.hand_overs.push_back(
      {sample.errors.x_m - last_->errors.x_m, sample.errors.y_m - last_->errors.y_m});
  }
  last_ = sample;
  last_estimated_step_ = step;
  last_in_use_ = in_use;
}

void EstimateScorer::watch_exceedance(const ScoredEstimate & sample, Time stamp)
{
  if (sample.integrity != Integrity::kOk || sample.confirming || !exceeds(sample)) {
    exceeds_since_.reset();
    return;
  }
  if (!exceeds_since_) {
    exceeds_since_ = stamp;
  }
  exceeded_ = true;
  const double lasted_s = stetro_driver::time_to_seconds(stamp - *exceeds_since_);
  score_.longest_exceedance_s = std::max(score_.longest_exceedance_s, lasted_s);
}

}  // namespace stetro_bringup
