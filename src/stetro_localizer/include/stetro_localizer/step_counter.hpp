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

#ifndef STETRO_LOCALIZER__STEP_COUNTER_HPP_
#define STETRO_LOCALIZER__STEP_COUNTER_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "stetro_localizer/samples.hpp"

namespace stetro_localizer
{

/// The three undersides at rest: which blocks carry the robot, and how they stand to each other.
struct BlockPattern
{
  std::array<double, 3> height_m{};  ///< above the lowest of the three [m]
  std::array<bool, 3> bearing{};     ///< the block stands on something

  [[nodiscard]] bool all_bear() const { return bearing[0] && bearing[1] && bearing[2]; }
  [[nodiscard]] double offset_m(std::size_t upper, std::size_t lower) const
  {
    return height_m[upper] - height_m[lower];
  }
};

/// What the counter knows, and what survives a restart.
struct StepState
{
  int step = 0;                       ///< tread block 2 stands on or was lifted from, 0 the floor
  BlockPattern pattern;               ///< the last settled one
  double lift_off_offset_m = 0.0;     ///< block 2 above block 3 when both stood last [m]
  double lift_off_reference_m = 0.0;  ///< block 1 above block 3 at that time [m]
};

/// Limits of the step counter.
struct StepCounterParams
{
  double bearing_load = 0.05;       ///< share of the weight from which on a block stands [-]
  double tolerance_share = 0.25;    ///< of the riser: height that still counts as the same [-]
  std::int64_t settle_samples = 3;  ///< samples in a row that make a touch-down
  double down_tolerance_m = 0.02;   ///< block2_down may exceed its contact reading by this [m]
  double conflict_s = 1.0;          ///< contradicting evidence of this duration is a fault [s]
};

/// What one sample changed.
enum class StepEvent {
  kNone,
  kSettled,   ///< another pattern stands; the step is the same
  kClimbed,   ///< block 2 touched down one tread higher
  kOldTread,  ///< block 2 touched down where it was lifted from
  kUndone,    ///< block 2 stands one tread lower than it did
  kLost       ///< the evidence contradicts itself; the step is unknown until told
};

/// Counts the steps by the lift cycle: the papers' readStep(), which they do not describe.
/**
 * The step index is the tread block 2 stands on (D1-12). It changes at block 2's confirmed
 * touch-down and nowhere else (D3-14). While block 2 is lifted, blocks 1 and 3 stand and are the
 * reference. With delta = height of block 2 above block 3 at touch-down, less the same at lift-off:
 *
 *   standing --(block 2 unloaded)---------------> aloft     remember offset and reference
 *   aloft    --(loaded, still, delta = +riser)--> standing  kClimbed, step + 1
 *   aloft    --(loaded, still, delta = 0)-------> standing  kOldTread
 *   aloft    --(loaded, still, delta = -riser)--> standing  kUndone, step - 1
 *   aloft    --(any other delta, or blocks 1 and 3 moved against each other)--> lost
 *   standing --(no block was lifted, block 2 alone is lower by a riser)--> standing  kUndone
 *   standing --(no block was lifted, any other change of the heights)----> lost
 *   lost     --(told)---------------------------> standing
 *
 * A touch-down needs load on block 2, no motion, `settle_samples` in a row, and no contradiction by
 * block2_down; a tread is counted once since only the difference to the lift-off counts.
 * Without load evidence nothing is concluded.
 */
class StepCounter
{
public:
  /// \param risers_m height of riser 1, 2, ..., N [m]
  /// \param down_contact_m what block2_down reads when block 2 stands [m]
  /// \throws std::invalid_argument if there is no riser or one is not positive
  StepCounter(
    std::vector<double> risers_m, double down_contact_m, const StepCounterParams & params);

  /// Takes the step as a person told it; the next settled blocks must allow it, or it is lost.
  /** \throws std::invalid_argument if the flight has no such step */
  void tell(int step);

  /// Takes step 0 for a robot without history; the next settled blocks must stand level.
  /**
   * The body is longer than a tread, so a level robot stands on the floor below or on the landing.
   */
  void assume_foot();

  /// Takes what was stored; it is resolved against the next settled blocks.
  /**
   *  - blocks that stood and stand have kept their offsets: the same step
   *  - block 2 was aloft and stands: the touch-down rule above decides
   *  - anything else is ambiguous: lost until told
   * \throws std::invalid_argument if the flight has no such step
   */
  void restore(const StepState & stored);

  /// The flight has such a step: 0, the floor, to N.
  [[nodiscard]] bool has(int step) const
  {
    return step >= 0 && step <= static_cast<int>(risers_m_.size());
  }

  /// The step is unknown from now on.
  void forget();

  /// \param down_m reading of block2_down [m], nothing if it gives no evidence
  StepEvent add(const BlockSample & sample, std::optional<double> down_m);

  /// The step; nothing while lost, or while a stored one is not yet compared with the blocks.
  [[nodiscard]] std::optional<int> step() const;

  /// The blocks and the stored pattern have not been compared yet.
  [[nodiscard]] bool awaiting_blocks() const
  {
    return mode_ != Mode::kLost && mode_ != Mode::kCounting;
  }

  /// Load on block 2 and its downward range have contradicted each other for too long.
  [[nodiscard]] bool evidence_conflicts() const { return conflict_; }

  /// Undersides above the flight frame's zero [m]; nothing while the step is unknown.
  [[nodiscard]] std::optional<std::array<double, 3>> heights_in_flight() const;

  [[nodiscard]] bool block2_aloft() const { return !state_.pattern.bearing[1]; }
  /// What should survive a restart; nothing while the step is unknown or not yet confirmed.
  [[nodiscard]] std::optional<StepState> state_to_store() const
  {
    const bool sound = mode_ == Mode::kCounting || mode_ == Mode::kStored;
    return sound ? std::optional<StepState>(state_) : std::nullopt;
  }

private:
  enum class Mode { kLost, kTold, kAssumed, kStored, kCounting };

  void require(int step) const;
  [[nodiscard]] bool same_height(double a_m, double b_m) const;
  [[nodiscard]] bool pairs_kept(const BlockPattern & before, const BlockPattern & now) const;
  [[nodiscard]] bool plausible(int step, const BlockPattern & pattern) const;
  [[nodiscard]] double riser_m(int index) const;  // of riser 1..N; NaN beyond, equal to no height
  [[nodiscard]] std::optional<BlockPattern> observe(const BlockSample & sample) const;
  [[nodiscard]] bool settled(const BlockPattern & pattern, const BlockSample & sample);
  [[nodiscard]] bool contact_doubted(bool stands, std::optional<double> down_m, Nanoseconds stamp);
  StepEvent conclude(const BlockPattern & pattern);
  StepEvent touch_down(const BlockPattern & pattern);
  StepEvent stand_on(const BlockPattern & pattern);
  StepEvent resume(const BlockPattern & pattern);
  StepEvent keep(const BlockPattern & pattern, StepEvent event);
  StepEvent lose();

  std::vector<double> risers_m_;
  double down_contact_m_;
  StepCounterParams params_;
  Mode mode_ = Mode::kLost;
  StepState state_;
  std::array<double, 3> latest_m_{};  // heights of the last usable sample, settled or not
  std::array<bool, 3> candidate_{};   // bearing set seen in the last samples
  std::int64_t candidate_samples_ = 0;
  Nanoseconds conflict_since_{0};
  bool conflict_ = false;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__STEP_COUNTER_HPP_
