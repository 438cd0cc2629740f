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

#include "stetro_localizer/measurement/side_range.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace stetro_localizer
{

SideRange::SideRange(Side side, const SideRangeParams & params) : side_(side), params_(params)
{
  const bool on_its_side = side == Side::kLeft ? params.mount_y_m >= 0.0 : params.mount_y_m <= 0.0;
  if (!on_its_side) {
    throw std::invalid_argument(
      "mount_y_m: " + std::to_string(params.mount_y_m) +
      " refused, accepted: 0 or more on the left, 0 or less on the right");
  }
}

double SideRange::reach_m(double range_m) const { return range_m + std::abs(params_.mount_y_m); }

double SideRange::y_m(double range_m, double yaw_rad, double width_m) const
{
  const double across_m = reach_m(range_m) * std::cos(yaw_rad);
  const double lever_m = params_.mount_x_m * std::sin(yaw_rad);
  return side_ == Side::kRight ? across_m - lever_m : width_m - across_m - lever_m;
}

double SideRange::range_m(double y_m, double yaw_rad, double width_m) const
{
  const double lever_m = params_.mount_x_m * std::sin(yaw_rad);
  const double across_m = side_ == Side::kRight ? y_m + lever_m : width_m - y_m - lever_m;
  return across_m / std::cos(yaw_rad) - std::abs(params_.mount_y_m);
}

double SideRange::slope_range(double yaw_rad) const
{
  return side_ == Side::kRight ? std::cos(yaw_rad) : -std::cos(yaw_rad);
}

double SideRange::slope_yaw(double range_m, double yaw_rad) const
{
  const double across = reach_m(range_m) * std::sin(yaw_rad);
  const double lever = params_.mount_x_m * std::cos(yaw_rad);
  return side_ == Side::kRight ? -across - lever : across - lever;
}

}  // namespace stetro_localizer
