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

#include "stetro_localizer/staircase_as_built.hpp"

#include <cmath>

namespace stetro_localizer
{

const char * to_string(StepMeasure measure)
{
  return measure == StepMeasure::kTread ? "tread" : "width";
}

bool Deviation::exceeds(double bound_m) const
{
  constexpr double kSure = 3.0;  // standard deviations
  return std::abs(by_m()) > bound_m && std::abs(by_m()) > kSure * std::sqrt(found_m.variance);
}

std::vector<Deviation> deviations(
  const std::vector<StepAsBuilt> & steps, const stetro_site::Flight & flight)
{
  std::vector<Deviation> all;
  for (const StepAsBuilt & one : steps) {
    if (one.tread_m) {
      all.push_back({one.step, StepMeasure::kTread, *one.tread_m, flight.tread_m(one.step)});
    }
    if (one.width_m) {
      const double site_m = flight.width_m(flight.tread_centre_m(one.step));
      all.push_back({one.step, StepMeasure::kWidth, *one.width_m, site_m});
    }
  }
  return all;
}

}  // namespace stetro_localizer
