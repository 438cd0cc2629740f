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

#ifndef ACCURACY__ERROR_DISTRIBUTION_HPP_
#define ACCURACY__ERROR_DISTRIBUTION_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "stetro_bringup/error_statistics.hpp"

namespace stetro_bringup
{

/// Mean, spread and percentiles of a stream of errors of any length, in the unit of the errors.
/**
 * Percentiles are of the size |e|, by nearest rank: the smallest size that at least the share p of
 * the errors do not exceed. Sizes are counted in classes 0.1 % wide, so that a million errors take
 * no more memory than one; a percentile is its class's upper end, at most 0.1 % too large, and never
 * above the largest size there was. What is below a nanometre (a nanoradian) counts as one.
 */
class ErrorDistribution
{
public:
  ErrorDistribution();

  /// \throws std::invalid_argument if `error` is not finite: a missing value is no error of zero
  void add(double error);

  [[nodiscard]] std::size_t count() const { return statistics_.count(); }
  [[nodiscard]] double mean() const { return statistics_.mean(); }
  [[nodiscard]] double standard_deviation() const { return statistics_.standard_deviation(); }
  [[nodiscard]] double rmse() const { return statistics_.rms(); }
  [[nodiscard]] double max() const { return statistics_.max_abs(); }

  /// \param share in (0, 1] \return NaN without errors
  [[nodiscard]] double percentile(double share) const;

private:
  ErrorStatistics statistics_;
  std::vector<std::uint32_t> classes_;
};

}  // namespace stetro_bringup

#endif  // ACCURACY__ERROR_DISTRIBUTION_HPP_
