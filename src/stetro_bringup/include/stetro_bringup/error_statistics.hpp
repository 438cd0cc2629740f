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
#ifndef STETRO_BRINGUP__ERROR_STATISTICS_HPP_
#define STETRO_BRINGUP__ERROR_STATISTICS_HPP_

#include <cstddef>

namespace stetro_bringup
{

/// Mean, spread and size of a stream of errors, in the unit of the errors.
/**
 * Sums are updated by Welford's recursion, so that a small spread around a large mean (the papers'
 * 31 mm mean with 1.3 mm deviation) keeps its digits.
 */
class ErrorStatistics
{
public:
  /// \throws std::invalid_argument if `error` is not finite: a missing value is no error of zero
  void add(double error);

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] double mean() const;  ///< NaN without samples
  [[nodiscard]] double standard_deviation()
    const;                               ///< of the population (divided by n); NaN without samples
  [[nodiscard]] double rms() const;      ///< root of the mean square; NaN without samples
  [[nodiscard]] double max_abs() const;  ///< NaN without samples

private:
  std::size_t count_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;  ///< sum of squared distances from the mean
  double max_abs_ = 0.0;
};

}  // namespace stetro_bringup

#endif  // STETRO_BRINGUP__ERROR_STATISTICS_HPP_
