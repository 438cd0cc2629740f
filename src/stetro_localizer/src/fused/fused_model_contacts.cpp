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

// What switches and lifts mean: contact with walls and risers, and the step.

#include <algorithm>
#include <cmath>
#include <limits>

#include "stetro_localizer/fused/bumper_aiding.hpp"
#include "stetro_localizer/fused/fused_model.hpp"
#include "stetro_localizer/fused/riser_switch_aiding.hpp"

namespace stetro_localizer
{
namespace
{

// A switch that chatters says the same thing again, with the same error.
constexpr Nanoseconds kLeastBetween = std::chrono::seconds(1);
constexpr std::size_t kRiserSwitch = 3;  // behind the three bumpers of its side

double squared(double value) { return value * value; }

bool just_closed(const Switch & before, const Switch & now)
{
  return before.known && !before.closed && now.is_closed();
}

}  // namespace

void FusedModel::take_one(FusedCore & core, const ContactSample & sample) const
{
  advance(core, sample.stamp);
  if (core.located_on) {
    for (const Side side : {Side::kLeft, Side::kRight}) {
      take_bumpers(core, side, sample);
      take_riser_switch(core, side, sample);
    }
  }
  core.contacts = sample;
}

void FusedModel::take_bumpers(FusedCore & core, Side side, const ContactSample & sample) const
{
  const bool left = side == Side::kLeft;
  const auto & before = left ? core.contacts.left : core.contacts.right;
  const auto & now = left ? sample.left : sample.right;
  auto & closed_at = core.closed_at[left ? 0 : 1];
  const bool open_before =
    std::none_of(before.begin(), before.end(), [](const Switch & one) { return one.is_closed(); });
  bool first = open_before;  // of a sweep: later ones find a corrected y
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!just_closed(before[i], now[i]) || sample.stamp - closed_at[i] < kLeastBetween) {
      continue;
    }
    closed_at[i] = sample.stamp;
    const auto gap = [&] {
      return expect_bumper(
        core.filter.state(), side, robot_.block_x_m(static_cast<int>(i) + 1), robot_.block_length_m,
        robot_.contact_width_m);
    };
    if (first) {
      note_closure(core, left, gap().value());
      first = false;
    }
    take_suspected_slip(core, kStateY);
    use_contact(
      core, left ? Source::kBumperLeft : Source::kBumperRight, gap(), kStateY,
      squared(params_.fused.noise.bumper_m));
  }
}

// Eq. (3) takes the robot for square to the wall. Turned by psi it touches with a corner, l sin psi
// farther out, so what is noted is the y of a square robot with the same gap (D1-2).
void FusedModel::note_closure(FusedCore & core, bool left, double gap_m) const
{
  const double half_m = robot_.contact_width_m / 2.0;
  if (left) {
    core.closure.note_left(core.filter[kStateWidth] - half_m - gap_m);
  } else {
    core.closure.note_right(half_m + gap_m);
  }
}

void FusedModel::take_riser_switch(FusedCore & core, Side side, const ContactSample & sample) const
{
  const bool left = side == Side::kLeft;
  const Switch & before = left ? core.contacts.riser_left : core.contacts.riser_right;
  const Switch & now = left ? sample.riser_left : sample.riser_right;
  Nanoseconds & closed_at = core.closed_at[left ? 0 : 1][kRiserSwitch];
  if (
    *core.located_on == flight_.steps() || !just_closed(before, now) ||
    sample.stamp - closed_at < kLeastBetween) {
    return;
  }
  closed_at = sample.stamp;
  take_suspected_slip(core, kStateX);
  const double tip_y_m = left ? robot_.switch_y_m : -robot_.switch_y_m;
  const Expectation gap = expect_riser_switch(core.filter.state(), robot_.switch_x_m, tip_y_m);
  core.gauge_ahead.touch(core.filter[kStateX] + gap.value(), core.travel_m);  // the gap is none
  const Outcome outcome = use_contact(
    core, Source::kRiserSwitches, gap, kStateX, squared(params_.fused.noise.riser_switch_m));
  if (
    outcome == Outcome::kFused && sample.riser_left.is_closed() && sample.riser_right.is_closed()) {
    core.doubted[kStateYaw] = false;  // one alone tells x
  }
}

// A contact is the surest of all measurements. Where it surprises, the estimate was wrong, unless
// the surprise is beyond what a slip can do: then the robot has touched something else.
Outcome FusedModel::use_contact(
  FusedCore & core, Source source, const Expectation & gap, int axis, double variance) const
{
  Innovation innovation = core.filter.innovation(gap, 0.0, variance);
  const double surprise_m2 = squared(innovation.value);
  if (innovation.nis() > gate_ && surprise_m2 < squared(params_.fused.contact_gate_m)) {
    explain_surprise(core, axis, surprise_m2);
    innovation = core.filter.innovation(gap, 0.0, variance);  // by the doubt that is known now
  }
  const Outcome outcome = use(core, source, gap, innovation);
  if (outcome == Outcome::kFused) {
    core.slips[axis].clear();  // it has been corrected
    core.unconfirmed_m[axis] = 0.0;
    core.hand_over.let_out(static_cast<std::size_t>(axis));
    core.doubted[axis] = false;
    ++core.landmarks;
  }
  return outcome;
}

void FusedModel::take_one(FusedCore & core, const BlockSample & sample) const
{
  advance(core, sample.stamp);
  core.blocks_moving = std::any_of(
    sample.blocks.begin(), sample.blocks.end(), [](const auto & block) { return block.moving; });
  const StepEvent event = core.steps.add(sample, step_evidence(core, sample.stamp));
  core.landmarks += event == StepEvent::kNone ? 0 : 1;
  follow_step(core, core.steps.most_probable());
}

StepEvidence FusedModel::step_evidence(const FusedCore & core, Nanoseconds time) const
{
  const auto young_m = [&](Place place) {
    const RangeReading & reading = core.last_ranges[place];
    const bool counts = reading.status == RangeStatus::kValid &&
                        seconds(time - reading.stamp) <= params_.max_sample_age_s;
    return counts ? std::optional<double>(reading.range_m) : std::nullopt;
  };
  StepEvidence evidence;
  evidence.block1_down_m = young_m(Place::kBlock1Down);
  evidence.block2_down_m = young_m(Place::kBlock2Down);
  evidence.block3_front_m = young_m(Place::kBlock3Front);
  evidence.front_m = front_m(core, time);
  if (
    core.wheels_time != Nanoseconds{0} &&
    seconds(time - core.wheels_time) <= params_.max_sample_age_s) {
    evidence.travel_m = core.travel_m;
  }
  if (seconds(time - core.gyro_time) <= params_.max_sample_age_s) {
    evidence.pitch_rad = core.pitch_rad;
  }
  evidence.riser_left = core.contacts.riser_left;
  evidence.riser_right = core.contacts.riser_right;
  return evidence;
}

// From base_link to the riser that the front pair sees; infinite if both look into the free.
std::optional<double> FusedModel::front_m(const FusedCore & core, Nanoseconds time) const
{
  double sum_m = 0.0;
  int free = 0;
  for (const Place place : {Place::kFrontLeft, Place::kFrontRight}) {
    const RangeReading & reading = core.last_ranges[place];
    if (seconds(time - reading.stamp) > params_.max_sample_age_s) {
      return std::nullopt;
    }
    if (reading.status == RangeStatus::kNoTarget) {
      ++free;
    } else if (reading.status == RangeStatus::kValid) {
      sum_m += reading.range_m + robot_.at(place).x_m;
    } else {
      return std::nullopt;
    }
  }
  if (free > 0) {
    return free == 2 ? std::optional<double>(std::numeric_limits<double>::infinity())
                     : std::nullopt;
  }
  return sum_m / 2.0 * std::cos(core.filter[kStateYaw]);
}

// The filter of the pose goes on with the most probable step; whether it may be believed is said
// by integrity, not by standing still.
void FusedModel::follow_step(FusedCore & core, std::optional<int> step) const
{
  if (!step) {
    core.located_on.reset();
    return;
  }
  if (core.located_on == step) {
    return;
  }
  const FusedPriors & prior = params_.fused.priors;
  ErrorStateFilter & filter = core.filter;
  const double tread_variance = squared(prior.tread_m);
  const double riser_variance = squared(prior.riser_direction_rad);
  if (core.located_on == *step - 1) {
    core.left_behind = as_built_here(core);  // its tread leaves the state
    hand_gauge_on(core);
    core.edge_x_m += filter[kStateTreadAhead];
    core.rise_m += flight_.riser_m(*step);
    filter.climb(tread_m(*step + 1), tread_variance, riser_variance);
  } else if (core.located_on == *step + 1) {
    core.left_behind = as_built_here(core);
    core.gauged_here.reset();
    core.gauge_ahead = {};
    core.edge_x_m -= filter[kStateTreadHere];
    core.rise_m -= flight_.riser_m(*step + 1);
    filter.descend(tread_m(*step), tread_variance, riser_variance);
  } else {
    locate(core, *step);
    return;
  }
  filter.inflate(kStateWidth, squared(prior.width_change_m));
  core.located_on = step;
  core.closure = ContactClosure(filter[kStateWidth], robot_.contact_width_m);
}

}  // namespace stetro_localizer
