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
constexpr double kResolution = 0.001;  // readings come in whole millimetres [m]

constexpr std::array<std::pair<Ranger, Place>, kRangerCount> kWatched{{
  {Ranger::kSideLeft, Place::kSideLeft},
  {Ranger::kSideRight, Place::kSideRight},
  {Ranger::kFrontLeft, Place::kFrontLeft},
  {Ranger::kFrontRight, Place::kFrontRight},
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
  take_side(core, Side::kLeft, sample[Place::kSideLeft]);
  take_side(core, Side::kRight, sample[Place::kSideRight]);
  take_front(core, fronts_[0], sample[Place::kFrontLeft]);
  take_front(core, fronts_[1], sample[Place::kFrontRight]);
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
  const Outcome outcome =
    use(core, source, expected, reading.range_m, range_variance_m2(expected.value()));
  const SourceReport & report = core.reports[source];
  const double z = report.innovation / std::sqrt(report.innovation_variance);
  note_slip(core, kStateY, left ? -z : z);
  if (outcome == Outcome::kFused) {
    core.used_at[static_cast<std::size_t>(aiding.ranger())] = core.time;
  }
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
  // Past the edges of the riser the cone takes in the tread below and the one above.
  const double clear_m =
    std::min(beam_z_m - flight_.tread_z_m(*seen - 1), flight_.tread_z_m(*seen) - beam_z_m);
  const bool clipped = reading.range_m * std::tan(robot_.range_sensor.cone_rad / 2.0) > clear_m;
  // What else it sees shifts all readings alike: no number of them tells more than this of x.
  const double shift = squared(params_.fused.noise.clipped_share * reading.range_m);
  if (clipped && core.filter.variance(kStateX) < shift) {
    report.note({Outcome::kNotVisible, Refusal::kNone});
    return;
  }
  double variance = range_variance_m2(reading.range_m);
  variance += clipped ? shift : 0.0;
  variance += beyond == 2 ? squared(params_.fused.priors.tread_m) : 0.0;
  const auto target = static_cast<SeenRiser>(beyond);
  const Outcome outcome = use(
    core, left ? Source::kFrontLeft : Source::kFrontRight,
    aiding.expect(core.filter.state(), target, beyond == 2 ? tread_m(*seen - 1) : 0.0),
    reading.range_m, variance, clipped || beyond == 2 ? Corrects::kAlongOnly : Corrects::kAll);
  if (!clipped) {
    note_slip(core, kStateX, -report.innovation / std::sqrt(report.innovation_variance));
  }
  if (outcome == Outcome::kFused) {
    core.used_at[static_cast<std::size_t>(aiding.ranger())] = core.time;
  }
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

void FusedModel::note_slip(FusedCore & core, int axis, double normalised) const
{
  SlipWatch & watch = core.slips[axis == kStateX ? 0 : 1];
  if (watch.add(normalised)) {
    core.filter.inflate(axis, squared(params_.fused.slip_jump_m));
    core.slipping_until = core.time + kSlipGoesOn;
  }
}

}  // namespace stetro_localizer
