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

#include "stetro_localizer/measurement/front_pair.hpp"

#include <cmath>

namespace stetro_localizer
{

double heading_from_pair(double difference_m, double baseline_m)
{
  return std::atan2(difference_m, baseline_m);
}

double heading_variance(double difference_m, double baseline_m, double difference_variance_m2)
{
  const double slope =
    baseline_m / (baseline_m * baseline_m + difference_m * difference_m);  // [rad/m]
  return slope * slope * difference_variance_m2;
}

}  // namespace stetro_localizer
