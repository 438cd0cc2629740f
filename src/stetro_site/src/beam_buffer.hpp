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

#ifndef BEAM_BUFFER_HPP_
#define BEAM_BUFFER_HPP_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "bearing.hpp"
#include "stetro_site/profile_caster.hpp"
#include "wall_tree.hpp"

namespace stetro_site
{

/// The beams between two bearings: `first` to `last`, then past beam 0 on from there to `wrapped`.
/** Without a beam `last` is less than `first`, and without any past beam 0 `wrapped` is -1. */
struct BeamSpan
{
  int first;
  int last;
  int wrapped;
};

/// Numbers the bearings of a fan of no more than a turn, in beams from the first.
/** A clockwise fan is looked at in a mirror, y for -y, where it runs counter-clockwise. */
class BeamScale
{
public:
  explicit BeamScale(const BeamFan & fan)
  : mirror_(fan.step_rad < 0.0 ? -1.0 : 1.0),
    first_rad_(mirror_ * std::remainder(fan.first_rad, kTwoPi)),
    per_rad_(1.0 / std::fabs(fan.step_rad)),
    turn_(kTwoPi / std::fabs(fan.step_rad)),
    count_(static_cast<double>(fan.count))
  {
  }

  /// -1 for a clockwise fan: the factor of y.
  [[nodiscard]] double mirror() const { return mirror_; }

  /// The slack at each end of a span, of an angle and no more than a beam [beams].
  [[nodiscard]] double slack(double angle_rad) const { return std::min(angle_rad * per_rad_, 1.0); }

  /// The beams from one bearing counter-clockwise to another less than half a turn on.
  STETRO_ALWAYS_INLINE BeamSpan span(double start_rad, double end_rad, double slack) const
  {
    double start = start_rad - first_rad_;
    double end = end_rad - first_rad_;
    start = start < 0.0 ? start + kTwoPi : start;
    end = end < 0.0 ? end + kTwoPi : end;
    // An end before its start lies past beam 0, or it is the same but for the last digit.
    const double back = start - end;
    end = back <= 0.0 ? end : (back > 1.0 ? end + kTwoPi : start);
    const double from = start * per_rad_ + (1.0 - slack);  // truncation makes it the beam above
    const double to = end * per_rad_ + slack;
    const double past = to - turn_ + 1.0;
    BeamSpan span;
    span.first = static_cast<int>(from < count_ ? from : count_);
    span.last = static_cast<int>(to < count_ - 1.0 ? to : count_ - 1.0);
    span.wrapped = static_cast<int>(past < 0.0 ? 0.0 : (past < count_ ? past : count_)) - 1;
    return span;
  }

private:
  double mirror_;
  double first_rad_;
  double per_rad_;
  double turn_;
  double count_;
};

/// Depth buffer over the beams of a fan: of each its direction and q, the inverse of its range.
/**
 * Kept between casts, so that none allocates that is no longer than one before. The directions
 * are products of two unit vectors, of the beam's row of kRow and of its place in the row, which
 * is as good as a sine and a cosine of each and takes a tenth of the time.
 */
class BeamBuffer
{
public:
  /// Points the beams of a fan, as a mirror shows them, and sets all q to that of the reach.
  STETRO_ALWAYS_INLINE void reset(const BeamFan & fan, double mirror, double farthest_q);

  /// Beams first to last meet a wall of eq. (1) of `cast_walls`.
  STETRO_ALWAYS_INLINE void meet(int first, int last, double a, double b);

  /// Whether a beam of first to last has met nothing as near as q.
  [[nodiscard]] STETRO_ALWAYS_INLINE bool open(int first, int last, double q) const;

  [[nodiscard]] double * q() { return q_.data(); }
  [[nodiscard]] const double * x() const { return x_.data(); }
  [[nodiscard]] const double * y() const { return y_.data(); }

private:
  static constexpr std::size_t kRow = 32;

  /// 1 for the lanes of the last eight beams that count, 0 beyond.
  static const double * mask(int beams)
  {
    alignas(64) static constexpr double kMask[2 * kLanes] = {1, 1, 1, 1, 1, 1, 1, 1};
    return kMask + kLanes - beams;
  }

  std::vector<double> q_;  ///< all three end with eight lanes that no beam uses
  std::vector<double> x_;
  std::vector<double> y_;
};

void BeamBuffer::reset(const BeamFan & fan, double mirror, double farthest_q)
{
  const std::size_t rows = (fan.count + kRow - 1) / kRow;
  q_.assign(fan.count + kLanes, farthest_q);
  x_.resize(rows * kRow + kLanes);
  y_.resize(rows * kRow + kLanes);
  double row_x[kRow];
  double row_y[kRow];
  for (std::size_t i = 0; i < kRow; ++i) {
    const double angle = static_cast<double>(i) * fan.step_rad;
    row_x[i] = std::cos(angle);
    row_y[i] = std::sin(angle);
  }
  for (std::size_t row = 0; row < rows; ++row) {
    const double angle = fan.first_rad + static_cast<double>(row * kRow) * fan.step_rad;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    double * x = x_.data() + row * kRow;
    double * y = y_.data() + row * kRow;
#pragma GCC ivdep
    for (std::size_t i = 0; i < kRow; ++i) {
      x[i] = c * row_x[i] - s * row_y[i];
      y[i] = mirror * (s * row_x[i] + c * row_y[i]);
    }
  }
}

void BeamBuffer::meet(int first, int last, double a, double b)
{
  double * __restrict q = q_.data() + first;
  const double * x = x_.data() + first;
  const double * y = y_.data() + first;
  int left = last - first + 1;
  for (; left >= kLanes; left -= kLanes, q += kLanes, x += kLanes, y += kLanes) {
#pragma GCC ivdep
#pragma GCC unroll 1
    for (int lane = 0; lane < kLanes; ++lane) {
      const double met = a * x[lane] + b * y[lane];
      q[lane] = met > q[lane] ? met : q[lane];
    }
  }
  if (left > 0) {
    const double * counts = mask(left);
#pragma GCC ivdep
#pragma GCC unroll 1
    for (int lane = 0; lane < kLanes; ++lane) {
      const double met = (a * x[lane] + b * y[lane]) * counts[lane];
      q[lane] = met > q[lane] ? met : q[lane];
    }
  }
}

bool BeamBuffer::open(int first, int last, double nearest_q) const
{
  const double * q = q_.data() + first;
  int left = last - first + 1;
  for (; left >= kLanes; left -= kLanes, q += kLanes) {
    int farther = 0;
#pragma GCC unroll 1
    for (int lane = 0; lane < kLanes; ++lane) {
      farther += q[lane] < nearest_q ? 1 : 0;
    }
    if (farther != 0) {
      return true;
    }
  }
  int farther = 0;
  if (left > 0) {
    const double * counts = mask(left);
#pragma GCC unroll 1
    for (int lane = 0; lane < kLanes; ++lane) {
      farther += q[lane] < nearest_q * counts[lane] ? 1 : 0;
    }
  }
  return farther != 0;
}

}  // namespace stetro_site

#endif  // BEAM_BUFFER_HPP_
