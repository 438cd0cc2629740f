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

// What range readings mean, and what a slip looks like in them.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "stetro_localizer/front_reference.hpp"
#include "stetro_localizer/fused/fused_model.hpp"

namespace stetro_localizer
{
namespace
{

constexpr Nanoseconds kSlipGoesOn = std::chrono::milliseconds(200);
constexpr Nanoseconds kNoSlipBehind = std::chrono::seconds(1);  // at a stand: it would be noticed
constexpr double kSteady = 6.0;        // standard deviations between one reading and the next
constexpr double kFastest = 0.5;       // a range changes [m/s]
constexpr double kKnownBetter = 3.0;   // another source told the heading so many times better
constexpr double kSureOfSide = 3.0;    // standard deviations of the heading
constexpr double kMostlyNoise = 3.0;   // an innovation's variance in that of the reading
constexpr double kResolution = 0.001;  // readings come in whole millimetres [m]

constexpr std::array<std::pair<Ranger, Place>, kWatchedCount> kWatched{{
  {Ranger::kSideLeft, Place::kSideLeft},
  {Ranger::kSideRight, Place::kSideRight},
  {Ranger::kFrontLeft, Place::kFrontLeft},
  {Ranger::kFrontRight, Place::kFrontRight},
}};

constexpr RangerPair kSidePair{{
  {Ranger::kSideLeft, Place::kSideLeft, Source::kSideLeft, 1.0},
  {Ranger::kSideRight, Place::kSideRight, Source::kSideRight, 1.0},
}};
constexpr RangerPair kFrontPair{{
  {Ranger::kFrontLeft, Place::kFrontLeft, Source::kFrontLeft, 1.0},
  {Ranger::kFrontRight, Place::kFrontRight, Source::kFrontRight, -1.0},
}};

double squared(double value) { return value * value; }

}  // namespace

double FusedModel::range_variance_m2(double range_m) const
{
  return squared(robot_.range_sensor.sigma_at_m(range_m)) + squared(kResolution) / 12.0;
}

void FusedModel::take_one(FusedCore & core, const RangeSample & sample) const
{
  advance(core, sample.stamp);
  RangeSample confirmed = sample;
  for (const Place place : stetro_site::kPlaces) {
    const RangeReading & reading = sample[place];
    if (reading.status == RangeStatus::kValid && !confirms(core.last_ranges[place], reading)) {
      confirmed[place].status = RangeStatus::kWeak;
    }
  }
  for (const Place place : stetro_site::kPlaces) {
    if (sample[place].status != RangeStatus::kAbsent) {
      core.last_ranges[place] = sample[place];
    }
  }
  for (const auto & [ranger, place] : kWatched) {
    core.monitors[static_cast<std::size_t>(ranger)].note(sample[place]);
  }
  if (!core.located_on) {
    return;
  }
  take_side(core, Side::kLeft, confirmed[Place::kSideLeft]);
  take_side(core, Side::kRight, confirmed[Place::kSideRight]);
  take_front(core, fronts_[0], confirmed[Place::kFrontLeft]);
  take_front(core, fronts_[1], confirmed[Place::kFrontRight]);
  take_block3_front(core, confirmed[Place::kBlock3Front]);
  watch_pairs(core, confirmed);
}

// A sensor whose target is out of reach now and then reports what is not there; twice in a row the
// same, it hardly does.
bool FusedModel::confirms(const RangeReading & before, const RangeReading & now) const
{
  const double between_s = seconds(now.stamp - before.stamp);
  const double sigma_m = std::sqrt(range_variance_m2(now.range_m));
  return before.status == RangeStatus::kValid && between_s <= params_.max_sample_age_s &&
         std::abs(now.range_m - before.range_m) <= kSteady * sigma_m + kFastest * between_s;
}

void FusedModel::take_side(FusedCore & core, Side side, const RangeReading & reading) const
{
  const bool left = side == Side::kLeft;
  const Source source = left ? Source::kSideLeft : Source::kSideRight;
  const bool walled =
    (left ? flight_.spec().left : flight_.spec().right) == stetro_site::Side::kWalled;
  if (reading.status == RangeStatus::kAbsent) {
    return;
  }
  const SideRangeAiding & aiding = sides_[left ? 0 : 1];
  if (
    !walled || reading.status != RangeStatus::kValid ||
    core.monitors[static_cast<std::size_t>(aiding.ranger())].stuck() ||
    !wall_fills_cone(core, reading.range_m) ||
    reading.range_m > robot_.range_sensor.reliable_range_m) {
    core.reports[source].note({Outcome::kNotVisible, Refusal::kNone});
    return;
  }
  const Expectation expected = aiding.expect(core.filter.state());
  // What answers from nearer than a wall that is out of reach is not the wall.
  const double variance = range_variance_m2(expected.value());
  const double spread_m =
    std::sqrt(gate_ * core.filter.innovation(expected, reading.range_m, variance).variance);
  if (expected.value() - spread_m > robot_.range_sensor.reliable_range_m) {
    core.reports[source].note({Outcome::kNotVisible, Refusal::kNone});
    return;
  }
  const double y_variance = core.filter.variance(kStateY);
  const Outcome outcome =
    use(core, source, expected, reading.range_m, variance, side_corrects(core));
  const SourceReport & report = core.reports[source];
  note_slip(core, kStateY, left ? -report.innovation : report.innovation, report, y_variance);
  if (outcome == Outcome::kFused) {
    core.used_at[static_cast<std::size_t>(aiding.ranger())] = core.time;
  }
}

// A range tells only what it can. What it depends on by a product (gain and distance) or nearly
// alike (offset and heading) it cannot tell apart before another source knows one of the two;
// linearised at one doubtful estimate after the other it would seem to (in SLAM: Huang, Mourikis
// and Roumeliotis 2010). A side range moreover grows with the slant to either side alike.
Corrects FusedModel::side_corrects(const FusedCore & core) const
{
  const ErrorStateFilter & filter = core.filter;
  Corrects corrects = Corrects::all();
  if (squared(filter[kStateYaw]) < squared(kSureOfSide) * filter.variance(kStateYaw)) {
    corrects = corrects.but(kStateYaw);
  }
  if (filter.variance(kStateY) > squared(params_.fused.priors.range_offset_m)) {
    for (const Ranger ranger : {Ranger::kSideLeft, Ranger::kSideRight}) {
      corrects = corrects.but(offset_index(ranger)).but(gain_index(ranger));
    }
  }
  return corrects;
}

// The pair tells the heading as well as it is calibrated and no better, however often it is asked.
Corrects FusedModel::front_corrects(const FusedCore & core, double range_m) const
{
  const FusedPriors & prior = params_.fused.priors;
  const double apart_m = robot_.at(Place::kFrontLeft).y_m - robot_.at(Place::kFrontRight).y_m;
  const double error_m = std::hypot(prior.range_offset_m, prior.range_gain * range_m);
  const double told = 2.0 * squared(error_m / apart_m);  // variance [rad^2]
  const double variance = core.filter.variance(kStateYaw);
  if (variance < told / squared(kKnownBetter)) {
    return Corrects::all();
  }
  if (variance < told) {
    return Corrects::only(kStateX);
  }
  Corrects corrects = Corrects::all();
  for (const Ranger ranger : {Ranger::kFrontLeft, Ranger::kFrontRight}) {
    corrects = corrects.but(offset_index(ranger)).but(gain_index(ranger));
  }
  return corrects;
}

void FusedModel::take_front(
  FusedCore & core, const FrontRangeAiding & aiding, const RangeReading & reading) const
{
  const bool left = aiding.ranger() == Ranger::kFrontLeft;
  const Place place = left ? Place::kFrontLeft : Place::kFrontRight;
  SourceReport & report = core.reports[left ? Source::kFrontLeft : Source::kFrontRight];
  if (reading.status == RangeStatus::kAbsent) {
    return;
  }
  const auto heights = core.steps.heights_in_flight();
  std::optional<int> seen;
  double beam_z_m = 0.0;
  if (reading.status == RangeStatus::kValid && heights) {
    beam_z_m = (*heights)[0] + robot_.at(place).height_m;
    seen = riser_ahead(flight_, beam_z_m, params_.heading.nosing_margin_m);
  }
  const int beyond = seen ? *seen - (*core.located_on + 1) : -1;
  if (
    beyond < 0 || beyond > 2 || sees_side_wall(core, place, reading.range_m) ||
    core.monitors[static_cast<std::size_t>(aiding.ranger())].stuck()) {
    report.note({Outcome::kNotVisible, Refusal::kNone});
    return;
  }
  const Expectation expected = aiding.expect(
    core.filter.state(), static_cast<SeenRiser>(beyond), beyond == 2 ? tread_m(*seen - 1) : 0.0);
  // Past the edges of the riser the cone takes in the tread below and the one above. That shortens
  // the reading, so it must not be what tells that the cone is clear.
  const double clear_m =
    std::min(beam_z_m - flight_.tread_z_m(*seen - 1), flight_.tread_z_m(*seen) - beam_z_m);
  const double far_m = std::max(reading.range_m, expected.value());
  const bool clipped = far_m * std::tan(robot_.range_sensor.cone_rad / 2.0) > clear_m;
  // What else it sees shifts all readings alike: no number of them tells more than this of x.
  const double shift = squared(params_.fused.noise.clipped_share * far_m);
  if (clipped && core.filter.variance(kStateX) < shift) {
    report.note({Outcome::kNotVisible, Refusal::kNone});
    return;
  }
  double variance = range_variance_m2(reading.range_m);
  variance += clipped ? shift : 0.0;
  variance += beyond == 2 ? squared(params_.fused.priors.tread_m) : 0.0;
  const double x_variance = core.filter.variance(kStateX);
  const Outcome outcome = use(
    core, left ? Source::kFrontLeft : Source::kFrontRight, expected, reading.range_m, variance,
    clipped || beyond == 2 ? Corrects::only(kStateX) : front_corrects(core, reading.range_m));
  if (!clipped) {
    note_slip(core, kStateX, -report.innovation, report, x_variance);
  }
  if (outcome == Outcome::kFused) {
    core.used_at[static_cast<std::size_t>(aiding.ranger())] = core.time;
  }
}

// The side walls end some way before and behind the flight. A cone that looks past an end measures
// the nearer part of the wall alone: 15 mm short at 20 deg, half a metre before the stairs.
void FusedModel::take_block3_front(FusedCore & core, const RangeReading & reading) const
{
  if (reading.status == RangeStatus::kAbsent) {
    return;
  }
  SourceReport & report = core.reports[Source::kBlock3Front];
  const auto seen =
    reading.status == RangeStatus::kValid ? block3_sees(core, reading.range_m) : std::nullopt;
  if (!seen) {
    report.note({Outcome::kNotVisible, Refusal::kNone});
    return;
  }
  double variance = range_variance_m2(reading.range_m);
  if (*seen == SeenRiser::kBehind) {  // its direction is forgotten
    const double off_middle_m = core.filter[kStateY] - core.filter[kStateWidth] / 2.0;
    variance += squared(off_middle_m * params_.fused.priors.riser_direction_rad);
  }
  const double x_variance = core.filter.variance(kStateX);
  const Expectation expected = block3_front_.expect(core.filter.state(), *seen);
  if (use(core, Source::kBlock3Front, expected, reading.range_m, variance) == Outcome::kFused) {
    core.used_at[static_cast<std::size_t>(Ranger::kBlock3Front)] = core.time;
  }
  note_slip(core, kStateX, -report.innovation, report, x_variance);
}

// While block 3 is the lowest it looks below block 2 at the riser that block 2 passes or passed.
std::optional<SeenRiser> FusedModel::block3_sees(const FusedCore & core, double range_m) const
{
  const auto heights = core.steps.heights_in_flight();
  if (!heights) {
    return std::nullopt;
  }
  const double beam_z_m = (*heights)[2] + robot_.at(Place::kBlock3Front).height_m;
  const auto seen = riser_ahead(flight_, beam_z_m, params_.heading.nosing_margin_m);
  const int beyond = seen ? *seen - (*core.located_on + 1) : -2;
  if (beyond < -1 || beyond > 0) {
    return std::nullopt;
  }
  const double below_m = beam_z_m - flight_.tread_z_m(*seen - 1);
  const double above_m = std::min((*heights)[1], flight_.tread_z_m(*seen)) - beam_z_m;
  const double reach_m = range_m * std::tan(robot_.range_sensor.cone_rad / 2.0);
  if (std::min(below_m, above_m) < std::max(reach_m, params_.heading.nosing_margin_m)) {
    return std::nullopt;
  }
  return static_cast<SeenRiser>(beyond);
}

bool FusedModel::wall_fills_cone(const FusedCore & core, double range_m) const
{
  const double overrun_m = flight_.spec().wall_overrun_m;
  const double x_m = core.edge_x_m + core.filter[kStateX];
  const double reach_m =
    range_m * std::tan(std::abs(core.filter[kStateYaw]) + robot_.range_sensor.cone_rad / 2.0);
  return x_m - reach_m > -overrun_m && x_m + reach_m < flight_.total_run_m() + overrun_m;
}

// Beside a wall the cone of the outer beam takes the wall in and reads short, which looks like a
// turn: at contact, 1.5 cm from the wall, by tens of degrees.
bool FusedModel::sees_side_wall(const FusedCore & core, Place place, double range_m) const
{
  const auto & mount = robot_.at(place);
  const double yaw = core.filter[kStateYaw];
  const double beam_y_m =
    core.filter[kStateY] + mount.x_m * std::sin(yaw) + mount.y_m * std::cos(yaw);
  const double reach_m =
    range_m * std::tan(robot_.range_sensor.cone_rad / 2.0) + params_.heading.wall_margin_m;
  return beam_y_m < reach_m || core.filter[kStateWidth] - beam_y_m < reach_m;
}

void FusedModel::note_slip(
  FusedCore & core, int axis, double innovation_m, const SourceReport & report,
  double variance_before) const
{
  ErrorStateFilter & filter = core.filter;
  const double kept = filter.variance(axis) / variance_before;
  const auto slip =
    core.slips[axis == kStateX ? 0 : 1].add(innovation_m, report.innovation_variance, kept);
  if (!slip) {
    return;
  }
  double & lately_m = core.slipped_m[axis == kStateX ? 0 : 1];
  // Before the first contact the calibration shifts them, too.
  const bool known = filter.variance(axis) < squared(params_.fused.priors.range_offset_m / 2.0);
  lately_m += known ? slip->shift_m : 0.0;
  const bool standing = core.time - core.rolled_at > kNoSlipBehind;
  const double most_m = params_.fused.most_slip_m / (standing ? 2.0 : 1.0);
  if (std::abs(lately_m) > most_m) {
    doubt(core, axis, lately_m);
    lately_m = 0.0;
  } else if (!standing) {
    filter.shift(axis, slip->shift_m, slip->variance_m2);
    core.slipping_until = core.time + kSlipGoesOn;
  }
}

// The sum of both side ranges knows nothing of y, the difference of the front pair nothing of x:
// what shifts them is a sensor, or the gyroscope. They are watched once contacts have calibrated
// them.
void FusedModel::watch_pairs(FusedCore & core, const RangeSample & sample) const
{
  if (core.filter.variance(kStateY) > squared(params_.fused.priors.range_offset_m / 2.0)) {
    return;
  }
  Expectation sum(0.0);
  sum.depends_on(kStateWidth, 1.0);
  const auto width = watch_pair(core, core.width_watch, sample, kSidePair, sum);
  if (width) {
    doubt(core, kStateY, width->shift_m);
  }
  Expectation difference(0.0);
  difference.depends_on(
    kStateYaw, robot_.at(Place::kFrontLeft).y_m - robot_.at(Place::kFrontRight).y_m);
  const auto turn = watch_pair(core, core.turn_watch, sample, kFrontPair, difference);
  if (turn) {
    doubt_heading(core, turn->shift_m);
  }
}

std::optional<Slip> FusedModel::watch_pair(
  const FusedCore & core, SlipWatch & watch, const RangeSample & sample, const RangerPair & pair,
  Expectation model) const
{
  double e_m = 0.0;
  double noise = 0.0;
  for (const PairedRanger & one : pair) {
    const SourceReport & report = core.reports[one.source];
    const RangeReading & reading = sample[one.place];
    const double variance = range_variance_m2(reading.range_m);
    const bool seen = report.outcome == Outcome::kFused || report.outcome == Outcome::kGated;
    if (
      reading.status != RangeStatus::kValid || !seen ||
      report.innovation_variance > kMostlyNoise * variance) {
      return std::nullopt;
    }
    model.depends_on(offset_index(one.ranger), one.sign);
    model.depends_on(gain_index(one.ranger), one.sign * reading.range_m);
    e_m += one.sign * report.innovation;
    noise += variance;
  }
  const double variance = core.filter.innovation(model, 0.0, noise).variance;
  return variance < 2.0 * noise ? watch.add(e_m, variance, 1.0) : std::nullopt;
}

void FusedModel::doubt_heading(FusedCore & core, double difference_m) const
{
  const double apart_m = robot_.at(Place::kFrontLeft).y_m - robot_.at(Place::kFrontRight).y_m;
  core.doubted[2] = true;
  core.filter.inflate(kStateYaw, squared(difference_m / apart_m));
  core.filter.inflate(kStateGyroBias, squared(params_.gyro.bias_sigma_radps));
  for (const Ranger ranger : {Ranger::kFrontLeft, Ranger::kFrontRight}) {
    core.filter.inflate(offset_index(ranger), squared(difference_m));
    core.filter.inflate(gain_index(ranger), squared(params_.fused.priors.range_gain));
  }
}

// No slip is so long, and none happens at a stand: a sensor has changed, or someone moved the
// robot. Either may be true until the next contact.
void FusedModel::doubt(FusedCore & core, int axis, double shift_m) const
{
  const bool along = axis == kStateX;
  core.doubted[along ? 0 : 1] = true;
  core.filter.inflate(axis, squared(shift_m));
  for (const Ranger ranger : along ? std::array{Ranger::kFrontLeft, Ranger::kFrontRight}
                                   : std::array{Ranger::kSideLeft, Ranger::kSideRight}) {
    core.filter.inflate(offset_index(ranger), squared(shift_m));
    core.filter.inflate(gain_index(ranger), squared(params_.fused.priors.range_gain));
  }
}

}  // namespace stetro_localizer
