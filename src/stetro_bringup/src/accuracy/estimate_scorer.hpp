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

#include <cstddef>
#include <cstdint>
#include <optional>

#include "accuracy/climb_score.hpp"
#include "accuracy/closed_loop.hpp"
#include "accuracy/fault_onset.hpp"

namespace stetro_bringup
{

/// Watches one estimator through one climb and compares it with the truth.
/**
 * An estimate counts when it is new and the robot works on the stairs: it sweeps, or climbs, or its
 * blocks follow. It meets the truth of its own stamp. Integrity is counted each tick from the
 * climb's acceptance on, standing and waiting included.
 *
 * The step changes when block 2 comes down, and an estimator counts it only when the touch-down is
 * confirmed. Until then, for half a second at most, the two speak of two treads: those estimates are
 * marked, for they are a whole tread and a riser apart without any error of measurement.
 */
class EstimateScorer
{
public:
  /// \param estimator its number in the loop
  EstimateScorer(
    std::size_t estimator, const stetro_site::Flight & flight,
    const std::optional<FaultOnset> & onset);

  /// Looks at the loop after each tick.
  void watch(const ClosedLoop & loop);

  /// Everything seen. Call it once, at the end.
  [[nodiscard]] ClimbScore take();

private:
  void watch_integrity(const ClosedLoop & loop);
  void watch_confirmation(const ClosedLoop & loop);
  void watch_steps(const ClosedLoop & loop);
  void watch_closure(const ClosedLoop & loop);
  void watch_fault(const ClosedLoop & loop);
  void score(const ClosedLoop & loop);
  void watch_hand_over(
    const ClosedLoop & loop, const ScoredEstimate & sample, std::optional<int> step);
  void watch_exceedance(const ScoredEstimate & sample, stetro_driver::Time stamp);
  void end_closure();
  void end_tread();
  [[nodiscard]] const stetro_localizer::StairEstimate & estimate(const ClosedLoop & loop) const
  {
    return loop.estimator(estimator_).estimate();
  }

  std::size_t estimator_;
  const stetro_site::Flight & flight_;
  std::optional<FaultOnset> onset_;
  ClimbScore score_;
  stetro_supervisor::State state_ = stetro_supervisor::State::kIdle;
  bool first_tread_ = true;

  std::optional<ScoredEstimate> last_;  ///< of the estimate before, if it counted
  std::optional<int> last_estimated_step_;
  std::uint32_t last_in_use_ = 0;  ///< a bit for each side and front sensor

  int tread_ = -1;  ///< the tread of the next two
  bool alarmed_ = false;
  bool exceeded_ = false;
  bool confirming_ = false;
  stetro_driver::Time came_down_{0};

  int closing_step_ = 0;  ///< the tread of closure_m_
  std::optional<double> closure_m_;

  std::optional<stetro_driver::Time> exceeds_since_;
  stetro_driver::GroundTruth last_truth_{};
};

}  // namespace stetro_bringup

#endif  // ACCURACY__ESTIMATE_SCORER_HPP_
