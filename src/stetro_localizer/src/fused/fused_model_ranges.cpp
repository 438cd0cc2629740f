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

// What range readings mean.

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

constexpr double kSteady = 6.0;        // standard deviations between one reading and the next
constexpr double kFastest = 0.5;       // a range changes [m/s]
constexpr double kKnownBetter = 3.0;   // another source told the heading so many times better
constexpr double kSureOfSide = 3.0;    // standard deviations of the heading
constexpr double kSurelySeen = 0.9;    // of the reach: a wall so near is not missed for long
constexpr double kResolution = 0.001;  // readings come in whole millimetres [m]

constexpr std::array<std::pair<Ranger, Place>, kWatchedCount> kWatched{{
  {Ranger::kSideLeft, Place::kSideLeft},
  {Ranger::kSideRight, Place::kSideRight},
  {Ranger::kFrontLeft, Place::kFrontLeft},
  {Ranger::kFrontRight, Place::kFrontRight},
}};

double squared(double value) { return value * value; }

Corrects holding(Corrects corrects, std::array<Ranger, 2> calibrations)
{
  for (const Ranger ranger : calibrations) {
    corrects = corrects.but(offset_index(ranger)).but(gain_index(ranger));
  }
  return corrects;
}

constexpr std::array<Source, 5> kRangeSources{
  Source::kSideLeft, Source::kSideRight, Source::kFrontLeft, Source::kFrontRight,
  Source::kBlock3Front};

/// Those whose target is in sight, believed or not: a bit for each.
std::uint32_t in_sight(const SourceReports & reports)
{
  std::uint32_t bits = 0;
  for (const Source source : kRangeSources) {
    bits = bits << 1U | (saw_target(reports[source].outcome) ? 1U : 0U);
  }
  return bits;
}

bool misses(const RangeReading & reading)
{
  return reading.status == RangeStatus::kNoTarget || reading.status == RangeStatus::kWeak;
}

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
    if (reading.status != RangeStatus::kAbsent) {
      core.last_ranges[place] = reading;
    }
  }
  for (const auto & [ranger, place] : kWatched) {
    core.monitors[static_cast<std::size_t>(ranger)].note(sample[place]);
  }
  if (!core.located_on) {
    return;
  }
  const std::array<double, 2> before{core.filter[kStateX], core.filter[kStateY]};
  take_side(core, Side::kLeft, confirmed[Place::kSideLeft]);
  take_side(core, Side::kRight, confirmed[Place::kSideRight]);
  take_front(core, fronts_[0], confirmed[Place::kFrontLeft]);
  take_front(core, fronts_[1], confirmed[Place::kFrontRight]);
  take_block3_front(core, confirmed[Place::kBlock3Front]);
  core.hand_over.note(
    in_sight(core.reports), core.time,
    {core.filter[kStateX] - before[0], core.filter[kStateY] - before[1]});
  watch_pairs(core, confirmed);
  gauge_tread_ahead(core, sample);
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
  RangeMonitor & monitor = core.monitors[static_cast<std::size_t>(aiding.ranger())];
  const double reach_m = robot_.range_sensor.reliable_range_m;
  const Expectation expected = aiding.expect(core.filter.state());
  const Innovation innovation =
    core.filter.innovation(expected, reading.range_m, range_variance_m2(expected.value()));
  const double spread_m = std::sqrt(gate_ * innovation.variance);
  if (
    walled && misses(reading) && expected.value() + spread_m < kSurelySeen * reach_m &&
    wall_fills_cone(core, expected.value())) {
    monitor.miss();
  }
  // What answers from nearer than a wall that is out of reach is not the wall.
  const bool in_reach = expected.value() - spread_m <= reach_m && reading.range_m <= reach_m;
  if (
    !walled || !in_reach || reading.status != RangeStatus::kValid || monitor.stuck() ||
    !wall_fills_cone(core, reading.range_m)) {
    core.reports[source].note({Outcome::kNotVisible, Refusal::kNone});
    return;
  }
  const double y_variance = core.filter.variance(kStateY);
  const Outcome outcome = use(core, source, expected, innovation, side_corrects(core));
  const SourceReport & report = core.reports[source];
  note_slip(core, kStateY, left ? -report.innovation : report.innovation, report, y_variance);
  if (outcome == Outcome::kGated) {
    reconsider_side(core, side, report);
  }
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
    corrects = holding(corrects, {Ranger::kSideLeft, Ranger::kSideRight});
  }
  return corrects;
}

// By the difference of two ranges, each with an error of this variance [rad^2].
double FusedModel::heading_variance_of_pair(double variance_m2) const
{
  return 2.0 * variance_m2 / squared(robot_.front_baseline_m());
}

// The pair tells the heading as well as it is calibrated and no better, however often it is asked.
Corrects FusedModel::front_corrects(const FusedCore & core, double range_m) const
{
  const FusedPriors & prior = params_.fused.priors;
  const double error_m = std::hypot(prior.range_offset_m, prior.range_gain * range_m);
  const double told = heading_variance_of_pair(squared(error_m));
  const double variance = core.filter.variance(kStateYaw);
  if (variance < told / squared(kKnownBetter)) {
    return Corrects::all();
  }
  if (variance < told) {
    return Corrects::only(kStateX);
  }
  return holding(Corrects::all(), {Ranger::kFrontLeft, Ranger::kFrontRight});
}

// Clipped cones look past the edges of one riser alike, so that their difference is not far out:
// good enough to begin with, and for no more than this, however often it is asked.
Corrects FusedModel::clipped_corrects(const FusedCore & core, double shift_m2) const
{
  return core.filter.variance(kStateYaw) < heading_variance_of_pair(shift_m2)
           ? Corrects::only(kStateX)
           : holding(Corrects::all(), {Ranger::kFrontLeft, Ranger::kFrontRight});
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
  const double far_m = std::max(reading.range_m, expected.value());
  const bool clipped = !cone_is_clear(beam_z_m, *seen, far_m);
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
    clipped || beyond == 2 ? clipped_corrects(core, shift) : front_corrects(core, reading.range_m));
  if (!clipped) {
    note_slip(core, kStateX, -report.innovation, report, x_variance);
  }
  if (outcome == Outcome::kGated) {
    reconsider_front(core, report);
  }
  if (outcome == Outcome::kFused) {
    core.used_at[static_cast<std::size_t>(aiding.ranger())] = core.time;
  }
}

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

// Nothing but the face of that riser is in the cone of a level beam.
bool FusedModel::cone_is_clear(double beam_z_m, int riser, double range_m) const
{
  const double clear_m =
    std::min(beam_z_m - flight_.tread_z_m(riser - 1), flight_.tread_z_m(riser) - beam_z_m);
  return range_m * std::tan(robot_.range_sensor.cone_rad / 2.0) <= clear_m;
}

// The side walls end some way before and behind the flight. A cone that looks past an end measures
// the nearer part of the wall alone: 15 mm short at 20 deg, half a metre before the stairs.
bool FusedModel::wall_fills_cone(const FusedCore & core, double range_m) const
{
  const double overrun_m = flight_.spec().wall_overrun_m;
  const double x_m = core.edge_x_m + core.filter[kStateX];
  const double reach_m =
    range_m * std::tan(std::abs(core.filter[kStateYaw]) + robot_.range_sensor.cone_rad / 2.0);
  return x_m - reach_m > -overrun_m && x_m + reach_m < flight_.total_run_m() + overrun_m;
}

bool FusedModel::wall_in_sight(const FusedCore & core) const
{
  const auto seen = [&](stetro_site::Side wall, const SideRangeAiding & aiding) {
    const double range_m = aiding.expect(core.filter.state()).value();
    return wall == stetro_site::Side::kWalled &&
           range_m < kSurelySeen * robot_.range_sensor.reliable_range_m &&
           wall_fills_cone(core, range_m);
  };
  return seen(flight_.spec().left, sides_[0]) || seen(flight_.spec().right, sides_[1]);
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

}  // namespace stetro_localizer
