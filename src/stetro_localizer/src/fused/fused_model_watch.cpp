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

// What a slip looks like in the ranges, and what no slip can be.

#include <algorithm>
#include <cmath>

#include "stetro_localizer/fused/fused_model.hpp"

namespace stetro_localizer
{
namespace
{

constexpr Nanoseconds kSlipGoesOn = std::chrono::milliseconds(200);
constexpr Nanoseconds kNoSlipBehind = std::chrono::seconds(1);  // at a stand: it would be noticed
constexpr double kMostlyNoise = 3.0;  // an innovation's variance in that of the reading

constexpr double kExplained = 2.5;         // standard deviations of what both ranges have in common
constexpr std::uint32_t kAlikeInARow = 5;  // refusals of both front ranges
constexpr double kUntoldHeading = 0.02;    // no contact has told it: it is known so badly [rad]
constexpr double kSure = 2.0;              // standard deviations of a shift at a stand
constexpr double kJust = 0.2;              // a range so young vouches for the estimate [s]

constexpr RangerPair kSidePair{{
  {Ranger::kSideLeft, Place::kSideLeft, Source::kSideLeft, 1.0, -1.0},
  {Ranger::kSideRight, Place::kSideRight, Source::kSideRight, 1.0, 1.0},
}};
constexpr RangerPair kFrontPair{{
  {Ranger::kFrontLeft, Place::kFrontLeft, Source::kFrontLeft, 1.0, -1.0},
  {Ranger::kFrontRight, Place::kFrontRight, Source::kFrontRight, -1.0, -1.0},
}};

double squared(double value) { return value * value; }

/// The ranges that tell x, or y.
const RangerPair & pair_along(int axis) { return axis == kStateX ? kFrontPair : kSidePair; }

/// A range that has just agreed with the estimate would have told if it was wrong.
bool vouches(const FusedCore & core, const PairedRanger & one)
{
  return seconds(core.time - core.used_at[static_cast<std::size_t>(one.ranger)]) < kJust;
}

}  // namespace

// Before the first contact what shifts a range may as well be its calibration.
bool FusedModel::calibrated(const FusedCore & core, int axis) const
{
  return core.filter.variance(axis) < squared(params_.fused.priors.range_offset_m / 2.0);
}

void FusedModel::note_slip(
  FusedCore & core, int axis, double innovation_m, const SourceReport & report,
  double variance_before) const
{
  ErrorStateFilter & filter = core.filter;
  const double most_of_slip_m =
    params_.fused.most_slip_m + std::sqrt(gate_ * report.innovation_variance);
  if (std::abs(innovation_m) > most_of_slip_m) {
    return;  // something stands in the beam, or the sensor is out
  }
  const double kept = filter.variance(axis) / variance_before;
  const auto slip = core.slips[axis].add(innovation_m, report.innovation_variance, kept);
  if (!slip) {
    return;
  }
  double & lately_m = core.slipped_m[axis];
  lately_m += calibrated(core, axis) ? slip->shift_m : 0.0;
  const bool standing = core.time - core.rolled_at > kNoSlipBehind;
  const double most_m = standing
                          ? params_.fused.most_slip_m / 2.0 + kSure * std::sqrt(slip->variance_m2)
                          : params_.fused.most_slip_m;
  if (std::abs(lately_m) > most_m) {
    doubt(core, axis, lately_m);
    lately_m = 0.0;
  } else if (!standing) {
    filter.shift(axis, slip->shift_m, slip->variance_m2);
    core.slipping_until = core.time + kSlipGoesOn;
    const bool unconfirmed = calibrated(core, axis) && told_by_one(core, axis);
    core.unconfirmed_m[axis] += unconfirmed ? slip->shift_m : 0.0;
  }
}

// To a single sensor a slip and a fault of its own look alike.
bool FusedModel::told_by_one(const FusedCore & core, int axis) const
{
  const RangerPair & pair = pair_along(axis);
  return !std::all_of(
    pair.begin(), pair.end(), [&core](const PairedRanger & one) { return vouches(core, one); });
}

double FusedModel::suspected_slip_m(const FusedCore & core, int axis) const
{
  return calibrated(core, axis) ? core.slips[axis].suspected_m() : 0.0;
}

double FusedModel::suspected_turn_rad(const FusedCore & core) const
{
  return core.turn_watch.suspected_m() / robot_.front_baseline_m();
}

// Before a contact, which is about to tell where the robot is, a false alarm costs little, while a
// slip that is missed would be taken for an error of the ranges.
void FusedModel::take_suspected_slip(FusedCore & core, int axis) const
{
  const auto slip = core.slips[axis].suspected();
  if (slip) {
    core.filter.shift(axis, slip->shift_m, slip->variance_m2);
    core.slips[axis].clear();
  }
}

// A range that has just agreed with the estimate would have told of a slip: it is as wrong as the
// estimate is, by its calibration, as far as that can be. Where none has, the robot slipped unseen.
void FusedModel::explain_surprise(FusedCore & core, int axis, double surprise_m2) const
{
  StateVector together = StateVector::Unit(axis);
  const double surprise_m = std::sqrt(surprise_m2);
  const double of_offset = std::min(1.0, params_.fused.priors.range_offset_m / surprise_m);
  // More than an offset is likely to be, or what was taken for a slip was none.
  const bool of_gain = of_offset < 1.0 || std::abs(core.unconfirmed_m[axis]) > surprise_m / 2.0;
  for (const PairedRanger & one : pair_along(axis)) {
    if (vouches(core, one)) {
      together[offset_index(one.ranger)] = -one.outward * of_offset;
      if (of_gain) {
        core.filter.inflate(gain_index(one.ranger), squared(params_.fused.priors.range_gain));
      }
    }
  }
  core.filter.inflate(together, surprise_m2);
}

// Front ranges that are refused again and again. Both alike: the robot has slipped farther than was
// thought possible while it saw no riser, for two sensors do not break in the same way. One alone
// while nothing but the pair has told the heading: that may be what is wrong. Otherwise it is a
// fault.
void FusedModel::reconsider_front(FusedCore & core, const SourceReport & refused) const
{
  const SourceReport & left = core.reports[Source::kFrontLeft];
  const SourceReport & right = core.reports[Source::kFrontRight];
  const double apart_m = left.innovation - right.innovation;
  const bool alike =
    squared(apart_m) < gate_ * (left.innovation_variance + right.innovation_variance);
  const auto in_a_row = std::min(left.reject_streak, right.reject_streak);
  if (alike && in_a_row >= kAlikeInARow) {
    core.filter.inflate(kStateX, squared(refused.innovation));
  } else if (
    refused.reject_streak == params_.fused.alerts.reject_streak &&
    core.filter.variance(kStateYaw) > squared(kUntoldHeading)) {
    StateVector turned = StateVector::Zero();  // about the other one's beam, which agrees
    turned[kStateX] = -refused.innovation / 2.0;
    turned[kStateYaw] =
      (&refused == &left ? 1.0 : -1.0) * refused.innovation / robot_.front_baseline_m();
    core.filter.inflate(turned, 1.0);
  }
}

// A side range that is refused again and again: with nothing else in sight that could tell, the
// estimate may be what is wrong.
void FusedModel::reconsider_side(FusedCore & core, Side side, const SourceReport & refused) const
{
  const PairedRanger & other = kSidePair[side == Side::kLeft ? 1 : 0];
  if (refused.reject_streak == params_.fused.alerts.reject_streak && !vouches(core, other)) {
    doubt(core, kStateY, refused.innovation);
  }
}

// The sum of both side ranges knows nothing of y, the difference of the front pair nothing of x:
// what shifts them is a sensor, or the gyroscope. They are watched once contacts have calibrated
// them.
void FusedModel::watch_pairs(FusedCore & core, const RangeSample & sample) const
{
  if (!calibrated(core, kStateY)) {
    return;
  }
  Expectation sum(0.0);
  sum.depends_on(kStateWidth, 1.0);
  const auto width = watch_pair(core, core.width_watch, sample, kSidePair, sum);
  if (width) {
    doubt(core, kStateY, width->shift_m);
  }
  Expectation difference(0.0);
  difference.depends_on(kStateYaw, robot_.front_baseline_m());
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
    if (
      reading.status != RangeStatus::kValid || !saw_target(report.outcome) ||
      report.innovation_variance > kMostlyNoise * variance) {
      return std::nullopt;
    }
    model.depends_on(offset_index(one.ranger), one.sign);
    model.depends_on(gain_index(one.ranger), one.sign * reading.range_m);
    e_m += one.sign * report.innovation;
    noise += variance;
  }
  const double variance = core.filter.innovation(model, 0.0, noise).variance;
  if (variance > 2.0 * noise) {
    return std::nullopt;
  }
  // Noise differs from reading to reading, the doubt of the calibration is in all of them alike.
  const double explained_m = kExplained * std::sqrt(variance - noise);
  return watch.add(e_m - std::clamp(e_m, -explained_m, explained_m), variance, 1.0);
}

void FusedModel::doubt_heading(FusedCore & core, double difference_m) const
{
  difference_m = doubtful_m(difference_m);
  core.doubted[kStateYaw] = true;
  core.filter.inflate(kStateYaw, squared(difference_m / robot_.front_baseline_m()));
  core.filter.inflate(kStateGyroBias, squared(params_.gyro.bias_sigma_radps));
  doubt_pair(core, kFrontPair, difference_m);
}

// No slip is so long, and none happens at a stand: a sensor has changed, or someone moved the
// robot. Either may be true until the next contact.
void FusedModel::doubt(FusedCore & core, int axis, double shift_m) const
{
  shift_m = doubtful_m(shift_m);
  core.doubted[axis] = true;
  core.filter.inflate(axis, squared(shift_m));
  doubt_pair(core, pair_along(axis), shift_m);
}

// The filter has followed a part of what shifts it before that is found: how far a sensor is out is
// no better known than how far it may be.
double FusedModel::doubtful_m(double shift_m) const
{
  return std::max(std::abs(shift_m), params_.fused.alerts.offset_m);
}

void FusedModel::doubt_pair(FusedCore & core, const RangerPair & pair, double shift_m) const
{
  for (const PairedRanger & one : pair) {
    core.filter.inflate(offset_index(one.ranger), squared(shift_m));
    core.filter.inflate(gain_index(one.ranger), squared(params_.fused.priors.range_gain));
  }
}

}  // namespace stetro_localizer
