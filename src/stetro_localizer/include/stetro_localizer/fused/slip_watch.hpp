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

#ifndef STETRO_LOCALIZER__FUSED__SLIP_WATCH_HPP_
#define STETRO_LOCALIZER__FUSED__SLIP_WATCH_HPP_

#include <algorithm>
#include <cmath>
#include <optional>

namespace stetro_localizer
{

/// How far the estimate is off by a slip that was found.
struct Slip
{
  double shift_m;      ///< along the axis [m]
  double variance_m2;  ///< of it [m^2]
};

/// Notices that the body has moved without its wheels, and how far.
/**
 * A slip by d along an axis shifts all later innovations, each by what the filter's corrections
 * have left of it: a d, a = 1 at first. The log-likelihood ratio of such a slip against none is,
 * for each direction, a cumulative sum over innovations e with variance v,
 *
 *   S = max(0, S + (a d e - (a d)^2 / 2) / v)      (Page 1954)
 *
 * and the slip began when it last was zero. It alarms when S passes -log(false_alarm): without a
 * slip at most once in 1 / false_alarm innovations on average (Lorden 1971). A near, exact range
 * counts for more than a far one. With sums since the beginning the slip is then
 *
 *   d = sum(a e / v) var(d),   1 / var(d) = sum(a^2 / v) + 1 / slip_m^2
 *
 * (Willsky and Jones 1976), and a d, with variance a^2 var(d), is still missing in the state.
 */
class SlipWatch
{
public:
  /// \param slip_m a usual slip, the d that shall be found soonest [m]; above 0
  /// \param false_alarm above 0, below 1
  SlipWatch(double slip_m, double false_alarm) : slip_m_(slip_m), limit_(-std::log(false_alarm)) {}

  /// \param innovation_m along the axis, in its direction [m]
  /// \param variance_m2 of the innovation
  /// \param kept share of a shift that is left after the filter's correction by this innovation
  /// \return the slip, once it is found; the watch begins anew
  std::optional<Slip> add(double innovation_m, double variance_m2, double kept)
  {
    const double most_m = std::max(2.0 * slip_m_, kMostOfOne * std::sqrt(variance_m2));
    const double e_m = std::clamp(innovation_m, -most_m, most_m);
    for (Sum * sum : {&forwards_, &backwards_}) {
      const double d_m = (sum == &forwards_ ? slip_m_ : -slip_m_) * sum->left;
      // One wild reading alone is no slip.
      sum->likelihood += std::min((d_m * e_m - d_m * d_m / 2.0) / variance_m2, limit_ / kLeast);
      sum->weight += sum->left * sum->left / variance_m2;
      sum->weighted_m += sum->left * e_m / variance_m2;
      sum->left *= kept;
      // A slip that the filter has followed is past: what comes now may be another.
      if (sum->likelihood <= 0.0 || sum->left < kPast) {
        *sum = {};
      }
    }
    const auto slip = beyond(limit_);
    if (slip) {
      clear();
    }
    return slip;
  }

  /// The slip that is likelier than none, though by less than an alarm takes.
  [[nodiscard]] std::optional<Slip> suspected() const { return beyond(kSuspicion * limit_); }

  /// How far the estimate may be off by a slip that is suspected; zero without suspicion [m].
  /** Most suspicions are unfounded: no more than two standard deviations are added to one. */
  [[nodiscard]] double suspected_m() const
  {
    const auto slip = beyond(kLikelier);
    return slip ? std::abs(slip->shift_m) + 2.0 * std::sqrt(slip->variance_m2) : 0.0;
  }

  void clear() { forwards_ = backwards_ = {}; }

private:
  static constexpr double kMostOfOne = 3.5;  // standard deviations
  static constexpr double kLeast = 2.5;      // innovations that an alarm takes
  static constexpr double kPast = 0.2;       // share of a slip that is left
  static constexpr double kSuspicion = 0.4;  // share of the limit
  static constexpr double kLikelier = 2.0;   // a slip is seven times likelier than none

  struct Sum
  {
    double likelihood = 0.0;
    double weight = 0.0;      // [1/m^2]
    double weighted_m = 0.0;  // [1/m]
    double left = 1.0;        // a
  };

  [[nodiscard]] std::optional<Slip> beyond(double limit) const
  {
    const Sum & likelier = forwards_.likelihood > backwards_.likelihood ? forwards_ : backwards_;
    if (likelier.likelihood <= limit) {
      return std::nullopt;
    }
    const double variance = 1.0 / (likelier.weight + 1.0 / (slip_m_ * slip_m_));
    return Slip{
      likelier.left * likelier.weighted_m * variance, likelier.left * likelier.left * variance};
  }

  double slip_m_;
  double limit_;
  Sum forwards_;
  Sum backwards_;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__SLIP_WATCH_HPP_
