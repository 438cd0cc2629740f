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

// How far the estimate may be trusted, and why not.

#include <algorithm>
#include <cmath>

#include "stetro_localizer/fused_estimator.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kRecent = 0.5;  // a correction this young still counts [s]

std::uint32_t flag(bool raised, std::uint32_t reason) { return raised ? reason : 0u; }

/// Block 1 stands on the last tread or beyond it: nothing rises before the front pair.
bool no_riser_ahead(const FusedCore & core, const stetro_site::Flight & flight)
{
  return core.located_on && *core.located_on >= std::max(flight.steps() - 1, 1);
}

}  // namespace

bool FusedEstimator::recent(Ranger ranger) const
{
  const FusedCore & core = history_.core();
  return seconds(core.time - core.used_at[static_cast<std::size_t>(ranger)]) < kRecent;
}

// The doubt of the filter at the integrity risk, and what a slip does before it is noticed.
void FusedEstimator::refresh_protection()
{
  const FusedCore & core = history_.core();
  const bool known = core.located_on.has_value();
  const auto bound = [this](int axis) {
    return risk_quantile_ * std::sqrt(estimate_.tread_covariance(axis, axis));
  };
  // A slip is rare and long, no part of a normal distribution: it adds as a whole. So does a turn
  // that the gyroscope does not tell.
  const FusedAlerts & alert = params_.fused.alerts;
  const auto slip_m = [&](int axis, bool in_sight) {
    const double suspected_m = model_.suspected_slip_m(core, axis);
    return std::max(in_sight ? alert.unnoticed_slip_m : alert.unseen_slip_m, suspected_m);
  };
  const bool riser =
    recent(Ranger::kFrontLeft) || recent(Ranger::kFrontRight) || recent(Ranger::kBlock3Front);
  const bool wall = recent(Ranger::kSideLeft) || recent(Ranger::kSideRight);
  const auto level_m = [&](int axis, bool in_sight) {
    return known ? bound(axis) + slip_m(axis, in_sight) + std::abs(core.unconfirmed_m[axis])
                 : kUnknown;
  };
  const bool pair = recent(Ranger::kFrontLeft) && recent(Ranger::kFrontRight);
  const double turn_rad = std::max(
    pair ? alert.unnoticed_turn_rad : alert.unseen_turn_rad, model_.suspected_turn_rad(core));
  estimate_.protection_along_m = level_m(kStateX, riser);
  estimate_.protection_across_m = level_m(kStateY, wall);
  estimate_.protection_heading_rad = known ? bound(5) + turn_rad : kUnknown;
  estimate_.integrity_risk = params_.fused.integrity_risk;
}

void FusedEstimator::refresh_integrity()
{
  const FusedCore & core = history_.core();
  const bool known = core.located_on.has_value();
  std::uint32_t reasons = sensor_reasons() | core.steps.reasons();
  if (known) {
    reasons |= pose_reasons();
  } else {
    reasons |= core.steps.awaiting_blocks() ? std::uint32_t{kNotInitialised} : begin_reasons_;
  }
  estimate_.integrity = integrity_of(reasons, known);
  // By itself no doubt: the covariance grows where it is so, and the levels with it.
  estimate_.reasons = reasons | flag(no_riser_ahead(core, flight_), kNoFrontReference);
}

std::uint32_t FusedEstimator::sensor_reasons() const
{
  const FusedCore & core = history_.core();
  const FusedAlerts & alert = params_.fused.alerts;
  std::uint32_t reasons = flag(silent_, kInputSilent);
  const bool seen = core.time != Nanoseconds{0};
  reasons |= flag(seen && ranges_.any_dead(core.time, core.since, alert.dead_s), kSensorDead);
  reasons |= flag(switches_.any_dead(), kSensorDead);
  const bool blind = std::any_of(
    core.monitors.begin(), core.monitors.end(),
    [](const RangeMonitor & monitor) { return monitor.stuck() || monitor.blind(); });
  const bool stuck = ranges_.any_stuck() || switches_.any_stuck() || model_.gyro_stuck(core);
  reasons |= flag(blind || stuck, kSensorStuck);
  for (std::size_t i = 0; i < kRangerCount; ++i) {
    const auto ranger = static_cast<Ranger>(i);
    const bool beyond_trust = std::abs(core.filter[offset_index(ranger)]) > alert.offset_m ||
                              std::abs(core.filter[gain_index(ranger)]) > alert.gain;
    reasons |= flag(beyond_trust, kSensorCalibration);
  }
  return reasons | conflict_reasons();
}

// Sensors that contradict each other.
std::uint32_t FusedEstimator::conflict_reasons() const
{
  const FusedCore & core = history_.core();
  const FusedAlerts & alert = params_.fused.alerts;
  std::uint32_t reasons = flag(core.doubted[kStateX], kSlip);
  reasons |= flag(core.doubted[kStateYaw], kHeadingConflict);
  reasons |= flag(core.doubted[kStateY], kClosureViolated);
  const auto contradicts = [&](Source source) {
    return core.reports[source].reject_streak >= alert.reject_streak;
  };
  reasons |=
    flag(contradicts(Source::kSideLeft) || contradicts(Source::kSideRight), kClosureViolated);
  const bool wheels = contradicts(Source::kWheelsAlong) || contradicts(Source::kWheelsAcross);
  reasons |=
    flag(wheels || contradicts(Source::kFrontLeft) || contradicts(Source::kFrontRight), kSlip);
  reasons |= flag(contradicts(Source::kStandingGyro), kHeadingConflict);
  return reasons;
}

// A robot that comes from a floor knows y before it sees a wall, and after: where no wall is, its
// protection level decides.
bool FusedEstimator::wall_missed() const
{
  const bool seen = recent(Ranger::kSideLeft) || recent(Ranger::kSideRight);
  return !seen && (!floors_drawn_ || model_.wall_in_sight(history_.core()));
}

std::uint32_t FusedEstimator::pose_reasons() const
{
  const FusedCore & core = history_.core();
  const FusedAlerts & alert = params_.fused.alerts;
  std::uint32_t reasons = flag(wall_missed(), kNoSideRange);
  const bool unreferenced = estimate_.protection_along_m > alert.along_m ||
                            estimate_.protection_heading_rad > alert.heading_rad;
  reasons |= flag(unreferenced, kNoFrontReference);
  // Where that reason alone is no doubt, it does not say what is.
  reasons |= flag(
    estimate_.protection_across_m > alert.across_m ||
      (unreferenced && no_riser_ahead(core, flight_)),
    kProtectionExceeded);
  const auto gated = [&core](Source source) {
    return core.reports[source].outcome == Outcome::kGated;
  };
  const bool conflict = core.steps.evidence_conflicts() || gated(Source::kBumperLeft) ||
                        gated(Source::kBumperRight) || gated(Source::kRiserSwitches);
  reasons |= flag(off_tread(), kOffTread);
  reasons |= flag(closure_.violated(core.closure.error_m()), kContactClosure);
  return reasons | flag(conflict, kContactConflict);
}

// Block 2 cannot be inside the riser ahead, nor stand on a tread that ends ahead of its middle.
bool FusedEstimator::off_tread() const
{
  const FusedCore & core = history_.core();
  if (core.steps.block2_aloft()) {
    return false;
  }
  const int step = *core.located_on;
  const double x_m = core.filter[kStateX];
  const double doubt_m = params_.fused.alerts.off_tread_m + estimate_.protection_along_m;
  const bool in_riser = step < flight_.steps() && x_m + front_edge_m_ > doubt_m;
  const bool behind = step > 0 && x_m + core.filter[kStateTreadHere] < -doubt_m;
  return in_riser || behind;
}

// What every device must show, whether the filter uses it or not.
void FusedEstimator::watch_devices(const Sample & sample)
{
  const FusedCore & core = history_.core();
  if (const auto * blocks = std::get_if<BlockSample>(&sample)) {
    ranges_.note(*blocks, core.travel_m);
  } else if (const auto * ranges = std::get_if<RangeSample>(&sample)) {
    const bool ahead = core.located_on && *core.located_on < flight_.steps();
    ranges_.note(*ranges, core.travel_m, ahead ? -core.filter[kStateX] : kUnknown);
  } else if (const auto * contacts = std::get_if<ContactSample>(&sample)) {
    const double width_m = risk_quantile_ * std::sqrt(core.filter.variance(kStateWidth));
    closure_.note(*contacts, estimate_.protection_across_m, width_m);
    switches_.note(*contacts, core, flight_.steps());
  } else if (const auto * wheels = std::get_if<OdometrySample>(&sample)) {
    switches_.note(*wheels, core);
  }
}

}  // namespace stetro_localizer
