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

#ifndef STETRO_LOCALIZER__FUSED__FUSED_CORE_HPP_
#define STETRO_LOCALIZER__FUSED__FUSED_CORE_HPP_

#include <array>
#include <optional>
#include <variant>

#include "stetro_localizer/contact_closure.hpp"
#include "stetro_localizer/fused/error_state_filter.hpp"
#include "stetro_localizer/fused/hand_over.hpp"
#include "stetro_localizer/fused/range_monitor.hpp"
#include "stetro_localizer/fused/slip_watch.hpp"
#include "stetro_localizer/fused/tread_gauge.hpp"
#include "stetro_localizer/outcome.hpp"
#include "stetro_localizer/samples.hpp"
#include "stetro_localizer/staircase_as_built.hpp"
#include "stetro_localizer/standstill.hpp"
#include "stetro_localizer/step_filter.hpp"

namespace stetro_localizer
{

/// One sample of any kind. Those of one time are taken in the order of the kinds here.
using Sample = std::variant<OdometrySample, GyroSample, ContactSample, BlockSample, RangeSample>;

[[nodiscard]] inline Nanoseconds stamp_of(const Sample & sample)
{
  return std::visit([](const auto & s) { return s.stamp; }, sample);
}

/// Everything of the fused estimator that a sample changes.
/** Copying it keeps the past: a late sample is taken by going back to the copy before its time. */
struct FusedCore
{
  FusedCore(
    const StepModel & step_model, const StandstillParams & standing, const SlipWatch & slip_watch,
    const SlipWatch & sum_watch, const SlipWatch & pair_watch, const HandOver & between_sensors)
  : steps(step_model),
    standstill(standing),
    slips{slip_watch, slip_watch},
    width_watch(sum_watch),
    turn_watch(pair_watch),
    hand_over(between_sensors)
  {
  }

  ErrorStateFilter filter;
  StepFilter steps;          // refers to the model's StepModel
  Nanoseconds time{0};       ///< the filter's state is for this; zero before the first sample
  Nanoseconds gyro_time{0};  ///< of the last gyroscope sample
  double rate_radps = 0.0;   ///< it
  std::optional<double> pitch_rad;  ///< with it, if its IMU knows
  Nanoseconds gyro_lived_at{0};     ///< its reading changed last, or the robot was not in motion
  bool rolling = false;             ///< the wheels turn
  Standstill standstill;
  bool blocks_moving = false;
  ContactSample contacts;                                 ///< the last one
  std::array<std::array<Nanoseconds, 4>, 2> closed_at{};  ///< bumpers and switch, left and right
  RangeSample last_ranges;     ///< the last reading of each place; it counts while it is young
  Nanoseconds wheels_time{0};  ///< of the last wheel speeds
  bool wheels_silent = false;  ///< for so long that their speeds count no more
  double travel_m = 0.0;       ///< way along x since the beginning [m]
  ContactClosure closure{0.0, 0.0};
  SourceReports reports;
  std::array<Nanoseconds, kRangerCount> used_at{};  ///< when each ranger last corrected
  std::array<SlipWatch, 2> slips;                   ///< by `StateIndex`: x, y
  Nanoseconds slipping_until{0};                    ///< a slip that was noticed may go on
  std::array<double, 2> slipped_m{};                ///< lately, by `StateIndex`: x, y [m]
  /// Of it, what one sensor alone has told of; until a contact. By `StateIndex`: x, y [m].
  std::array<double, 2> unconfirmed_m{};
  SlipWatch width_watch;  ///< left and right add up to more or less than the width
  SlipWatch turn_watch;   ///< the front pair turns otherwise than the gyroscope
  HandOver hand_over;     ///< what the published x and y lack of the filter's
  /// By `StateIndex`, x, y, heading: what tells it contradicts; until a contact.
  std::array<bool, 3> doubted{};
  Nanoseconds rolled_at{0};       ///< the wheels turned last
  std::optional<int> located_on;  ///< step that x and the treads of the state belong to
  double edge_x_m = 0.0;          ///< X of the riser ahead in the flight frame, as built so far [m]
  double rise_m = 0.0;            ///< height of the tread of block 2, as built so far [m]
  TreadGauge gauge_ahead;         ///< of the tread ahead
  FrontCalibration front_calibration;         ///< for it: from before that tread came into sight
  bool site_belied = false;                   ///< by a tread since the robot was located
  std::optional<ScalarEstimate> gauged_here;  ///< what the gauge said of the tread of block 2 [m]
  StepAsBuilt left_behind;                    ///< the step that block 2 left last; step 0: none yet
  Nanoseconds since{0};                       ///< time of the first sample
  std::array<RangeMonitor, kWatchedCount> monitors{};  ///< by `Ranger`
  std::uint64_t landmarks = 0;  ///< contacts and changes of the step: worth keeping
  std::uint32_t jumps = 0;      ///< of the state, other than by measurements
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__FUSED_CORE_HPP_
