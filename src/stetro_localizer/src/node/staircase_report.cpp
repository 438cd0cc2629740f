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

#include "node/staircase_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <string>

namespace stetro_localizer
{
namespace
{

std::string metres(std::initializer_list<double> values)
{
  std::string text;
  for (const double value : values) {
    text += (text.empty() ? "" : " ") + std::to_string(value);
  }
  return text;
}

std::string name_of(const Deviation & deviation)
{
  return std::string(to_string(deviation.measure)) + " of step " + std::to_string(deviation.step);
}

std::string in_words(const Deviation & deviation)
{
  std::array<char, 120> text{};
  std::snprintf(
    text.data(), text.size(), "%s is %.4f m (sigma %.4f m), the site file says %.4f m",
    name_of(deviation).c_str(), deviation.found_m.value, std::sqrt(deviation.found_m.variance),
    deviation.site_m);
  return text.data();
}

void tell_largest(stetro_dds::DiagnosticReport & report, const std::vector<Deviation> & all)
{
  const auto largest =
    std::max_element(all.begin(), all.end(), [](const Deviation & a, const Deviation & b) {
      return std::abs(a.by_m()) < std::abs(b.by_m());
    });
  if (largest != all.end()) {
    report.value("largest deviation [m]", largest->by_m());
    report.value("largest deviation of", name_of(*largest));
  }
}

void tell_step(stetro_dds::DiagnosticReport & report, const StepAsBuilt & one)
{
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const ScalarEstimate unknown{kNan, kNan};
  const ScalarEstimate tread = one.tread_m.value_or(unknown);
  const ScalarEstimate width = one.width_m.value_or(unknown);
  report.value(
    "step " + std::to_string(one.step) + ": tread, sigma, width, sigma [m]",
    metres({tread.value, std::sqrt(tread.variance), width.value, std::sqrt(width.variance)}));
}

}  // namespace

void tell(
  stetro_dds::DiagnosticReport & report, const std::vector<StepAsBuilt> & steps,
  const stetro_site::Flight & flight, double bound_m)
{
  const std::vector<Deviation> all = deviations(steps, flight);
  const auto measured = std::count_if(
    steps.begin(), steps.end(), [](const StepAsBuilt & one) { return one.tread_m || one.width_m; });
  report.value("steps measured", static_cast<std::int64_t>(measured));
  tell_largest(report, all);
  for (const StepAsBuilt & one : steps) {
    tell_step(report, one);
  }
  std::string warning;
  for (const Deviation & deviation : all) {
    if (deviation.exceeds(bound_m)) {
      const double sigma_m = std::sqrt(deviation.found_m.variance);
      const char * measure = to_string(deviation.measure);
      report.value(
        "step " + std::to_string(deviation.step) + ": " + measure + ", sigma, site file [m]",
        metres({deviation.found_m.value, sigma_m, deviation.site_m}));
      warning += (warning.empty() ? "" : "; ") + in_words(deviation);
    }
  }
  if (!warning.empty()) {
    report.summarise(stetro_dds::Health::kWarn, warning);
  }
}

}  // namespace stetro_localizer
