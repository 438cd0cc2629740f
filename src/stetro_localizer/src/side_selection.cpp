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

#include "stetro_localizer/side_selection.hpp"

#include <stdexcept>
#include <string>

namespace stetro_localizer
{

SideSelection::SideSelection(const SideSelectionParams & params) : params_(params)
{
  if (!(params.engage_m > 0.0 && params.engage_m <= params.release_m)) {
    throw std::invalid_argument(
      "engage_m: " + std::to_string(params.engage_m) +
      " refused, accepted: more than 0, at most release_m of " + std::to_string(params.release_m));
  }
}

bool SideSelection::is_fit(const std::optional<SideFix> & fix, bool was_fit) const
{
  return fix && fix->range_m < (was_fit ? params_.release_m : params_.engage_m);
}

std::optional<LateralFix> SideSelection::choose(
  const std::optional<SideFix> & left, const std::optional<SideFix> & right)
{
  left_fit_ = is_fit(left, left_fit_);
  right_fit_ = is_fit(right, right_fit_);
  if (left_fit_ && right_fit_) {
    const double weight_left = right->variance_m2 / (left->variance_m2 + right->variance_m2);
    const double weight_right = 1.0 - weight_left;
    return LateralFix{
      weight_left * left->y_m + weight_right * right->y_m,
      left->variance_m2 * weight_left,  // 1 / (1/v_l + 1/v_r)
      weight_left * left->slope_yaw + weight_right * right->slope_yaw, true, true};
  }
  if (left_fit_) {
    return LateralFix{left->y_m, left->variance_m2, left->slope_yaw, true, false};
  }
  if (right_fit_) {
    return LateralFix{right->y_m, right->variance_m2, right->slope_yaw, false, true};
  }
  return std::nullopt;
}

}  // namespace stetro_localizer
