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

#ifndef STETRO_LOCALIZER__FLOOR__FLOOR_MODEL_HPP_
#define STETRO_LOCALIZER__FLOOR__FLOOR_MODEL_HPP_

#include <array>
#include <variant>

#include "stetro_localizer/floor/correction_gate.hpp"
#include "stetro_localizer/outcome.hpp"
#include "stetro_localizer/params.hpp"
#include "stetro_localizer/samples.hpp"
#include "stetro_localizer/standstill.hpp"

namespace stetro_localizer
{

/// A correction as the filter takes it: a fix of its time, on one of the site's floors.
struct FloorFix
{
  Nanoseconds stamp{0};
  int floor = -1;
  PoseFix fix;
};

/// One sample of any kind. Those of one time are taken in the order of the kinds here.
using FloorSample = std::variant<GyroSample, OdometrySample, ContactSample, FloorFix>;

[[nodiscard]] inline Nanoseconds stamp_of(const FloorSample & sample)
{
  return std::visit([](const auto & s) { return s.stamp; }, sample);
}

/// Everything of the estimator on floors that a sample changes.
/** Copying it keeps the past. The heading and the position each are for a time of their own, for
 *  gyroscope and wheels tell of different intervals. */
struct FloorCore
{
  FloorCore(const GateLimits & limits, const StandstillParams & standing)
  : gate(limits), standstill(standing)
  {
  }

  FloorFilter filter;  ///< its pose is of `gate.floor()`, and means nothing while that is unknown
  CorrectionGate gate;
  Standstill standstill;
  Nanoseconds time{0};             ///< of the newest sample; zero before the first
  Nanoseconds turned_to{0};        ///< the heading is for this
  Nanoseconds moved_to{0};         ///< the position is for this
  Nanoseconds gyro_time{0};        ///< of the last gyroscope sample
  double rate_radps = 0.0;         ///< it
  Nanoseconds gyro_lived_at{0};    ///< its reading changed last, or the robot was not in motion
  OdometrySample wheels;           ///< the last one
  ContactSample contacts;          ///< the last one
  double turn_conflict_rad = 0.0;  ///< wheels less gyroscope, of the last seconds
  std::array<SourceReport, 4> reports;  ///< gyroscope; correction of x, y and heading
  CorrectionOutcome answer = CorrectionOutcome::kNone;  ///< to the last correction
  std::uint32_t resets = 0;                             ///< by corrections
  std::uint64_t landmarks = 0;  ///< changes of trust and stops: worth keeping
};

/// What a sample means on a floor: takes a `FloorCore` from before it to after it.
/**
 * Holds the parameters and no state. Wheels and gyroscope tell of the interval that ends at their
 * stamp; a correction is of its stamp. Immutable after construction.
 */
class FloorModel
{
public:
  using Core = FloorCore;
  using Sample = FloorSample;

  /// Nothing that comes on a floor comes in parts.
  static bool fill_in(Sample &, const Sample &) { return false; }

  explicit FloorModel(const LocalizerParams & params);

  /// A core that has seen nothing and does not know where it is.
  [[nodiscard]] FloorCore begin() const;

  /// Takes one sample, which must not be older than the core.
  void take(FloorCore & core, const FloorSample & sample) const;

  /// Lets the motion go on as it was until `time`; earlier times change nothing.
  void advance(FloorCore & core, Nanoseconds time) const;

  /// The gyroscope says the same again and again while the robot moves.
  [[nodiscard]] bool gyro_stuck(const FloorCore & core) const;

  /// Wheels and gyroscope contradict each other.
  [[nodiscard]] bool turns_conflict(const FloorCore & core) const;

private:
  void take_one(FloorCore & core, const GyroSample & sample) const;
  void take_one(FloorCore & core, const OdometrySample & sample) const;
  void take_one(FloorCore & core, const ContactSample & sample) const;
  void take_one(FloorCore & core, const FloorFix & sample) const;

  void turn(FloorCore & core, Nanoseconds until) const;
  void roll(FloorCore & core, Nanoseconds until) const;
  [[nodiscard]] double step_s(Nanoseconds & from, Nanoseconds until) const;

  LocalizerParams params_;
  GateLimits limits_;
  double standing_gate_;  // nis of one degree of freedom
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FLOOR__FLOOR_MODEL_HPP_
