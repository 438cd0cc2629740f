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

#ifndef STETRO_LOCALIZER__OUTCOME_HPP_
#define STETRO_LOCALIZER__OUTCOME_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace stetro_localizer
{

/// What became of a sample or of one source in it.
enum class Outcome {
  kNone,        ///< nothing has come yet
  kFused,       ///< used
  kGated,       ///< too far from what was expected
  kStale,       ///< too old to be applied at its time
  kNotVisible,  ///< the model says that the sensor cannot see its target, or it saw none
  kRefused      ///< unfit to be looked at; `Refusal` says why
};

/// Whether the sensor saw its target, believed or not.
[[nodiscard]] constexpr bool saw_target(Outcome outcome)
{
  return outcome == Outcome::kFused || outcome == Outcome::kGated;
}

/// Why a sample was refused.
enum class Refusal {
  kNone,
  kZeroStamp,   ///< time zero is no time
  kFuture,      ///< stamped later than now by more than the tolerance
  kOutOfOrder,  ///< not newer than the last accepted one of its kind
  kTooOld,      ///< stamped earlier than now by more than the limit
  kNotFinite,   ///< NaN or infinite where a number is needed
  kNegative     ///< below zero where that cannot be
};
constexpr std::size_t kRefusalCount = 7;

[[nodiscard]] const char * to_string(Outcome outcome);
[[nodiscard]] const char * to_string(Refusal refusal);

/// Answer to one sample.
struct Verdict
{
  Outcome outcome = Outcome::kNone;
  Refusal refusal = Refusal::kNone;

  static Verdict refused(Refusal why) { return {Outcome::kRefused, why}; }
  [[nodiscard]] bool is_refused() const { return outcome == Outcome::kRefused; }
};

/// What measures, as the estimator tells it apart.
enum class Source {
  kRanges,
  kContacts,
  kBlocks,
  kGyro,
  kOdometry,
  kSideLeft,
  kSideRight,
  kFrontPair,
  kFrontLeft,
  kFrontRight,
  kBlock3Front,
  kBumperLeft,
  kBumperRight,
  kRiserSwitches,
  kStandingGyro,  ///< the gyroscope of a robot that stands: its bias
  kWheelsAlong,
  kWheelsAcross,
  kCorrectionX,
  kCorrectionY,
  kCorrectionHeading
};
constexpr std::size_t kSourceCount = 20;

/// The source's name on the wire and in reports.
[[nodiscard]] const char * to_string(Source source);

/// The last word of one source, and its tally. NaN where nothing was compared yet.
struct SourceReport
{
  double innovation = std::numeric_limits<double>::quiet_NaN();  ///< measured less expected
  double innovation_variance = std::numeric_limits<double>::quiet_NaN();  ///< of the innovation
  double test_ratio = std::numeric_limits<double>::quiet_NaN();           ///< above 1 it is gated
  Outcome outcome = Outcome::kNone;
  std::uint32_t reject_streak = 0;  ///< gated in a row; fused and not visible end it
  std::uint64_t fused = 0;
  std::uint64_t gated = 0;
  std::uint64_t stale = 0;
  std::uint64_t not_visible = 0;
  std::array<std::uint64_t, kRefusalCount> refused{};

  /// Notes the outcome in the tally and the streak.
  void note(Verdict verdict);
  [[nodiscard]] std::uint64_t refused_total() const;
};

/// One report for each source.
class SourceReports
{
public:
  [[nodiscard]] const SourceReport & operator[](Source source) const
  {
    return reports_[static_cast<std::size_t>(source)];
  }
  [[nodiscard]] SourceReport & operator[](Source source)
  {
    return reports_[static_cast<std::size_t>(source)];
  }

private:
  std::array<SourceReport, kSourceCount> reports_;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__OUTCOME_HPP_
