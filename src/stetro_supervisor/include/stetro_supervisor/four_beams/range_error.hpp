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

#ifndef STETRO_SUPERVISOR__FOUR_BEAMS__RANGE_ERROR_HPP_
#define STETRO_SUPERVISOR__FOUR_BEAMS__RANGE_ERROR_HPP_

#include <optional>

namespace stetro_supervisor
{

/// By how much a range may differ from the length D of its beam's axis in the map.
/**
 *   D (1 - short_share) - short_m <= range <= D (1 + long_share) + long_m                    (1)
 *
 * Shares hold what grows with distance: a sensor's gain, and what its cone sees of an oblique wall
 * nearer than the axis does. The error of the map belongs to the bounds too.
 */
struct RangeError
{
  double short_m = 0.03;      ///< the range is at most this much less than D [m], >= 0
  double long_m = 0.03;       ///< at most this much more [m], >= 0
  double short_share = 0.03;  ///< [0, 1)
  double long_share = 0.03;   ///< >= 0
  double dependable_m = 1.2;  ///< what is nearer always returns: no return is D >= this [m]
  double too_near_m = 0.05;   ///< what is farther is never reported as too near [m]
};

/// Between which index differences the truth is, given what a sensor read [cells].
struct DistanceBounds
{
  int shortest = 0;
  int longest = 0;
};

/// What a range says in cells of size r.
/**
 * Ranges of (1) in `RangeError` and reaches of (1) in `Reach` agree exactly if shortest <= last and
 * first <= longest with
 *
 *   shortest = ceil(D_least / r),   longest = floor(D_most / r + 1)                            (2)
 *
 * \param range_m as REP 117: +inf nothing in range, -inf too near
 * \return nothing for NaN, which says nothing
 */
[[nodiscard]] std::optional<DistanceBounds> distance_bounds(
  double range_m, const RangeError & error, double resolution_m);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FOUR_BEAMS__RANGE_ERROR_HPP_
