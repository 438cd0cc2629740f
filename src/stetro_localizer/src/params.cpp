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
}

}  // namespace stetro_localizer
