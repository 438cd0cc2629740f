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

#include "accuracy/error_rows.hpp"

#include <cmath>

namespace stetro_bringup
{
namespace
{

constexpr double kMillimetres = 1000.0;
constexpr double kDegrees = 180.0 / M_PI;

}  // namespace

std::vector<ErrorRow> error_rows(const EstimatorTotals & totals)
{
  const ErrorGroup & errors = totals.errors;
  return {
    {"x, riser ahead", errors.x_m, kMillimetres, "mm"},
    {"x, riser behind", errors.x_behind_m, kMillimetres, "mm"},
    {"y, right wall", errors.y_m, kMillimetres, "mm"},
    {"z, tread", errors.z_m, kMillimetres, "mm"},
    {"heading", errors.heading_rad, kDegrees, "deg"},
    {"heading to riser", errors.heading_to_riser_rad, kDegrees, "deg"},
    {"flight frame x", totals.flight_x_m, kMillimetres, "mm"},
    {"flight frame z", totals.flight_z_m, kMillimetres, "mm"},
    {"hand-over jump", totals.hand_over_m, kMillimetres, "mm"},
    {"contact closure", totals.closure_m, kMillimetres, "mm"},
    {"first tread y", totals.first_tread.y_m, kMillimetres, "mm"},
    {"first tread head.", totals.first_tread.heading_rad, kDegrees, "deg"}};
}

}  // namespace stetro_bringup
