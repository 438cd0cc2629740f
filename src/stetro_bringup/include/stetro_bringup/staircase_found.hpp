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
#ifndef STETRO_BRINGUP__STAIRCASE_FOUND_HPP_
#define STETRO_BRINGUP__STAIRCASE_FOUND_HPP_

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace stetro_bringup
{

/// One step as the localizer found it; NaN where it could not.
struct StepFound
{
  int step = 0;
  double tread_m = 0.0;  ///< depth of its tread [m]
  double tread_sigma_m = 0.0;
  double width_m = 0.0;  ///< between the walls [m]
  double width_sigma_m = 0.0;
};

/// A measure that the localizer reported to be other than the site file's.
struct StepDeviation
{
  int step = 0;
  std::string measure;  ///< tread or width
  double found_m = 0.0;
  double sigma_m = 0.0;
  double site_m = 0.0;
};

/// The staircase as the localizer found it, by the values of its diagnostics.
struct StaircaseFound
{
  std::vector<StepFound> steps;
  std::vector<StepDeviation> deviations;
  double largest_deviation_m =
    std::numeric_limits<double>::quiet_NaN();  ///< beyond the bound or not
  std::string largest_deviation_of;            ///< "tread of step 7"

  [[nodiscard]] std::size_t treads_measured() const;
};

/// Takes one value of the status "staircase as built". One that does not read as such says nothing.
void note(StaircaseFound & staircase, const std::string & key, const std::string & value);

}  // namespace stetro_bringup

#endif  // STETRO_BRINGUP__STAIRCASE_FOUND_HPP_
