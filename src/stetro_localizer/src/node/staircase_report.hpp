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

#ifndef NODE__STAIRCASE_REPORT_HPP_
#define NODE__STAIRCASE_REPORT_HPP_

#include <vector>

#include "stetro_dds/diagnostics.hpp"
#include "stetro_localizer/staircase_as_built.hpp"

namespace stetro_localizer
{

/// Tells the staircase as built: a warning that names what exceeds the bound, and a row a step.
/**
 *   steps measured                               16
 *   largest deviation [m]                        0.004183
 *   largest deviation of                         tread of step 7
 *   step 7: tread, sigma, width, sigma [m]       0.324183 0.001125 2.051310 0.001806
 *   step 7: tread, sigma, site file [m]          0.361204 0.001125 0.320000
 *
 * What could not be measured is nan. The last row is there for each deviation beyond the bound. The
 * demo reads them.
 */
void tell(
  stetro_dds::DiagnosticReport & report, const std::vector<StepAsBuilt> & steps,
  const stetro_site::Flight & flight, double bound_m);

}  // namespace stetro_localizer

#endif  // NODE__STAIRCASE_REPORT_HPP_
