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

#include "stetro_localizer/floor/floor_model.hpp"

#include <algorithm>
#include <cmath>

#include "stetro_localizer/fused/normal_quantile.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kLately = 2.0;  // turns by wheels and gyroscope are compared over such a time [s]

double squared(double value) { return value * value; }

bool any_closed(const std::array<Switch, 3> & bumpers)
{
  return std::any_of(
    bumpers.begin(), bumpers.end(), [](const Switch & one) { return one.is_closed(); });
}

/// The wheels turn against what the robot touches.
bool pushes(const OdometrySample & wheels, const ContactSample & contacts)
{
  const bool riser = contacts.riser_left.is_closed() || contacts.riser_right.is_closed();
  return (wheels.vx_mps > 0.0 && riser) || (wheels.vy_mps > 0.0 && any_closed(contacts.left)) ||
         (wheels.vy_mps < 0.0 && any_closed(contacts.right));
}

}  // namespace

FloorModel::FloorModel(const LocalizerParams & params)
: params_(params),
  limits_{
    chi_square_3_quantile(params.floor.gate_false_alarm), params.floor.lost_streak,
    params.floor.reset_sigma_m, params.floor.reset_sigma_rad},
  standing_gate_(squared(two_sided_quantile(params.fused.gate_false_alarm)))
{
}

FloorCore FloorModel::begin() const
{
  FloorCore core(limits_, params_.standstill);
  FloorMatrix covariance = FloorMatrix::Identity();
  covariance(kFloorGyroBias, kFloorGyroBias) = squared(params_.gyro.bias_sigma_radps);
  covariance(kFloorOdomScale, kFloorOdomScale) = squared(params_.fused.priors.odom_scale);
  core.filter.set(FloorVector::Zero(), covariance);
  return core;
}

void FloorModel::take(FloorCore & core, const FloorSample & sample) const
{
  std::visit([&](const auto & one) { take_one(core, one); }, sample);
  core.time = std::max(core.time, stamp_of(sample));
}

// What a clock that is left behind has to catch up [s].
double FloorModel::step_s(Nanoseconds & from, Nanoseconds until) const
{
  if (until <= from) {
    return 0.0;
  }
  const double passed_s =
    from == Nanoseconds{0} ? 0.0 : std::min(seconds(until - from), params_.silence_s);
  from = until;
  return passed_s;
}

void FloorModel::turn(FloorCore & core, Nanoseconds until) const
{
  const double dt_s = step_s(core.turned_to, until);
  if (dt_s <= 0.0) {
    return;
  }
  // Without a gyroscope the wheels tell the turn, and the heading may turn unseen.
  const bool seen = core.gyro_time != Nanoseconds{0} && !gyro_stuck(core) &&
                    seconds(until - core.gyro_time) <= params_.gyro.longest_gap_s;
  const bool blind = !seen || turns_conflict(core);
  const double density = blind ? params_.floor.noise.blind_turn : params_.floor.noise.turn;
  const double rate_radps =
    seen ? core.rate_radps : core.wheels.wz_radps + core.filter[kFloorGyroBias];
  const auto step = [&](FloorFilter & filter) {
    filter.turn(dt_s, rate_radps, density);
    filter.wander(dt_s, params_.floor.noise);
  };
  step(core.filter);
  core.gate.follow(step);
  const double by_gyro_radps = rate_radps - core.filter[kFloorGyroBias];
  core.turn_conflict_rad = core.turn_conflict_rad * std::exp(-dt_s / kLately) +
                           (core.wheels.wz_radps - by_gyro_radps) * dt_s;
}

void FloorModel::roll(FloorCore & core, Nanoseconds until) const
{
  const double dt_s = step_s(core.moved_to, until);
  if (dt_s <= 0.0) {
    return;
  }
  const FloorNoise & noise = params_.floor.noise;
  const double along = pushes(core.wheels, core.contacts) ? noise.blocked : noise.slip;
  const auto step = [&](FloorFilter & filter) {
    filter.roll(dt_s, core.wheels.vx_mps, core.wheels.vy_mps, along, noise.across);
  };
  step(core.filter);
  core.gate.follow(step);
}

void FloorModel::advance(FloorCore & core, Nanoseconds time) const
{
  turn(core, time);
  roll(core, time);
  core.time = std::max(core.time, time);
}

// No two readings of a body in motion are the same for long: its noise is more than one digit.
bool FloorModel::gyro_stuck(const FloorCore & core) const
{
  return seconds(core.gyro_time - core.gyro_lived_at) > params_.fused.alerts.stuck_s;
}

bool FloorModel::turns_conflict(const FloorCore & core) const
{
  return std::abs(core.turn_conflict_rad) > params_.floor.alerts.turn_conflict_rad;
}

void FloorModel::take_one(FloorCore & core, const GyroSample & sample) const
{
  const OdometrySample & wheels = core.wheels;
  const bool rolling = std::hypot(wheels.vx_mps, wheels.vy_mps) > 0.0 || wheels.wz_radps != 0.0;
  if (sample.rate_radps != core.rate_radps || !rolling) {
    core.gyro_lived_at = sample.stamp;
  }
  core.rate_radps = sample.rate_radps;
  core.gyro_time = sample.stamp;
  turn(core, sample.stamp);
  if (
    !core.standstill.standing() || std::abs(sample.rate_radps) >= params_.gyro.still_limit_radps) {
    return;
  }
  const double variance = squared(params_.fused.noise.gyro_radps);
  SourceReport & report = core.reports[0];
  report.innovation = sample.rate_radps - core.filter[kFloorGyroBias];
  report.innovation_variance = core.filter.variance(kFloorGyroBias) + variance;
  report.test_ratio = squared(report.innovation) / (report.innovation_variance * standing_gate_);
  const bool fused = core.filter.stand(sample.rate_radps, variance, standing_gate_);
  core.gate.follow(
    [&](FloorFilter & rival) { rival.stand(sample.rate_radps, variance, standing_gate_); });
  report.note({fused ? Outcome::kFused : Outcome::kGated, Refusal::kNone});
}

void FloorModel::take_one(FloorCore & core, const OdometrySample & sample) const
{
  const bool stood = core.standstill.standing();
  core.standstill.note(sample);
  core.landmarks += !stood && core.standstill.standing() ? 1 : 0;
  core.wheels = sample;
  roll(core, sample.stamp);
}

void FloorModel::take_one(FloorCore & core, const ContactSample & sample) const
{
  core.contacts = sample;
}

void FloorModel::take_one(FloorCore & core, const FloorFix & sample) const
{
  advance(core, sample.stamp);
  const FixInnovation innovation = core.filter.innovation(sample.fix);
  const double ratio = innovation.nis() / limits_.nis;
  core.answer = core.gate.judge(core.filter, sample.fix, sample.floor);
  core.resets += core.answer == CorrectionOutcome::kReset ? 1 : 0;
  const bool gated =
    core.answer == CorrectionOutcome::kGated || core.answer == CorrectionOutcome::kGatedLost;
  const bool fused = core.answer == CorrectionOutcome::kFused;
  core.landmarks += fused ? 0 : 1;
  for (int i = 0; i < 3 && (fused || gated); ++i) {  // otherwise nothing was expected
    SourceReport & report = core.reports[static_cast<std::size_t>(i) + 1];
    report.innovation = innovation.value[i];
    report.innovation_variance = innovation.covariance(i, i);
    report.test_ratio = ratio;
    report.note({fused ? Outcome::kFused : Outcome::kGated, Refusal::kNone});
  }
}

}  // namespace stetro_localizer
