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

#ifndef STETRO_LOCALIZER__STEP_EVIDENCE_HPP_
#define STETRO_LOCALIZER__STEP_EVIDENCE_HPP_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "stetro_localizer/samples.hpp"

namespace stetro_localizer
{

/// What is known beside the blocks when a sample of them arrives. Nothing means no evidence.
/**
 * Stale, weak and faulty readings are nothing. The filter counts no reading twice within a lift
 * cycle, so the latest one may be handed in with every sample.
 */
struct StepEvidence
{
  std::optional<double> block1_down_m;   ///< reading of `block1_down` [m]
  std::optional<double> block2_down_m;   ///< reading of `block2_down` [m]
  std::optional<double> block3_front_m;  ///< reading of `block3_front` [m]
  /// From `base_link` along x to the riser that the front pair sees [m]; +inf if both look into
  /// the free although they are healthy.
  std::optional<double> front_m;
  /// Way along x since any fixed moment, by the wheels [m]; nothing while they are silent.
  std::optional<double> travel_m;
  std::optional<double> pitch_rad;  ///< of the body about +y, nose down positive [rad]
  Switch riser_left;
  Switch riser_right;
};

/// Where a reading may be if a hypothesis holds, before the sensor's own error.
struct Interval
{
  double lowest;
  double highest;

  [[nodiscard]] double beyond(double value) const
  {
    return std::max({0.0, lowest - value, value - highest});
  }
};

/// A sensor's error: normal, but now and then its reading is anything within its span.
struct ReadingModel
{
  double sigma;    ///< one standard deviation, in the unit of the reading
  double outlier;  ///< share of readings that mean nothing
  double span;     ///< of the values such a reading can have

  /// Density of a reading whose truth is anywhere in `where`, docs/derivations/step_filter.md (2)
  [[nodiscard]] double density(double value, const Interval & where) const
  {
    constexpr double kRootTwoPi = 2.5066282746310002;
    const double off = where.beyond(value) / sigma;
    const double mass = where.highest - where.lowest + sigma * kRootTwoPi;
    return (1.0 - outlier) * std::exp(-0.5 * off * off) / mass + outlier / span;
  }
  /// The same when nothing is known about the truth.
  [[nodiscard]] double density_of_anything() const { return 1.0 / span; }
};

/// The last readings of one sensor and their median, which a single spike does not move.
class ReadingWindow
{
public:
  void clear() { count_ = 0; }
  void add(double value)
  {
    for (std::size_t i = kLength - 1; i > 0; --i) {
      values_[i] = values_[i - 1];
    }
    values_[0] = static_cast<float>(value);
    count_ = static_cast<std::uint8_t>(std::min<std::size_t>(count_ + std::size_t{1}, kLength));
  }
  [[nodiscard]] std::optional<double> median() const
  {
    if (count_ == 0) {
      return std::nullopt;
    }
    std::array<float, kLength> sorted{};
    for (std::size_t i = 0; i < count_; ++i) {
      std::size_t at = i;
      for (; at > 0 && sorted[at - 1] > values_[i]; --at) {
        sorted[at] = sorted[at - 1];
      }
      sorted[at] = values_[i];
    }
    return static_cast<double>(sorted[(count_ - std::size_t{1}) / 2]);
  }

private:
  static constexpr std::size_t kLength = 5;
  std::array<float, kLength> values_{};
  std::uint8_t count_ = 0;
};

/// What one lift cycle of block 2 has shown: one vote of each sensor, however often it was read.
/**
 * A fault lasts: a load cell that is silent at a touch-down is silent in every sample of it. Votes
 * that were multiplied sample by sample would make any fault a certainty. Heights are relative to
 * where block 2 stood when it was lifted off, ways to where base_link then was.
 */
struct LiftVotes
{
  bool open = false;               ///< block 2 has left its place; without that there is no vote
  bool lift_seen = false;          ///< it was unloaded, driven or slow: it did not fall
  bool others_lifted = false;      ///< block 1 or 3 was lifted since: block 2 must stand
  bool moving = false;             ///< its lift says that it moves
  std::optional<bool> bearing;     ///< its load says that it stands
  double level_m = 0.0;            ///< settled height [m]
  std::optional<double> ground_m;  ///< height of the ground seen below while aloft [m]
  std::optional<double> down_m;    ///< block2_down at that settled height [m]
  std::optional<double> travel_m;  ///< way along x by the wheels until then [m]
  std::optional<double> front_m;   ///< StepEvidence::front_m then [m]
  std::optional<double> block3_front_m;  ///< block3_front, last seen below block 2 [m]
  std::optional<double> switch_way_m;    ///< from touch-down to the first switch that closed [m]
  int block1_above = 0;                  ///< treads from block 2 up to block 1 at lift-off
  int block2_above = 0;                  ///< treads from block 3 up to block 2 at lift-off
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__STEP_EVIDENCE_HPP_
