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

#include "accuracy/json_figures.hpp"

#include <cmath>

#include "accuracy/proportion.hpp"

namespace stetro_bringup
{
namespace
{

// What lies below the upper bound of a two-sided interval of 90 % does so with 95 %.
constexpr double kOneSided95 = 0.90;

Json bounded(Json json, const Interval & bounds, double at_most)
{
  json["low_95"] = bounds.low;
  json["high_95"] = known(bounds.high);
  json["at_most_95"] = known(at_most);
  return json;
}

}  // namespace

Json known(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json rate(std::uint64_t count, std::uint64_t of)
{
  return bounded(
    {{"count", count}, {"of", of}, {"share", known(share_of(count, of))}},
    clopper_pearson(count, of), clopper_pearson(count, of, kOneSided95).high);
}

Json times_a_step(std::uint64_t times, std::uint64_t steps)
{
  return bounded(
    {{"times", times}, {"steps", steps}, {"per_step", known(share_of(times, steps))}},
    garwood(times, steps), garwood(times, steps, kOneSided95).high);
}

Json figures(const ErrorDistribution & errors, const std::string & unit)
{
  return {
    {"rmse_" + unit, known(errors.rmse())},
    {"mean_" + unit, known(errors.mean())},
    {"std_" + unit, known(errors.standard_deviation())},
    {"p95_" + unit, known(errors.percentile(0.95))},
    {"p999_" + unit, known(errors.percentile(0.999))},
    {"max_" + unit, known(errors.max())}};
}

}  // namespace stetro_bringup
