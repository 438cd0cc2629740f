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

#ifndef STETRO_LOCALIZER__STEP_FILTER_HPP_
#define STETRO_LOCALIZER__STEP_FILTER_HPP_

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "stetro_localizer/integrity.hpp"
#include "stetro_localizer/lift_watch.hpp"
#include "stetro_localizer/samples.hpp"
#include "stetro_localizer/step_belief.hpp"
#include "stetro_localizer/step_counter.hpp"
#include "stetro_localizer/step_evidence.hpp"
#include "stetro_localizer/step_model.hpp"

namespace stetro_localizer
{

/// Counts the steps with a hidden-Markov filter over the step index, up and down.
/**
 * The hidden state is the tread block 2 stands on, or was lifted from (D1-12), and whether block 2
 * is aloft. One lift cycle of block 2 is one step in time of the chain: it ends one tread lower, on
 * the same tread, one higher, is still under way, or is none of these (`jump`). Every sensor votes
 * once in a cycle, with an outlier floor, docs/derivations/step_filter.md. The forward recursion
 * begins anew from the belief at lift-off whenever a vote changes, so the order of votes is
 * indifferent and a vote may come late: a switch that closes after the touch-down still counts.
 *
 *   awaiting --(settled blocks can stand so)------------> counting
 *   awaiting --(they cannot)----------------------------> lost
 *   counting --(probability of a jump > lost_probability)--> lost
 *   counting --(heights changed, nothing was lifted)----> lost
 *   counting --(published step would change by two)-----> lost
 *   lost     --(told)-----------------------------------> awaiting
 *
 * While counting, the step is published if its probability is publish_probability at least, else
 * the filter says kStepUncertain. Nothing but evidence or a person makes it certain again.
 *
 * The filter refers to its model, which must live as long. Copying it is copying its state.
 */
class StepFilter
{
public:
  explicit StepFilter(const StepModel & model) : model_(&model) {}

  /// Takes the step as a person told it; the next settled blocks must allow it, or it is lost.
  /** \throws std::invalid_argument if the flight has no such step */
  void tell(int step);

  /// Takes step 0 for a robot without history; the next settled blocks must stand level.
  void assume_foot();

  /// Takes what was stored; it is resolved against the next settled blocks.
  /** As StepCounter::restore(). \throws std::invalid_argument if the flight has no such step */
  void restore(const StepState & stored);

  [[nodiscard]] bool has(int step) const { return model_->has(step); }

  /// The step is unknown from now on.
  void forget();

  /// Takes a sample of the blocks with what is known beside them.
  /**
   * Samples in order of their stamps. \return what became of the published step; an event that was
   * uncertain at first is reported when it has become certain
   */
  StepEvent add(const BlockSample & sample, const StepEvidence & evidence);

  /// The step; nothing while lost, awaiting or uncertain.
  [[nodiscard]] std::optional<int> step() const;
  /// The step that is most probable, certain or not; as told until the blocks have settled; nothing
  /// while lost or otherwise awaiting.
  [[nodiscard]] std::optional<int> most_probable() const;
  /// Of the most probable step, 0 to 1; 0 while lost or awaiting.
  [[nodiscard]] double probability() const;
  /// The second most probable step; probability 0 while lost or awaiting.
  [[nodiscard]] StepProbability runner_up() const;
  /// Of any one step; 0 while lost or awaiting.
  [[nodiscard]] double probability_of(int step) const;
  /// That the step is none that the lift cycles explain; 1 while lost.
  [[nodiscard]] double probability_elsewhere() const;

  [[nodiscard]] bool lost() const { return mode_ == Mode::kLost; }
  [[nodiscard]] bool awaiting_blocks() const
  {
    return mode_ != Mode::kLost && mode_ != Mode::kCounting;
  }
  /// Bits of `Reason`: kNotInitialised while awaiting, kStepUncertain while lost, uncertain or in
  /// conflict.
  [[nodiscard]] std::uint32_t reasons() const;
  /// Load on block 2 and its downward range have contradicted each other for too long.
  [[nodiscard]] bool evidence_conflicts() const { return watch_.conflict(); }

  /// Undersides above the flight frame's zero [m], by the most probable step; nothing without one.
  [[nodiscard]] std::optional<std::array<double, 3>> heights_in_flight() const;
  [[nodiscard]] bool block2_aloft() const { return watch_.lifted(); }
  /// What should survive a restart; nothing while the step is unknown or uncertain.
  [[nodiscard]] std::optional<StepState> state_to_store() const;

private:
  enum class Mode : std::uint8_t { kLost, kTold, kAssumed, kStored, kCounting };

  void require(int step) const;
  void begin_at(int step);
  StepEvent start();
  StepEvent start_from_stored(const BlockPattern & now);
  StepEvent follow(LiftChange change);
  StepEvent judge();
  void commit();
  void smear();
  [[nodiscard]] bool certain() const;
  [[nodiscard]] bool posture_fits(BlockPattern posture) const;
  [[nodiscard]] bool carried_by_1_and_3() const;
  StepEvent publish(bool stands);
  StepEvent lose();

  const StepModel * model_;
  Mode mode_ = Mode::kLost;
  bool landed_ = false;  // the cycle's touch-down was certain
  bool misfit_ = false;  // all blocks seem to stand, as they cannot on that step
  int published_ = 0;    // the last step that was certain
  StepBelief before_;    // at the last lift-off
  StepBelief belief_;    // now
  LiftWatch watch_;
  StepState stored_;  // while it waits for the blocks
};

static_assert(std::is_trivially_copyable_v<StepFilter>, "part of a snapshot that is rewound");
static_assert(sizeof(StepFilter) < 1024, "part of a snapshot that is rewound");

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__STEP_FILTER_HPP_
