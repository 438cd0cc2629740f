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

#include "stetro_supervisor/four_beams/range_error.hpp"

#include <algorithm>
#include <cmath>

#include "stetro_supervisor/four_beams/cell_reach.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kRounding = 1e-9;  // bounds are widened by what the arithmetic costs [cells]

/// Between which lengths a beam's axis must be, given what it read [m].
struct Lengths
{
  double least_m = 0.0;
  double most_m = 0.0;
};

std::optional<Lengths> true_lengths(double range_m, const RangeError & error)
{
  if (std::isnan(range_m)) {
    return std::nullopt;
  }
  if (std::isinf(range_m)) {
    return range_m > 0.0 ? Lengths{error.dependable_m, range_m} : Lengths{0.0, error.too_near_m};
  }
  return Lengths{
    (range_m - error.long_m) / (1.0 + error.long_share),
    (range_m + error.short_m) / (1.0 - error.short_share)};
}

}  // namespace

std::optional<DistanceBounds> distance_bounds(
  double range_m, const RangeError & error, double resolution_m)
{
  const auto lengths = true_lengths(range_m, error);
  if (!lengths) {
    return std::nullopt;
  }
  const auto cells = [](double distance) {
    return static_cast<int>(std::clamp<double>(distance, 0.0, kNoReturn));
  };
  return DistanceBounds{
    cells(std::ceil(lengths->least_m / resolution_m - kRounding)),
    cells(std::floor(lengths->most_m / resolution_m + 1.0 + kRounding))};
}

}  // namespace stetro_supervisor
