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

#include "stetro_localizer/fused/fused_model.hpp"

#include <algorithm>
#include <cmath>

#include "stetro_localizer/fused/blocked_motion_aiding.hpp"
#include "stetro_localizer/fused/cone.hpp"
#include "stetro_localizer/fused/normal_quantile.hpp"
#include "stetro_localizer/fused/standing_gyro_aiding.hpp"
#include "stetro_localizer/fused/wheel_aiding.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kWidthJump = 0.02;  // of a side sensor's offset, to be found soonest [m]
constexpr double kPairJump = 0.006;  // of a front sensor's, or of the heading by 1.7 deg [m]
constexpr double kRareAlarm = 1e-7;  // of an innovation of sound sensors: it stops the climb
constexpr double kLately = 3.0;      // slips in such a time are counted together [s]
constexpr double kWheelsGap = 0.1;   // wheels that are silent for longer may do anything [s]

double squared(double value) { return value * value; }

SideRangeAiding side_aiding(Side side, const stetro_site::RobotGeometry & robot)
{
  const auto & mount = robot.at(side == Side::kLeft ? Place::kSideLeft : Place::kSideRight);
  return {side, {mount.x_m, mount.y_m}, ConeOnWall(robot.range_sensor.cone_rad)};
}

FrontRangeAiding front_aiding(Ranger ranger, Place place, const stetro_site::RobotGeometry & robot)
{
  const auto & mount = robot.at(place);
  return {ranger, mount.x_m, mount.y_m, ConeOnWall(robot.range_sensor.cone_rad)};
}

}  // namespace

FusedModel::FusedModel(
  const LocalizerParams & params, const stetro_site::RobotGeometry & robot,
  const stetro_site::Flight & flight)
: params_(params),
  robot_(robot),
  flight_(flight),
  step_model_(flight, robot, params.fused.steps),
  gate_(squared(two_sided_quantile(params.fused.gate_false_alarm))),
  sides_{side_aiding(Side::kLeft, robot), side_aiding(Side::kRight, robot)},
  fronts_{
    front_aiding(Ranger::kFrontLeft, Place::kFrontLeft, robot),
    front_aiding(Ranger::kFrontRight, Place::kFrontRight, robot)},
  block3_front_(front_aiding(Ranger::kBlock3Front, Place::kBlock3Front, robot))
{
}

bool FusedModel::fill_in(Sample & kept, const Sample & sample)
{
  auto * const into = std::get_if<RangeSample>(&kept);
  const auto * const from = std::get_if<RangeSample>(&sample);
  bool any = false;
  for (std::size_t i = 0; into != nullptr && i < into->readings.size(); ++i) {
    const bool fills = into->readings[i].status == RangeStatus::kAbsent &&
                       from->readings[i].status != RangeStatus::kAbsent;
    into->readings[i] = fills ? from->readings[i] : into->readings[i];
    any = any || fills;
  }
  return any;
}

FusedCore FusedModel::begin() const
{
  FusedCore core(
    step_model_, params_.standstill,
    SlipWatch(params_.fused.slip_m, params_.fused.slip_false_alarm),
    SlipWatch(kWidthJump, kRareAlarm), SlipWatch(kPairJump, kRareAlarm),
    HandOver(params_.fused.hand_over_s));
  const FusedPriors & prior = params_.fused.priors;
  const double width_m = flight_.width_m(0.0);
  core.filter.set(kStateY, width_m / 2.0, squared(width_m) / 12.0);
  core.filter.set(kStateYaw, 0.0, squared(prior.yaw_rad));
  core.filter.set(kStateGyroBias, 0.0, squared(params_.gyro.bias_sigma_radps));
  core.filter.set(kStateOdomScale, 0.0, squared(prior.odom_scale));
  core.filter.set(kStateWidth, width_m, squared(prior.width_m));
  for (int i = kStateFirstCalibration; i < kStateCount; i += 2) {
    core.filter.set(i, 0.0, squared(prior.range_offset_m));
    core.filter.set(i + 1, 0.0, squared(prior.range_gain));
  }
  core.closure = ContactClosure(width_m, robot_.contact_width_m);
  return core;
}

void FusedModel::take(FusedCore & core, const Sample & sample) const
{
  std::visit([&](const auto & one) { take_one(core, one); }, sample);
}

void FusedModel::advance(FusedCore & core, Nanoseconds time) const
{
  if (core.time == Nanoseconds{0}) {
    core.time = core.since = time;
  }
  const Nanoseconds wheels_until = core.wheels_time + nanoseconds(kWheelsGap);
  if (core.wheels_time != Nanoseconds{0} && core.time < wheels_until && time > wheels_until) {
    advance(core, wheels_until);  // as they turned; from here on it is not known how they do
  }
  ProcessNoise noise = params_.fused.process;
  const double dt_s = seconds(time - core.time);
  const bool seen = core.gyro_time != Nanoseconds{0} && !gyro_stuck(core) &&
                    seconds(time - core.gyro_time) <= params_.gyro.longest_gap_s;
  if (!seen) {  // the heading may turn unseen, at one rate all the while: (rate * gap)^2 grows so
    const Nanoseconds told_at = gyro_stuck(core) ? core.gyro_lived_at : core.gyro_time;
    const double gap_s = seconds(core.time - std::max(told_at, core.since));
    noise.turn = params_.gyro.gap_rate_radps * std::sqrt(dt_s + 2.0 * std::max(gap_s, 0.0));
  }
  if (time <= core.slipping_until) {
    noise.slip = params_.fused.slipping;
  }
  if (core.wheels_time != Nanoseconds{0} && core.time >= wheels_until && !core.wheels_silent) {
    core.wheels_silent = true;
    core.filter.set(kStateVx, 0.0, squared(params_.fused.noise.unseen_mps));
    core.filter.set(kStateVy, 0.0, squared(params_.fused.noise.unseen_mps));
  }
  const double rate_radps = seen ? core.rate_radps : core.filter[kStateGyroBias];
  const double x_m = core.filter[kStateX];
  const double still_lately = std::exp(-dt_s / kLately);
  for (double & slipped_m : core.slipped_m) {
    slipped_m *= still_lately;
  }
  core.filter.predict(dt_s, rate_radps, noise, core.rolling);
  core.travel_m += core.filter[kStateX] - x_m;
  core.time = time;
}

void FusedModel::take_one(FusedCore & core, const OdometrySample & sample) const
{
  core.standstill.note(sample);
  core.wheels_time = sample.stamp;
  core.wheels_silent = false;
  core.rolling = std::hypot(sample.vx_mps, sample.vy_mps) > 0.0;
  core.rolled_at = core.rolling ? sample.stamp : core.rolled_at;
  const auto any = [](const std::array<Switch, 3> & bumpers) {
    return std::any_of(
      bumpers.begin(), bumpers.end(), [](const Switch & one) { return one.is_closed(); });
  };
  const ContactSample & contacts = core.contacts;
  const bool riser = contacts.riser_left.is_closed() || contacts.riser_right.is_closed();
  const bool wall = sample.vy_mps > 0.0 ? any(contacts.left) : any(contacts.right);
  take_speed(core, kStateVx, sample.vx_mps, sample.vx_mps > 0.0 && riser);
  take_speed(core, kStateVy, sample.vy_mps, sample.vy_mps != 0.0 && wall);
}

// The speed is forgotten from sample to sample, for motors start and stop at once. Against a wall
// the wheels spin and say nothing of the body.
void FusedModel::take_speed(FusedCore & core, int index, double counted_mps, bool blocked) const
{
  const FusedNoise & noise = params_.fused.noise;
  ErrorStateFilter & filter = core.filter;
  filter.inflate(index, squared(params_.fused.process.acceleration));
  const Expectation expected =
    blocked ? expect_blocked(filter.state(), index) : expect_wheels(filter.state(), index);
  const double variance = squared(blocked ? noise.blocked_mps : noise.wheels_mps);
  const Source source = index == kStateVx ? Source::kWheelsAlong : Source::kWheelsAcross;
  use(core, source, expected, blocked ? 0.0 : counted_mps, variance);
}

// No two readings of a body in motion are the same for long: its noise is more than one digit.
bool FusedModel::gyro_stuck(const FusedCore & core) const
{
  return seconds(core.gyro_time - core.gyro_lived_at) > params_.fused.alerts.stuck_s;
}

void FusedModel::take_one(FusedCore & core, const GyroSample & sample) const
{
  if (sample.rate_radps != core.rate_radps || !(core.rolling || core.blocks_moving)) {
    core.gyro_lived_at = sample.stamp;
  }
  core.rate_radps = sample.rate_radps;
  core.pitch_rad = sample.pitch_rad;
  core.gyro_time = sample.stamp;
  advance(core, sample.stamp);
  if (
    core.standstill.standing() && !core.blocks_moving &&
    std::abs(sample.rate_radps) < params_.gyro.still_limit_radps) {
    use(
      core, Source::kStandingGyro, expect_standing_gyro(core.filter.state()), sample.rate_radps,
      squared(params_.fused.noise.gyro_radps));
  }
}

Outcome FusedModel::use(
  FusedCore & core, Source source, const Expectation & expectation, double measured,
  double variance, const Corrects & corrects) const
{
  return use(
    core, source, expectation, core.filter.innovation(expectation, measured, variance), corrects);
}

Outcome FusedModel::use(
  FusedCore & core, Source source, const Expectation & expectation, const Innovation & innovation,
  const Corrects & corrects) const
{
  SourceReport & report = core.reports[source];
  report.innovation = innovation.value;
  report.innovation_variance = innovation.variance;
  report.test_ratio = innovation.nis() / gate_;
  const Outcome outcome = innovation.nis() <= gate_ ? Outcome::kFused : Outcome::kGated;
  if (outcome == Outcome::kFused) {
    core.filter.correct(expectation, innovation, corrects);
  }
  report.note({outcome, Refusal::kNone});
  return outcome;
}

double FusedModel::tread_m(int step) const
{
  return flight_.tread_m(std::clamp(step, 1, flight_.steps()));
}

double FusedModel::edge_ahead_m(int step) const
{
  return step == 0 ? flight_.riser_x_m(1) : flight_.tread_end_m(step);
}

void FusedModel::locate(FusedCore & core, int step) const
{
  const FusedPriors & prior = params_.fused.priors;
  ErrorStateFilter & filter = core.filter;
  const double room_m = step == 0 ? 2.0 : tread_m(step);
  filter.set(kStateX, step == 0 ? -0.6 : -room_m / 2.0, squared(room_m) / 12.0);
  filter.set(kStateTreadHere, tread_m(step), squared(prior.tread_m));
  filter.set(kStateTreadAhead, tread_m(step + 1), squared(prior.tread_m));
  filter.set(kStateRiserAhead, 0.0, squared(prior.riser_direction_rad));
  filter.set(kStateRiserNext, 0.0, squared(prior.riser_direction_rad));
  const double width_m = flight_.width_m(step == 0 ? 0.0 : flight_.tread_centre_m(step));
  filter.set(kStateWidth, width_m, squared(prior.width_m));
  core.edge_x_m = edge_ahead_m(step);
  core.rise_m = flight_.tread_z_m(step);
  filter.begin_edge(step * squared(prior.tread_m), step == 0 ? 0.0 : squared(prior.tread_m));
  core.left_behind = {};  // it may have been another step
  begin_gauge(core);
  core.located_on = step;
  for (SlipWatch & watch : core.slips) {
    watch.clear();
  }
  core.hand_over.let_out(kStateX);
  core.hand_over.let_out(kStateY);
  core.closure = ContactClosure(width_m, robot_.contact_width_m);
  ++core.jumps;
}

}  // namespace stetro_localizer
