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

#include "stetro_localizer/lift_watch.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_localizer
{
namespace
{

constexpr int kSettleSamples = 3;
constexpr double kReferenceShare = 2.0;   // of lift_off_m: blocks 1 and 3 have moved apart
constexpr double kLongestFall_s = 0.5;    // a block that takes longer is driven [s]
constexpr double kTreadShare = 0.5;       // of the lowest riser: one tread higher, not level
constexpr double kAloftClearance = 0.02;  // nearer ground may be what block 2 stands on [m]

using Heights = std::array<double, 3>;

// How far the blocks have moved against each other.
double spread_m(const Heights & now, const Heights & before)
{
  const double a = now[0] - before[0];
  const double b = now[1] - before[1];
  const double c = now[2] - before[2];
  return std::max({a, b, c}) - std::min({a, b, c});
}

double moved_apart_m(
  const Heights & now, const Heights & before, std::size_t upper, std::size_t lower)
{
  return (now[upper] - now[lower]) - (before[upper] - before[lower]);
}

double median(double a, double b, double c)
{
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

std::optional<double> difference(std::optional<double> a, std::optional<double> b)
{
  return a && b ? std::optional<double>(*a - *b) : std::nullopt;
}

void raise(std::uint8_t & count) { count = static_cast<std::uint8_t>(std::min(count + 1, 255)); }

}  // namespace

bool LiftWatch::observe(
  const StepModel & model, const BlockSample & sample, const StepEvidence & evidence)
{
  for (const BlockReading & block : sample.blocks) {
    if (block.fault) {
      return false;
    }
  }
  note_gap(model, sample.stamp, evidence);
  stamp_ = sample.stamp;
  travel_m_ = evidence.travel_m;
  if (!travel_m_) {
    lift_off_travel_m_.reset();  // the way of this lift cycle has a hole
    votes_.travel_m.reset();
  }
  note_heights(model, sample, evidence.pitch_rad.value_or(0.0));
  loads_known_ = true;
  for (std::size_t i = 0; i < sample.blocks.size(); ++i) {
    const BlockReading & block = sample.blocks[i];
    now_.bearing[i] = block.load_known && block.load >= model.params().bearing_load;
    loads_known_ = loads_known_ && block.load_known;
  }
  block2_ = sample.blocks[1];
  note_signs(model, sample, evidence);
  note_stillness(model, evidence);
  note_conflict(model, evidence);
  return true;
}

// Heights above the lowest block cannot be compared from sample to sample, differences can. Their
// median of three samples is not moved by a single one that is far off.
void LiftWatch::note_heights(const StepModel & model, const BlockSample & sample, double pitch_rad)
{
  const auto height_m = [&](std::size_t i) {
    return sample.blocks[i].height_m * std::cos(pitch_rad) -
           model.block_x_m(i) * std::sin(pitch_rad);
  };
  const Heights raw_m{height_m(0) - height_m(2), height_m(1) - height_m(2), 0.0};
  if (raw_samples_ == 0) {
    raw_m_.fill(raw_m);
  }
  raise(raw_samples_);
  for (std::size_t i = 0; i < 2; ++i) {
    now_.height_m[i] = median(raw_m[i], raw_m_[0][i], raw_m_[1][i]);
  }
  raw_m_ = {raw_m, raw_m_[0]};
}

// A body that rolled by more than the block's length and a half may have climbed meanwhile.
void LiftWatch::note_gap(const StepModel & model, Nanoseconds stamp, const StepEvidence & evidence)
{
  const bool silent = stamp_ != Nanoseconds{0} && seconds(stamp - stamp_) > model.params().gap_s;
  const auto rolled_m = difference(evidence.travel_m, travel_m_);
  gap_ = silent && !(rolled_m && std::abs(*rolled_m) < 1.5 * model.block_length_m());
}

void LiftWatch::note_signs(
  const StepModel & model, const BlockSample & sample, const StepEvidence & evidence)
{
  for (std::size_t i = 0; i < sample.blocks.size(); ++i) {
    const BlockReading & block = sample.blocks[i];
    if (block.moving || (block.load_known && !now_.bearing[i])) {
      raise(signs_[i]);
    }
  }
  const double limit_m = model.down1_contact_m() + model.params().down_tolerance_m;
  if (!sample.blocks[0].load_known && evidence.block1_down_m > limit_m) {
    raise(signs_[0]);
  }
}

void LiftWatch::note_stillness(const StepModel & model, const StepEvidence & evidence)
{
  const bool moved = spread_m(now_.height_m, still_m_) > model.params().still_m;
  if (still_samples_ == 0 || moved || now_.bearing[1] != still_bearing_) {
    still_m_ = now_.height_m;
    still_bearing_ = now_.bearing[1];
    still_since_ = stamp_;
    still_samples_ = 0;
    still_travel_m_ = travel_m_;
    down_.clear();
  }
  raise(still_samples_);
  if (evidence.block2_down_m) {
    down_.add(*evidence.block2_down_m);
  }
  settled_ =
    still_samples_ >= kSettleSamples && seconds(stamp_ - still_since_) >= model.params().settle_s;
  if (settled_ || settled_at_ == Nanoseconds{0}) {
    settled_at_ = stamp_;
  }
  restless_ = seconds(stamp_ - settled_at_) >= model.params().restless_s;
}

void LiftWatch::note_conflict(const StepModel & model, const StepEvidence & evidence)
{
  const double limit_m = model.down2_contact_m() + model.params().down_tolerance_m;
  const bool stands = now_.bearing[1] && settled_;
  if (!(stands && evidence.block2_down_m && *evidence.block2_down_m > limit_m)) {
    conflict_since_ = Nanoseconds{0};
    conflict_ = false;
    return;
  }
  if (conflict_since_ == Nanoseconds{0}) {
    conflict_since_ = stamp_;
  }
  conflict_ = seconds(stamp_ - conflict_since_) >= model.params().conflict_s;
}

LiftChange LiftWatch::advance(const StepModel & model, const StepEvidence & evidence)
{
  if (gap_) {
    gap_ = false;
    return LiftChange::kGap;
  }
  return lifted_ ? advance_lifted(model, evidence) : advance_grounded(model, evidence);
}

LiftChange LiftWatch::advance_grounded(const StepModel & model, const StepEvidence & evidence)
{
  if (!resting_) {
    return settled_ ? rest_here() : LiftChange::kNothing;
  }
  const double limit_m = model.params().lift_off_m;
  const auto apart_m = [this](std::size_t a, std::size_t b) {
    return std::abs(moved_apart_m(now_.height_m, rest_.height_m, a, b));
  };
  const bool carries =
    apart_m(0, 2) > kReferenceShare * limit_m && (was_lifted(0) || was_lifted(2));
  if (votes_.open && !votes_.others_lifted && carries) {
    votes_.others_lifted = true;
    return LiftChange::kSupports;
  }
  const bool others_went = was_lifted(0) && was_lifted(2) && signs_[1] == 0;
  const bool went =
    apart_m(0, 2) <= limit_m && apart_m(0, 1) > limit_m && apart_m(1, 2) > limit_m && !others_went;
  if (persists(went)) {
    open(model, rest_.height_m);
    return LiftChange::kLiftedOff;
  }
  if (settled_ && !went && spread_m(now_.height_m, rest_.height_m) > limit_m) {
    const bool unlifted = unlifted_change(model);
    rest_here();
    return unlifted ? LiftChange::kUnlifted : LiftChange::kRested;
  }
  if (settled_) {
    rest_.bearing = now_.bearing;
  }
  return switch_closed(evidence) ? LiftChange::kSwitched : LiftChange::kNothing;
}

LiftChange LiftWatch::advance_lifted(const StepModel & model, const StepEvidence & evidence)
{
  const double reference_m = std::abs(moved_apart_m(now_.height_m, origin_m_, 0, 2));
  const double limit_m = model.params().lift_off_m;
  if (persists(reference_m > kReferenceShare * limit_m)) {
    if (was_lifted(0) || was_lifted(2)) {
      votes_.others_lifted = true;
      votes_.level_m = level_m_;
      lifted_ = false;
      resting_ = false;
      return LiftChange::kSupports;
    }
    return settled_ ? LiftChange::kUnlifted : LiftChange::kNothing;
  }
  if (reference_m > limit_m) {
    return LiftChange::kNothing;  // without its reference the level means nothing
  }
  level_m_ = 0.5 * (moved_apart_m(now_.height_m, origin_m_, 1, 0) +
                    moved_apart_m(now_.height_m, origin_m_, 1, 2));
  const bool slow = seconds(stamp_ - opened_) > kLongestFall_s;
  votes_.lift_seen = votes_.lift_seen || was_lifted(1) || slow;
  collect_ranges(model, evidence);
  if (!settled_) {
    votes_.travel_m = difference(still_travel_m_, lift_off_travel_m_);
    return LiftChange::kNothing;
  }
  collect_level(model, block2_);
  return LiftChange::kLevel;
}

// What single readings far off can feign lasts for two samples at most.
bool LiftWatch::persists(bool shown)
{
  shown ? raise(shown_samples_) : void(shown_samples_ = 0);
  return shown_samples_ >= kSettleSamples;
}

void LiftWatch::open(const StepModel & model, const Heights & from_m)
{
  const double tread_m = kTreadShare * model.lowest_riser_m();
  origin_m_ = from_m;
  votes_ = LiftVotes{};
  votes_.open = true;
  votes_.block1_above = from_m[0] - from_m[1] > tread_m ? 1 : 0;
  votes_.block2_above = from_m[1] - from_m[2] > tread_m ? 1 : 0;
  lift_off_travel_m_ = travel_m_;
  level_m_ = 0.0;
  opened_ = stamp_;
  shown_samples_ = 0;
  signs_.fill(0);
  lifted_ = true;
  resting_ = false;
  switches_open_ = false;
  front_.clear();
  block3_front_.clear();
}

void LiftWatch::collect_ranges(const StepModel & model, const StepEvidence & evidence)
{
  if (evidence.front_m) {
    front_.add(*evidence.front_m);
    votes_.front_m = front_.median();
  }
  const bool sees_below = now_.offset_m(1, 2) >= model.block3_view_m();
  if (evidence.block3_front_m && sees_below) {
    block3_front_.add(*evidence.block3_front_m);
    votes_.block3_front_m = block3_front_.median();
  }
}

void LiftWatch::collect_level(const StepModel & model, const BlockReading & block2)
{
  votes_.level_m = level_m_;
  votes_.moving = block2.moving;
  votes_.bearing = block2.load_known ? std::optional<bool>(now_.bearing[1]) : std::nullopt;
  votes_.down_m = down_.median();
  votes_.travel_m = difference(still_travel_m_, lift_off_travel_m_);
  const double clearance_m = votes_.down_m.value_or(0.0) - model.down2_contact_m();
  if (!now_.bearing[1] && clearance_m > kAloftClearance) {
    votes_.ground_m = level_m_ - clearance_m;
  }
}

// The first closure after both were seen open: a switch that sticks never votes.
bool LiftWatch::switch_closed(const StepEvidence & evidence)
{
  if (!votes_.open || votes_.switch_way_m || !lift_off_travel_m_ || !votes_.travel_m) {
    return false;
  }
  const bool closed = evidence.riser_left.is_closed() || evidence.riser_right.is_closed();
  if (!switches_open_) {
    switches_open_ = !closed && evidence.riser_left.known && evidence.riser_right.known;
    return false;
  }
  if (!closed || !travel_m_) {
    return false;
  }
  votes_.switch_way_m = *travel_m_ - *lift_off_travel_m_ - *votes_.travel_m;
  return true;
}

// Two blocks have moved against each other, and neither is block 1 or 3 and was lifted. Block 2's
// own lifts begin a cycle and never come here.
bool LiftWatch::unlifted_change(const StepModel & model) const
{
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i + 1; j < 3; ++j) {
      const double apart_m = std::abs(moved_apart_m(now_.height_m, rest_.height_m, i, j));
      const bool lifted = (i != 1 && was_lifted(i)) || (j != 1 && was_lifted(j));
      if (apart_m > model.tolerance_m() && !lifted) {
        return true;
      }
    }
  }
  return false;
}

LiftChange LiftWatch::rest_here()
{
  rest_ = now_;
  resting_ = true;
  for (std::size_t i = 0; i < 3; ++i) {
    signs_[i] = now_.bearing[i] ? std::uint8_t{0} : signs_[i];
  }
  return LiftChange::kRested;
}

void LiftWatch::land()
{
  lifted_ = false;
  rest_here();
}

void LiftWatch::restart()
{
  lifted_ = resting_ = settled_ = restless_ = conflict_ = gap_ = false;
  still_samples_ = raw_samples_ = shown_samples_ = 0;
  signs_.fill(0);
  votes_ = LiftVotes{};
  conflict_since_ = settled_at_ = Nanoseconds{0};
}

void LiftWatch::reopen(const StepModel & model, const std::array<double, 3> & from_m)
{
  open(model, from_m);
  votes_.lift_seen = true;
  lift_off_travel_m_.reset();
}

}  // namespace stetro_localizer
