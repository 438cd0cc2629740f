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

#ifndef ACCURACY__ESTIMATE_SCORER_HPP_
#define ACCURACY__ESTIMATE_SCORER_HPP_

#include <cstdint>
#include <optional>

#include "accuracy/climb_score.hpp"
#include "accuracy/fault_onset.hpp"
#include "accuracy/fault_watch.hpp"
#include "accuracy/moment.hpp"
#include "accuracy/step_watch.hpp"

namespace stetro_bringup
{

/// Watches one estimator through one climb and compares it with the truth.
/**
 * An estimate counts when it is new and the robot works on the stairs: it sweeps, or climbs, or its
 * blocks follow. It meets the truth of its own stamp. Integrity is counted each tick from the
 * climb's acceptance on, standing and waiting included, and so is an error beyond its protection
 * level: who waits with a wrong pose and calls it OK is as wrong as who works with it.
 *
 * The step changes when block 2 comes down, and an estimator counts it only when the touch-down is
 * confirmed. Until then, for half a second at most, the two speak of two treads: those estimates are
 * marked, for they are a whole tread and a riser apart without any error of measurement.
 */
class EstimateScorer
{
public:
  /// \param flight the site file's; outlives the scorer
  /// \param onset of the fault to be noticed, if one is injected
  EstimateScorer(const stetro_site::Flight & flight, const std::optional<FaultOnset> & onset);

  /// Looks at the loop after each tick.
  void watch(const Moment & now);

  /// Everything seen. Call it once, at the end.
  [[nodiscard]] ClimbScore take();

private:
  void watch_integrity(const Moment & now);
  void watch_confirmation(const Moment & now);
  void watch_closure(const Moment & now);
  void score(const Moment & now);
  [[nodiscard]] ScoredEstimate scored(const Moment & now) const;
  void watch_hand_over(const Moment & now, const ScoredEstimate & sample);
  void watch_exceedance(const ScoredEstimate & sample, stetro_driver::Time stamp);
  void end_closure();
  void end_tread();

  const stetro_site::Flight & flight_;
  std::optional<FaultOnset> onset_;
  std::optional<FaultWatch> fault_;
  StepWatch steps_;
  ClimbScore score_;
  bool was_ok_ = false;  ///< a tick ago

  std::optional<ScoredEstimate> last_;  ///< of the estimate before, if it counted
  std::optional<int> last_estimated_step_;
  std::uint32_t last_in_sight_ = 0;

  int tread_ = -1;  ///< the tread of the next two
  bool alarmed_ = false;
  bool exceeded_ = false;
  bool misled_ = false;
  bool confirming_ = false;
  stetro_driver::Time came_down_{0};

  int closing_step_ = 0;  ///< the tread of closure_m_
  std::optional<double> closure_m_;

  std::optional<stetro_driver::Time> exceeds_since_;
  int last_step_ = 0;  ///< true, a tick ago
};

}  // namespace stetro_bringup

#endif  // ACCURACY__ESTIMATE_SCORER_HPP_
