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

#include "stetro_localizer/measurement/bumper_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace stetro_localizer
{

BumperContact::BumperContact(const BumperParams & params) : params_(params)
{
  if (!(params.contact_width_m > 0.0)) {
    throw std::invalid_argument(
      "contact_width_m: " + std::to_string(params.contact_width_m) +
      " refused, accepted: more than 0");
  }
}

std::optional<double> BumperContact::touching_x_m(
  const std::array<bool, 3> & closed, bool front_leans) const
{
  const double half_m = params_.block_length_m / 2.0;
  std::optional<double> foremost;
  std::optional<double> rearmost;
  for (std::size_t i = 0; i < closed.size(); ++i) {
    if (closed[i]) {
      foremost = std::max(foremost.value_or(-1e9), params_.block_x_m[i] + half_m);
      rearmost = std::min(rearmost.value_or(1e9), params_.block_x_m[i] - half_m);
    }
  }
  // The switches know better than a small heading which end leans towards the wall.
  const bool front_touches = closed.front() == closed.back() ? front_leans : closed.front();
  return front_touches ? foremost : rearmost;
}

std::optional<ContactFix> BumperContact::fix(
  Side side, const std::array<bool, 3> & closed, double yaw_rad, double yaw_variance,
  double width_m) const
{
  const bool front_leans = side == Side::kLeft ? yaw_rad > 0.0 : yaw_rad < 0.0;
  const std::optional<double> touching = touching_x_m(closed, front_leans);
  if (!touching) {
    return std::nullopt;
  }
  const double lever_m = std::abs(*touching);
  if (closed.front() && closed.back()) {  // square to the wall, as well as two bumpers can tell
    const double y_m = params_.contact_width_m / 2.0;
    return ContactFix{
      side == Side::kRight ? y_m : width_m - y_m, 1.5 * params_.sigma_m * params_.sigma_m, lever_m};
  }
  const double half_m = params_.contact_width_m / 2.0;
  const double from_wall_m = half_m * std::cos(yaw_rad) + lever_m * std::sin(std::abs(yaw_rad));
  const double slope =
    -half_m * std::sin(std::abs(yaw_rad)) + lever_m * std::cos(yaw_rad);  // d/d|psi| [m/rad]
  return ContactFix{
    side == Side::kRight ? from_wall_m : width_m - from_wall_m,
    params_.sigma_m * params_.sigma_m + slope * slope * yaw_variance, lever_m};
}

}  // namespace stetro_localizer
