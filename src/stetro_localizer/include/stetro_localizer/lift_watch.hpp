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

#ifndef STETRO_LOCALIZER__LIFT_WATCH_HPP_
#define STETRO_LOCALIZER__LIFT_WATCH_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "stetro_localizer/samples.hpp"
#include "stetro_localizer/step_counter.hpp"
#include "stetro_localizer/step_evidence.hpp"
#include "stetro_localizer/step_model.hpp"

namespace stetro_localizer
{

/// What a sample of the blocks has shown.
enum class LiftChange {
  kNothing,
  kRested,     ///< the blocks have settled in another posture, block 2 on the ground
  kLiftedOff,  ///< block 2 has left its place: a lift cycle begins, its votes are empty
  kLevel,      ///< block 2 has settled at a height of its lift cycle
  kSupports,   ///< block 1 or 3 was lifted: block 2 stands where it was last
  kSwitched,   ///< a riser switch has closed for the first time since the touch-down
  kUnlifted,   ///< blocks stand otherwise than before although none of them was lifted
  kGap         ///< the robot rolled on while no block was heard
};

/// Follows the heights of the three blocks and collects what a lift cycle of block 2 shows.
/**
 * Who moved follows from the heights alone: a block that is lifted changes its height against the
 * two others, which keep theirs. Loads and motion flags only vote.
 *
 *   grounded --(block 2 moved against 1 and 3)--> lifted      its place was `rest`
 *   lifted   --(landed() by whoever judges)-----> grounded
 *   lifted   --(1 and 3 moved apart, one lifted)-> grounded   only block 2 can carry the robot
 *
 * Trivially copyable; nothing is allocated.
 */
class LiftWatch
{
public:
  /// Takes a sample; call advance() then.
  /** \return false if it says nothing about the heights */
  bool observe(const StepModel & model, const BlockSample & sample, const StepEvidence & evidence);

  /// What the last sample has changed.
  LiftChange advance(const StepModel & model, const StepEvidence & evidence);

  /// Block 2 stands where it is now.
  void land();
  /// Forgets posture and cycle; the next settled posture is a new beginning.
  void restart();
  /// Goes on in a lift cycle that began from these heights, unseen.
  void reopen(const StepModel & model, const std::array<double, 3> & from_m);

  [[nodiscard]] const LiftVotes & votes() const { return votes_; }
  [[nodiscard]] bool lifted() const { return lifted_; }
  [[nodiscard]] bool settled() const { return settled_; }
  /// The heights have not settled for longer than any lift takes: nothing is seen in them.
  [[nodiscard]] bool restless() const { return restless_; }
  [[nodiscard]] bool loads_known() const { return loads_known_; }
  /// The present posture has settled with block 2 on the ground.
  [[nodiscard]] bool resting() const { return resting_; }
  /// The last settled posture with block 2 on the ground, heights above block 3.
  /** Loads that are unknown do not bear. */
  [[nodiscard]] const BlockPattern & rest() const { return rest_; }
  /// The blocks as they are now, heights above block 3.
  [[nodiscard]] const BlockPattern & now() const { return now_; }
  /// Heights from which block 2 was lifted last [m].
  [[nodiscard]] const std::array<double, 3> & origin_m() const { return origin_m_; }
  /// Load on block 2 and its downward range have contradicted each other for too long.
  [[nodiscard]] bool conflict() const { return conflict_; }

private:
  using Heights = std::array<double, 3>;

  void note_heights(const StepModel & model, const BlockSample & sample, double pitch_rad);
  void note_gap(const StepModel & model, Nanoseconds stamp, const StepEvidence & evidence);
  void note_signs(
    const StepModel & model, const BlockSample & sample, const StepEvidence & evidence);
  void note_stillness(const StepModel & model, const StepEvidence & evidence);
  void note_conflict(const StepModel & model, const StepEvidence & evidence);
  LiftChange advance_grounded(const StepModel & model, const StepEvidence & evidence);
  LiftChange advance_lifted(const StepModel & model, const StepEvidence & evidence);
  void open(const StepModel & model, const Heights & from_m);
  void collect_ranges(const StepModel & model, const StepEvidence & evidence);
  void collect_level(const StepModel & model, const BlockReading & block2);
  bool switch_closed(const StepEvidence & evidence);
  bool persists(bool shown);
  [[nodiscard]] bool unlifted_change(const StepModel & model) const;
  [[nodiscard]] bool was_lifted(std::size_t block) const { return signs_[block] >= kSigns; }
  LiftChange rest_here();

  static constexpr std::uint8_t kSigns = 2;  // samples that make a lift

  BlockPattern now_;
  BlockPattern rest_;
  std::array<Heights, 2> raw_m_{};  // of the last two samples, above block 3
  Heights still_m_{};               // where the present stillness began
  Heights origin_m_{};              // where the lift cycle began
  LiftVotes votes_;
  ReadingWindow down_;
  ReadingWindow front_;
  ReadingWindow block3_front_;
  BlockReading block2_;
  std::optional<double> lift_off_travel_m_;
  std::optional<double> still_travel_m_;  // travel when the present stillness began
  std::optional<double> travel_m_;        // of the last sample
  Nanoseconds stamp_{0};
  Nanoseconds still_since_{0};
  Nanoseconds settled_at_{0};
  Nanoseconds opened_{0};
  Nanoseconds conflict_since_{0};
  double level_m_ = 0.0;
  std::array<std::uint8_t, 3> signs_{};  // samples that showed each block lifted since rest
  std::uint8_t still_samples_ = 0;
  std::uint8_t raw_samples_ = 0;
  std::uint8_t shown_samples_ = 0;  // in a row that showed a lift-off, or the others apart
  bool still_bearing_ = false;      // block 2's load, as the present stillness began
  bool settled_ = false;
  bool restless_ = false;
  bool loads_known_ = false;
  bool resting_ = false;  // rest_ is valid
  bool lifted_ = false;
  bool switches_open_ = false;  // both were, since the touch-down
  bool gap_ = false;
  bool conflict_ = false;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__LIFT_WATCH_HPP_
