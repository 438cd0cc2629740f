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

#include "stetro_localizer/params.hpp"

#include <string>

namespace stetro_localizer
{
namespace
{

void check_average(
  const std::string & name, const AverageParams & average, stetro_config::Faults & faults)
{
  if (average.least_count > average.window) {
    faults.refuse(
      name + ".least_count", std::to_string(average.least_count),
      "at most " + name + ".window, which is " + std::to_string(average.window));
  }
}

}  // namespace

void check(const LocalizerParams & params, stetro_config::Faults & faults)
{
  check_average("lateral.average", params.lateral.average, faults);
  check_average("heading.average", params.heading.average, faults);
  if (params.fused.window_s > params.max_sample_age_s) {
    faults.refuse(
      "fused.window_s", std::to_string(params.fused.window_s),
      "at most max_sample_age_s, which is " + std::to_string(params.max_sample_age_s) +
        ": older samples are refused before");
  }
  if (params.floor.retreat_yaw_rad <= params.floor.approach_yaw_rad) {
    faults.refuse(
      "floor.retreat_yaw_rad", std::to_string(params.floor.retreat_yaw_rad),
      "more than floor.approach_yaw_rad, which is " +
        std::to_string(params.floor.approach_yaw_rad));
  }
}

}  // namespace stetro_localizer
