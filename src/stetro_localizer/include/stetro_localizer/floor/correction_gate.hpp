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

#ifndef STETRO_LOCALIZER__FLOOR__CORRECTION_GATE_HPP_
#define STETRO_LOCALIZER__FLOOR__CORRECTION_GATE_HPP_

#include <cstdint>

#include "stetro_localizer/floor/floor_filter.hpp"

namespace stetro_localizer
{

/// What became of a correction.
enum class CorrectionOutcome {
  kNone,          ///< none has come yet
  kFused,         ///< used
  kReset,         ///< the second of two that agree: the pose begins anew at them
  kAwaited,       ///< kept, until another agrees with it
  kGated,         ///< too far from what was expected
  kGatedLost,     ///< likewise, the last of a streak: the pose is not believed any more
  kNotOnFloor,    ///< the robot is on a flight
  kOtherFloor,    ///< of another floor than the one the robot is on
  kStaleCounter,  ///< it corrects a pose from before the last reset
  kTooOld,        ///< of a time that is no longer kept
  kOutOfOrder,    ///< not newer than the one before
  kFuture,        ///< of a time to come
  kUnfit          ///< a number that is none, or no covariance
};
constexpr std::size_t kCorrectionOutcomes = 13;

[[nodiscard]] const char * to_string(CorrectionOutcome outcome);

/// Whether the estimator has made use of it.
[[nodiscard]] constexpr bool was_taken(CorrectionOutcome outcome)
{
  return outcome == CorrectionOutcome::kFused || outcome == CorrectionOutcome::kReset ||
         outcome == CorrectionOutcome::kAwaited;
}

/// Limits of the gate.
struct GateLimits
{
  double nis;                ///< of three degrees of freedom; a correction beyond it is refused
  std::int64_t lost_streak;  ///< refused in a row that agree with each other
  double reset_sigma_m;      ///< a reset must know the position so well [m]
  double reset_sigma_rad;    ///< and the heading [rad]
};

/// Lets corrections pass, doubts the pose when it should, and finds it again.
/**
 *   known   --(passes the gate)-------------------------------> known     fused
 *   known   --(refused; fewer than lost_streak that agree)----> known     refused
 *   known   --(refused, lost_streak-th that agrees)-----------> lost      refused
 *   unknown, lost --(first one, or disagrees with the kept)---> the same  kept
 *   unknown, lost --(agrees with the kept one)----------------> known     reset to both
 *
 * A correction that is not used becomes the rival: a filter of its own that moves on by the same
 * wheels and gyroscope. The next one agrees with it if it passes the same gate there, so that the
 * motion between the two is taken out and its doubt counted; then both are in the rival. What began
 * the doubt does not end it: when the pose is lost, the rival goes, and two others must agree. A
 * correction of another floor than the pose's is refused likewise: a robot can be carried upstairs.
 *
 * Trivially copyable.
 */
class CorrectionGate
{
public:
  enum class Trust : std::uint8_t { kNever, kKnown, kLost };

  explicit CorrectionGate(const GateLimits & limits) : limits_(limits) {}

  /// Judges a correction at its time, and uses it if it may be used.
  /** \param floor that it is of; the filter's pose is of `this->floor()` */
  CorrectionOutcome judge(FloorFilter & filter, const PoseFix & fix, int floor);

  /// The pose is known from elsewhere: doubts end.
  void trust(int floor);

  /// The pose is unknown; corrections of any floor may reset it.
  void distrust(Trust trust, int floor);

  /// The motion of the rival, as the filter's own.
  template <class Motion>
  void follow(Motion && motion)
  {
    if (has_rival_) {
      motion(rival_);
    }
  }

  [[nodiscard]] Trust trust() const { return trust_; }
  [[nodiscard]] int floor() const { return floor_; }
  /// Refused in a row, agreeing or not.
  [[nodiscard]] std::int64_t refused() const { return refused_; }
  [[nodiscard]] bool has_rival() const { return has_rival_; }
  [[nodiscard]] const GateLimits & limits() const { return limits_; }

private:
  [[nodiscard]] bool agrees(const PoseFix & fix, int floor) const;
  [[nodiscard]] bool rival_is_sure() const;
  void keep(const FloorFilter & filter, const PoseFix & fix, int floor);
  CorrectionOutcome find(FloorFilter & filter, const PoseFix & fix, int floor);

  GateLimits limits_;
  Trust trust_ = Trust::kNever;
  int floor_ = -1;
  std::int64_t refused_ = 0;
  std::int64_t agreeing_ = 0;  // in the rival
  bool has_rival_ = false;
  int rival_floor_ = -1;
  FloorFilter rival_;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FLOOR__CORRECTION_GATE_HPP_
