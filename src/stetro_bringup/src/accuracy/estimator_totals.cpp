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

#include "accuracy/estimator_totals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "accuracy/proportion.hpp"

namespace stetro_bringup
{
namespace
{

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// For what may be missing: an estimate need not give levels, and a variance may be no number.
template <class Sums>
void add_known(Sums & to, double value)
{
  if (std::isfinite(value)) {
    to.add(value);
  }
}

}  // namespace

void ErrorGroup::add(const TreadErrors & errors)
{
  x_m.add(errors.x_m);
  x_behind_m.add(errors.x_behind_m);
  y_m.add(errors.y_m);
  z_m.add(errors.z_m);
  heading_rad.add(errors.heading_rad);
  heading_to_riser_rad.add(errors.heading_to_riser_rad);
}

void NeesTally::add(double nees)
{
  if (!std::isfinite(nees)) {
    ++unknown;
    return;
  }
  sum += nees;
  if (nees > kNees95.high) {
    ++above;
  } else if (nees < kNees95.low) {
    ++below;
  } else {
    ++inside;
  }
}

double NeesTally::inside_share() const { return share_of(inside, known()); }

double NeesTally::mean() const
{
  return known() == 0 ? kUnknown : sum / static_cast<double>(known());
}

void MeasureTotals::add(const std::vector<MeasureScore> & scores)
{
  for (const MeasureScore & score : scores) {
    found_m.add(score.found_error_m);
    site_m.add(score.site_error_m);
    sigmas.add(score.found_error_m, score.sigma_m);
  }
}

EstimatorTotals::EstimatorTotals(int steps) : treads(static_cast<std::size_t>(steps) + 1) {}

void EstimatorTotals::add(const ClimbScore & score)
{
  ++climbs;
  for (const ScoredEstimate & sample : score.samples) {
    add(sample);
  }
  for (const HandOver & jump : score.hand_overs) {
    hand_over_x_m.add(jump.x_m);
    hand_over_y_m.add(jump.y_m);
    hand_over_m.add(std::max(std::abs(jump.x_m), std::abs(jump.y_m)));
  }
  for (const double closure : score.closures_m) {
    closure_m.add(closure);
  }
  for (const double closure : score.first_closures_m) {
    first_closure_m.add(closure);
  }
  tread_depths.add(score.staircase.treads);
  widths.add(score.staircase.widths);
  deviations_reported += score.staircase.reported;
  add_counts(score);
  longest_confirmation_s = std::max(longest_confirmation_s, score.longest_confirmation_s);
  longest_exceedance_s = std::max(longest_exceedance_s, score.longest_exceedance_s);
  stated_risk = std::fmax(stated_risk, score.stated_risk);  // of what is known
  exceeded_climbs += score.longest_exceedance_s > stetro_localizer::kTimeToAlert_s ? 1 : 0;
  if (score.detection && score.detection->never_ok) {
    ++never_ok;
  } else if (score.detection && score.detection->struck) {
    detections.push_back(*score.detection);
  }
}

void EstimatorTotals::add_counts(const ClimbScore & score)
{
  counts.ticks_ok += score.ticks_ok;
  counts.ticks_degraded += score.ticks_degraded;
  counts.ticks_lost += score.ticks_lost;
  counts.treads += score.treads;
  counts.treads_alarmed += score.treads_alarmed;
  counts.treads_exceeded += score.treads_exceeded;
  counts.treads_misled += score.treads_misled;
  counts.resets += score.resets;
  counts.without_value += score.without_value;
  counts.out_of_truth += score.out_of_truth;
  counts.alarms += score.alarms;
  counts.steps.checks += score.steps.checks;
  counts.steps.wrong += score.steps.wrong;
  counts.steps.undetected += score.steps.undetected;
  counts.steps.on_stairs += score.steps.on_stairs;
  auto & miscounts = counts.steps.miscounts;
  miscounts.insert(miscounts.end(), score.steps.miscounts.begin(), score.steps.miscounts.end());
}

void EstimatorTotals::add(const ScoredEstimate & sample)
{
  if (sample.confirming) {
    ++confirming;
    return;
  }
  if (sample.after_onset) {
    after_onset.add(sample.errors);
  }
  if (sample.first_tread) {
    first_tread.add(sample.errors);
    return;
  }
  errors.add(sample.errors);
  flight_x_m.add(sample.errors.flight_x_m);
  flight_z_m.add(sample.errors.flight_z_m);
  flight_x.add(sample.errors.flight_x_m, sample.sigma_flight_x_m);
  flight_z.add(sample.errors.flight_z_m, sample.sigma_flight_z_m);
  x_histogram.add(sample.errors.x_m);
  y_histogram.add(sample.errors.y_m);
  heading_histogram.add(sample.errors.heading_rad);
  nees.add(sample.nees);
  if (has_reference(sample.step)) {
    nees_with_reference.add(sample.nees);
    add_known(protection_along_m, sample.protection.along_m);
    add_known(protection_across_m, sample.protection.across_m);
    add_known(protection_heading_rad, sample.protection.heading_rad);
  } else {
    nees_without_reference.add(sample.nees);
  }
  TreadTotals & tread = treads.at(static_cast<std::size_t>(sample.step));
  tread.x_m.add(sample.errors.x_m);
  tread.y_m.add(sample.errors.y_m);
  tread.heading_rad.add(sample.errors.heading_rad);
  add_known(tread.sigma_x_m, sample.sigma_x_m);
  add_known(tread.sigma_y_m, sample.sigma_y_m);
  add_known(tread.sigma_heading_rad, sample.sigma_heading_rad);
  tread.nees.add(sample.nees);
}

}  // namespace stetro_bringup
