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

#include "stetro_localizer/step_counter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace stetro_localizer
{

StepCounter::StepCounter(
  std::vector<double> risers_m, double down_contact_m, const StepCounterParams & params)
: risers_m_(std::move(risers_m)), down_contact_m_(down_contact_m), params_(params)
{
  if (risers_m_.empty()) {
    throw std::invalid_argument("risers_m: empty list refused, accepted: at least one riser");
  }
  for (const double riser : risers_m_) {
    if (!(riser > 0.0)) {
      throw std::invalid_argument(
        "risers_m: " + std::to_string(riser) + " refused, accepted: more than 0");
    }
  }
}

void StepCounter::require(int step) const
{
  if (!has(step)) {
    throw std::invalid_argument(
      "step: " + std::to_string(step) + " refused, accepted: 0 to " +
      std::to_string(risers_m_.size()));
  }
}

void StepCounter::tell(int step)
{
  require(step);
  state_ = StepState{};
  state_.step = step;
  mode_ = Mode::kTold;
  candidate_samples_ = 0;
}

void StepCounter::assume_foot()
{
  tell(0);
  mode_ = Mode::kAssumed;
}

void StepCounter::restore(const StepState & stored)
{
  require(stored.step);
  state_ = stored;
  mode_ = Mode::kStored;
  candidate_samples_ = 0;
}

void StepCounter::forget() { mode_ = Mode::kLost; }

std::optional<int> StepCounter::step() const
{
  return mode_ == Mode::kCounting ? std::optional<int>(state_.step) : std::nullopt;
}

std::optional<std::array<double, 3>> StepCounter::heights_in_flight() const
{
  if (mode_ != Mode::kCounting) {
    return std::nullopt;
  }
  const double tread_m = std::accumulate(risers_m_.begin(), risers_m_.begin() + state_.step, 0.0);
  const double zero_m = state_.pattern.bearing[1]
                          ? tread_m - latest_m_[1]
                          : tread_m - state_.lift_off_offset_m - latest_m_[2];
  return std::array<double, 3>{zero_m + latest_m_[0], zero_m + latest_m_[1], zero_m + latest_m_[2]};
}

StepEvent StepCounter::add(const BlockSample & sample, std::optional<double> down_m)
{
  const std::optional<BlockPattern> pattern = observe(sample);
  if (!pattern) {
    candidate_samples_ = 0;
    return StepEvent::kNone;
  }
  latest_m_ = pattern->height_m;
  if (!settled(*pattern, sample)) {
    return StepEvent::kNone;
  }
  const bool was_aloft = mode_ == Mode::kCounting && block2_aloft();
  if (contact_doubted(pattern->bearing[1], down_m, sample.stamp) && was_aloft) {
    return StepEvent::kNone;  // the touch-down waits for its confirmation
  }
  return conclude(*pattern);
}

std::optional<BlockPattern> StepCounter::observe(const BlockSample & sample) const
{
  BlockPattern pattern;
  for (std::size_t i = 0; i < sample.blocks.size(); ++i) {
    const BlockReading & block = sample.blocks[i];
    if (block.fault || !block.load_known) {
      return std::nullopt;
    }
    pattern.height_m[i] = block.height_m;
    pattern.bearing[i] = block.load >= params_.bearing_load;
  }
  return pattern;
}

// The same blocks have carried the robot for some samples, and those are not being moved.
bool StepCounter::settled(const BlockPattern & pattern, const BlockSample & sample)
{
  bool still = true;
  for (std::size_t i = 0; i < sample.blocks.size(); ++i) {
    still = still && !(pattern.bearing[i] && sample.blocks[i].moving);
  }
  if (!still || pattern.bearing != candidate_) {
    candidate_ = pattern.bearing;
    candidate_samples_ = still ? 1 : 0;
  } else {
    ++candidate_samples_;
  }
  return candidate_samples_ >= params_.settle_samples;
}

// Block 2 stands by its load, and the range below it says otherwise. For a while that is a reason
// to wait; after that the heights and the load decide and the conflict is reported.
bool StepCounter::contact_doubted(bool stands, std::optional<double> down_m, Nanoseconds stamp)
{
  const bool doubt = stands && down_m && *down_m > down_contact_m_ + params_.down_tolerance_m;
  if (!doubt) {
    conflict_since_ = Nanoseconds{0};
    conflict_ = false;
    return false;
  }
  if (conflict_since_ == Nanoseconds{0}) {
    conflict_since_ = stamp;
  }
  conflict_ = seconds(stamp - conflict_since_) >= params_.conflict_s;
  return !conflict_;
}

StepEvent StepCounter::conclude(const BlockPattern & pattern)
{
  switch (mode_) {
    case Mode::kLost:
      return StepEvent::kNone;
    case Mode::kTold:
      return plausible(state_.step, pattern) ? keep(pattern, StepEvent::kSettled) : lose();
    case Mode::kAssumed:
      return pattern.all_bear() && same_height(pattern.offset_m(0, 1), 0.0) &&
                 same_height(pattern.offset_m(1, 2), 0.0)
               ? keep(pattern, StepEvent::kSettled)
               : lose();
    case Mode::kStored:
      return resume(pattern);
    case Mode::kCounting:
      break;
  }
  if (block2_aloft()) {
    return pattern.bearing[1] ? touch_down(pattern) : StepEvent::kNone;
  }
  return stand_on(pattern);
}

StepEvent StepCounter::touch_down(const BlockPattern & pattern)
{
  if (!same_height(pattern.offset_m(0, 2), state_.lift_off_reference_m)) {
    return lose();
  }
  const double delta_m = pattern.offset_m(1, 2) - state_.lift_off_offset_m;
  if (same_height(delta_m, riser_m(state_.step + 1))) {
    ++state_.step;
    return keep(pattern, StepEvent::kClimbed);
  }
  if (same_height(delta_m, 0.0)) {
    return keep(pattern, StepEvent::kOldTread);
  }
  if (same_height(delta_m, -riser_m(state_.step))) {
    --state_.step;
    return keep(pattern, StepEvent::kUndone);
  }
  return lose();
}

// Block 2 has stood until now.
StepEvent StepCounter::stand_on(const BlockPattern & pattern)
{
  const BlockPattern & before = state_.pattern;
  if (!pattern.bearing[1]) {
    state_.lift_off_offset_m = before.offset_m(1, 2);
    state_.lift_off_reference_m = before.offset_m(0, 2);
    return keep(pattern, StepEvent::kSettled);
  }
  if (pairs_kept(before, pattern)) {
    const bool rear_landed = pattern.bearing[2] && !before.bearing[2];
    if (rear_landed && !plausible(state_.step, pattern)) {
      return lose();
    }
    const bool changed = pattern.bearing != before.bearing;
    return changed ? keep(pattern, StepEvent::kSettled) : StepEvent::kNone;
  }
  const bool only_block2 = pattern.all_bear() && before.all_bear() &&
                           same_height(pattern.offset_m(0, 2), before.offset_m(0, 2));
  const double drop_m = pattern.offset_m(1, 2) - before.offset_m(1, 2);
  if (only_block2 && same_height(drop_m, -riser_m(state_.step))) {
    --state_.step;
    return keep(pattern, StepEvent::kUndone);
  }
  return lose();
}

StepEvent StepCounter::resume(const BlockPattern & pattern)
{
  const BlockPattern & before = state_.pattern;
  if (!before.bearing[1] && pattern.bearing[1]) {
    return touch_down(pattern);
  }
  const bool lifted = before.bearing[1] && !pattern.bearing[1];
  if (!pairs_kept(before, pattern) || (lifted && !before.all_bear())) {
    return lose();
  }
  if (lifted) {
    state_.lift_off_offset_m = before.offset_m(1, 2);
    state_.lift_off_reference_m = before.offset_m(0, 2);
  }
  if (pattern.bearing[1] && !plausible(state_.step, pattern)) {
    return lose();
  }
  return keep(pattern, StepEvent::kSettled);
}

StepEvent StepCounter::keep(const BlockPattern & pattern, StepEvent event)
{
  state_.pattern = pattern;
  mode_ = Mode::kCounting;
  return event;
}

StepEvent StepCounter::lose()
{
  mode_ = Mode::kLost;
  return StepEvent::kLost;
}

bool StepCounter::same_height(double a_m, double b_m) const
{
  const double lowest_m = *std::min_element(risers_m_.begin(), risers_m_.end());
  return std::abs(a_m - b_m) <= params_.tolerance_share * lowest_m;
}

bool StepCounter::pairs_kept(const BlockPattern & before, const BlockPattern & now) const
{
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i + 1; j < 3; ++j) {
      const bool both_stood =
        before.bearing[i] && before.bearing[j] && now.bearing[i] && now.bearing[j];
      if (both_stood && !same_height(before.offset_m(i, j), now.offset_m(i, j))) {
        return false;
      }
    }
  }
  return true;
}

// Block 3 stands on the same tread as block 2 or one lower, block 1 on the same or one higher; and
// all three on one tread only where there is room for a body longer than a tread.
bool StepCounter::plausible(int step, const BlockPattern & pattern) const
{
  if (!pattern.bearing[1]) {
    return false;
  }
  const double front_m = pattern.offset_m(0, 1);
  const double rear_m = pattern.offset_m(1, 2);
  const bool front_level = same_height(front_m, 0.0);
  const bool rear_level = same_height(rear_m, 0.0);
  const bool front_fits =
    !pattern.bearing[0] || front_level || same_height(front_m, riser_m(step + 1));
  const bool rear_fits = !pattern.bearing[2] || rear_level || same_height(rear_m, riser_m(step));
  const bool on_a_tread = step > 0 && step < static_cast<int>(risers_m_.size());
  const bool too_long = pattern.all_bear() && front_level && rear_level && on_a_tread;
  return front_fits && rear_fits && !too_long;
}

double StepCounter::riser_m(int index) const
{
  const bool exists = index >= 1 && index <= static_cast<int>(risers_m_.size());
  return exists ? risers_m_[static_cast<std::size_t>(index - 1)]
                : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace stetro_localizer
