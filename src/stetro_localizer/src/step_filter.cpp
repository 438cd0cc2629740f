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

#include "stetro_localizer/step_filter.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace stetro_localizer
{
namespace
{

constexpr double kNegligible = 1e-15;  // a share of the belief that no evidence could raise

}  // namespace

void StepFilter::require(int step) const
{
  if (!has(step)) {
    throw std::invalid_argument(
      "step: " + std::to_string(step) + " refused, accepted: 0 to " +
      std::to_string(model_->steps()));
  }
}

void StepFilter::begin_at(int step)
{
  require(step);
  before_ = belief_ = StepBelief::at(step);
  published_ = step;
  landed_ = false;
  watch_.restart();
}

void StepFilter::tell(int step)
{
  begin_at(step);
  mode_ = Mode::kTold;
}

void StepFilter::assume_foot()
{
  begin_at(0);
  mode_ = Mode::kAssumed;
}

void StepFilter::restore(const StepState & stored)
{
  begin_at(stored.step);
  stored_ = stored;
  mode_ = Mode::kStored;
}

void StepFilter::forget() { lose(); }

StepEvent StepFilter::add(const BlockSample & sample, const StepEvidence & evidence)
{
  if (!watch_.observe(*model_, sample, evidence) || mode_ == Mode::kLost) {
    return StepEvent::kNone;
  }
  if (awaiting_blocks()) {
    const bool clear = watch_.settled() && watch_.loads_known();
    const StepEvent event = clear ? start() : StepEvent::kNone;
    if (!clear || event == StepEvent::kLost || !watch_.lifted()) {
      return event;
    }
    const StepEvent next = follow(watch_.advance(*model_, evidence));
    return next == StepEvent::kNone ? event : next;
  }
  const StepEvent event = follow(watch_.advance(*model_, evidence));
  misfit_ = mode_ == Mode::kCounting && watch_.resting() && !posture_fits(watch_.rest());
  return event;
}

// The first settled blocks decide whether the step that was told, assumed or stored is possible.
StepEvent StepFilter::start()
{
  const BlockPattern & now = watch_.now();
  const auto level = [&](std::size_t upper, std::size_t lower) {
    return std::abs(now.offset_m(upper, lower)) <= model_->tolerance_m();
  };
  const Mode mode = mode_;
  mode_ = Mode::kCounting;
  if (mode == Mode::kStored) {
    return start_from_stored(now);
  }
  const bool possible = mode == Mode::kTold ? model_->fits(published_, now)
                                            : now.all_bear() && level(0, 1) && level(1, 2);
  if (!possible) {
    return lose();
  }
  watch_.land();
  return StepEvent::kSettled;
}

StepEvent StepFilter::start_from_stored(const BlockPattern & now)
{
  const BlockPattern & before = stored_.pattern;
  const auto kept = [&](double now_m, double before_m) {
    return std::abs(now_m - before_m) <= model_->tolerance_m();
  };
  if (!before.bearing[1]) {
    if (!kept(now.offset_m(0, 2), stored_.lift_off_reference_m)) {
      return lose();
    }
    watch_.reopen(*model_, {stored_.lift_off_reference_m, stored_.lift_off_offset_m, 0.0});
    return StepEvent::kSettled;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i + 1; j < 3; ++j) {
      const bool stood = before.bearing[i] && before.bearing[j];
      if (
        stood && now.bearing[i] && now.bearing[j] &&
        !kept(now.offset_m(i, j), before.offset_m(i, j))) {
        return lose();
      }
    }
  }
  if (!now.bearing[1] && before.all_bear()) {
    watch_.reopen(*model_, before.height_m);
    return StepEvent::kSettled;
  }
  if (!model_->fits(published_, now)) {
    return lose();
  }
  watch_.land();
  return StepEvent::kSettled;
}

StepEvent StepFilter::follow(LiftChange change)
{
  switch (change) {
    case LiftChange::kNothing:
      return StepEvent::kNone;
    case LiftChange::kUnlifted:
      return lose();
    case LiftChange::kGap:
      smear();
      return publish(false);
    case LiftChange::kLiftedOff:
      commit();
      return carried_by_1_and_3() ? StepEvent::kSettled : lose();
    case LiftChange::kRested:
      return StepEvent::kSettled;
    case LiftChange::kLevel:
    case LiftChange::kSupports:
    case LiftChange::kSwitched:
      return judge();
  }
  return StepEvent::kNone;
}

// With block 2 on the ground, whatever its load says.
bool StepFilter::posture_fits(BlockPattern posture) const
{
  posture.bearing[1] = true;
  return model_->fits(belief_.best().step, posture);
}

// While block 2 is lifted, blocks 1 and 3 carry the robot, whatever their loads say.
bool StepFilter::carried_by_1_and_3() const
{
  return posture_fits({watch_.origin_m(), {true, true, true}});
}

// Block 2 leaves its place: what is believed now is where the new cycle begins.
void StepFilter::commit()
{
  before_ = StepBelief::around(belief_);
  for (int step = belief_.first(); step <= belief_.last(); ++step) {
    before_.add(step, belief_.of(step));
  }
  before_.add_elsewhere(belief_.elsewhere());
  landed_ = false;
}

// The forward recursion over one lift cycle, equation (1).
StepEvent StepFilter::judge()
{
  const LiftVotes & votes = watch_.votes();
  StepBelief after = StepBelief::around(before_);
  double explained = 0.0;
  double aloft = 0.0;
  double jump = 0.0;
  for (int step = before_.first(); step <= before_.last(); ++step) {
    const double share = before_.of(step);
    if (share < kNegligible || !has(step)) {
      continue;
    }
    const LiftWeights weights = model_->weigh(step, votes);
    for (int treads = -1; treads <= 1; ++treads) {
      after.add(step + treads, share * weights.landed[static_cast<std::size_t>(treads + 1)]);
    }
    after.add(step, share * weights.aloft);
    aloft += share * weights.aloft;
    jump += share * weights.jump;
    explained += share * weights.sum();
  }
  const double known = before_.within();
  after.add_elsewhere(jump + (known > 0.0 ? before_.elsewhere() * explained / known : 1.0));
  const double total = after.within() + after.elsewhere();
  if (!after.normalise() || jump > model_->params().lost_probability * total) {
    return lose();
  }
  belief_ = after;
  const bool stands = aloft <= (1.0 - model_->params().publish_probability) * total;
  if (watch_.lifted() && stands && certain()) {
    watch_.land();
  }
  return publish(stands);
}

// After a silence in which the robot rolled: it may have climbed, or gone down, unseen.
void StepFilter::smear()
{
  const double moved = model_->params().unseen_prior;
  StepBelief after = StepBelief::around(belief_);
  for (int step = belief_.first(); step <= belief_.last(); ++step) {
    const double share = belief_.of(step);
    after.add(step, (1.0 - 2.0 * moved) * share);
    has(step + 1) ? after.add(step + 1, moved * share) : after.add_elsewhere(moved * share);
    has(step - 1) ? after.add(step - 1, moved * share) : after.add_elsewhere(moved * share);
  }
  after.add_elsewhere(belief_.elsewhere());
  before_ = belief_ = after;
  watch_.restart();
}

StepEvent StepFilter::publish(bool stands)
{
  if (!certain()) {
    return StepEvent::kNone;
  }
  const int change = belief_.best().step - published_;
  if (std::abs(change) > 1) {
    return lose();
  }
  const bool touched_down = stands && !landed_ && watch_.votes().lift_seen;
  published_ += change;
  landed_ = landed_ || stands;
  if (change != 0) {
    return change > 0 ? StepEvent::kClimbed : StepEvent::kUndone;
  }
  return touched_down ? StepEvent::kOldTread : StepEvent::kNone;
}

StepEvent StepFilter::lose()
{
  mode_ = Mode::kLost;
  misfit_ = false;
  return StepEvent::kLost;
}

bool StepFilter::certain() const
{
  return belief_.best().probability >= model_->params().publish_probability;
}

std::optional<int> StepFilter::step() const
{
  const bool known = mode_ == Mode::kCounting && certain() && !misfit_ && !watch_.restless();
  return known ? std::optional<int>(belief_.best().step) : std::nullopt;
}

std::optional<int> StepFilter::most_probable() const
{
  if (mode_ == Mode::kTold) {
    return published_;
  }
  return mode_ == Mode::kCounting ? std::optional<int>(belief_.best().step) : std::nullopt;
}

double StepFilter::probability() const
{
  return mode_ == Mode::kCounting ? belief_.best().probability : 0.0;
}

StepProbability StepFilter::runner_up() const
{
  return mode_ == Mode::kCounting ? belief_.runner_up() : StepProbability{};
}

double StepFilter::probability_of(int step) const
{
  return mode_ == Mode::kCounting ? belief_.of(step) : 0.0;
}

double StepFilter::probability_elsewhere() const
{
  return mode_ == Mode::kCounting ? belief_.elsewhere() : 1.0;
}

std::uint32_t StepFilter::reasons() const
{
  if (awaiting_blocks()) {
    return kNotInitialised;
  }
  return step() && !evidence_conflicts() ? 0u : std::uint32_t{kStepUncertain};
}

std::optional<std::array<double, 3>> StepFilter::heights_in_flight() const
{
  if (mode_ != Mode::kCounting) {
    return std::nullopt;
  }
  const std::array<double, 3> & now_m = watch_.now().height_m;
  const std::array<double, 3> & from_m = watch_.origin_m();
  const double zero_m =
    watch_.lifted() ? model_->tread_z_m(before_.best().step) - (from_m[1] - from_m[2]) - now_m[2]
                    : model_->tread_z_m(belief_.best().step) - now_m[1];
  return std::array<double, 3>{zero_m + now_m[0], zero_m + now_m[1], zero_m + now_m[2]};
}

std::optional<StepState> StepFilter::state_to_store() const
{
  if (mode_ == Mode::kStored) {
    return stored_;
  }
  if (!step()) {
    return std::nullopt;
  }
  const std::array<double, 3> & from_m = watch_.origin_m();
  StepState state;
  state.step = *step();
  state.pattern = watch_.resting() ? watch_.rest() : watch_.now();
  state.pattern.bearing[1] = !watch_.lifted();
  const auto & heights = state.pattern.height_m;
  const double lowest_m = *std::min_element(heights.begin(), heights.end());
  for (double & height_m : state.pattern.height_m) {
    height_m -= lowest_m;
  }
  state.lift_off_offset_m = from_m[1] - from_m[2];
  state.lift_off_reference_m = from_m[0] - from_m[2];
  return state;
}

}  // namespace stetro_localizer
