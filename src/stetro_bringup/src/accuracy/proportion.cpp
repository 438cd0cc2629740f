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

#include "accuracy/proportion.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace stetro_bringup
{
namespace
{

/// The rate up to `high` at which a function that falls with the rate passes `level`.
template <class Falling>
double where_it_falls_to(double level, double high, const Falling & falling)
{
  double low = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (falling(middle) > level ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double log_factorial(std::uint64_t m) { return std::lgamma(static_cast<double>(m) + 1.0); }

double log_choose(std::uint64_t n, std::uint64_t k)
{
  return log_factorial(n) - log_factorial(k) - log_factorial(n - k);
}

}  // namespace

double share_of(std::uint64_t part, std::uint64_t whole)
{
  return whole == 0 ? std::nan("") : static_cast<double>(part) / static_cast<double>(whole);
}

double binomial_at_most(std::uint64_t k, std::uint64_t n, double rate)
{
  if (k >= n || rate <= 0.0) {
    return 1.0;
  }
  if (rate >= 1.0) {
    return 0.0;
  }
  // The terms from the largest one downwards: what is left out is below the last digit.
  double sum = 0.0;
  for (std::uint64_t i = k + 1; i-- > 0;) {
    const double happen = static_cast<double>(i) * std::log(rate);
    const double fail = static_cast<double>(n - i) * std::log1p(-rate);
    const double term = std::exp(log_choose(n, i) + happen + fail);
    sum += term;
    if (term < 1e-18 * sum) {
      break;
    }
  }
  return sum < 1.0 ? sum : 1.0;
}

double poisson_at_most(std::uint64_t k, double mean)
{
  if (mean <= 0.0) {
    return 1.0;
  }
  double sum = 0.0;
  for (std::uint64_t i = 0; i <= k; ++i) {
    sum += std::exp(static_cast<double>(i) * std::log(mean) - mean - log_factorial(i));
  }
  return sum < 1.0 ? sum : 1.0;
}

Interval garwood(std::uint64_t k, std::uint64_t n, double confidence)
{
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw std::invalid_argument(
      "confidence is " + std::to_string(confidence) + ", accepted: between 0 and 1");
  }
  const double tail = (1.0 - confidence) / 2.0;
  const auto count = static_cast<double>(k);
  const auto steps = static_cast<double>(n);
  // Beyond all means at which k or fewer are as likely as the smallest tail of use.
  const double most = count + 20.0 * std::sqrt(count + 1.0) - std::log(tail);
  Interval interval{0.0, std::numeric_limits<double>::infinity()};
  if (n == 0) {
    return interval;
  }
  if (k > 0) {
    interval.low = where_it_falls_to(
                     1.0 - tail, most, [&](double mean) { return poisson_at_most(k - 1, mean); }) /
                   steps;
  }
  interval.high =
    where_it_falls_to(tail, most, [&](double mean) { return poisson_at_most(k, mean); }) / steps;
  return interval;
}

Interval clopper_pearson(std::uint64_t k, std::uint64_t n, double confidence)
{
  if (k > n || !(confidence > 0.0 && confidence < 1.0)) {
    throw std::invalid_argument(
      std::to_string(k) + " of " + std::to_string(n) + " at a confidence of " +
      std::to_string(confidence) + ", accepted: k up to n, confidence between 0 and 1");
  }
  if (n == 0) {
    return {};
  }
  const double tail = (1.0 - confidence) / 2.0;
  Interval interval;
  if (k > 0) {
    interval.low = where_it_falls_to(
      1.0 - tail, 1.0, [&](double rate) { return binomial_at_most(k - 1, n, rate); });
  }
  if (k < n) {
    interval.high =
      where_it_falls_to(tail, 1.0, [&](double rate) { return binomial_at_most(k, n, rate); });
  }
  return interval;
}

double chi_square_3(double value)
{
  if (value <= 0.0) {
    return 0.0;
  }
  return std::erf(std::sqrt(value / 2.0)) - std::sqrt(2.0 * value / M_PI) * std::exp(-value / 2.0);
}

}  // namespace stetro_bringup
