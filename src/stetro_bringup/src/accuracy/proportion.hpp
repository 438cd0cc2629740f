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

#ifndef ACCURACY__PROPORTION_HPP_
#define ACCURACY__PROPORTION_HPP_

#include <cstdint>

namespace stetro_bringup
{

/// Part / whole. \return NaN of nothing
[[nodiscard]] double share_of(std::uint64_t part, std::uint64_t whole);

/// Bounds of a proportion.
struct Interval
{
  double low = 0.0;
  double high = 1.0;
};

/// What k out of n says about a rate: the exact interval of Clopper and Pearson (1934), two-sided.
/**
 * `low` is the rate at which k or more happen with probability (1 - confidence) / 2, `high` the one
 * at which k or fewer do. With k = 0, high = 1 - ((1 - confidence) / 2)^(1 / n). The trials must be
 * independent, as climbs of different seeds are and steps of one climb nearly are.
 * \throws std::invalid_argument unless k <= n and 0 < confidence < 1
 */
[[nodiscard]] Interval clopper_pearson(std::uint64_t k, std::uint64_t n, double confidence = 0.95);

/// What k events in n steps say about their number a step: the exact interval of Garwood (1936).
/**
 * For what may happen more than once a step. With k = 0, high = -ln((1 - confidence) / 2) / n.
 * Without a step nothing is known: high is infinite.
 * \throws std::invalid_argument unless 0 < confidence < 1
 */
[[nodiscard]] Interval garwood(std::uint64_t k, std::uint64_t n, double confidence = 0.95);

/// Probability that an event expected `mean` times happens k times or fewer.
[[nodiscard]] double poisson_at_most(std::uint64_t k, double mean);

/// Probability that n trials at `rate` bring k or fewer.
[[nodiscard]] double binomial_at_most(std::uint64_t k, std::uint64_t n, double rate);

/// Probability that a chi-square variable of three degrees of freedom stays at or below `value`.
/** F(v) = erf(sqrt(v / 2)) - sqrt(2 v / pi) exp(-v / 2) */
[[nodiscard]] double chi_square_3(double value);

/// Between these lie 95 % of the NEES of three consistent errors, 2.5 % on either side.
constexpr Interval kNees95{0.215795, 9.348404};

}  // namespace stetro_bringup

#endif  // ACCURACY__PROPORTION_HPP_
