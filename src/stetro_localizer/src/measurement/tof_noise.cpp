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

#include "stetro_localizer/measurement/tof_noise.hpp"

namespace stetro_localizer
{

double white_variance_m2(const TofNoise & noise, double range_m)
{
  const double growth_m = noise.white_per_m * range_m;
  return noise.white_m * noise.white_m + growth_m * growth_m;
}

double mean_variance_m2(
  const TofNoise & noise, double range_m, std::size_t count, double offset_variance_m2,
  double calibrated_at_m)
{
  const double gain_m = noise.systematic.gain_sigma * (range_m - calibrated_at_m);
  return white_variance_m2(noise, range_m) / static_cast<double>(count) +
         noise.systematic.slow_m * noise.systematic.slow_m + gain_m * gain_m + offset_variance_m2;
}

}  // namespace stetro_localizer
