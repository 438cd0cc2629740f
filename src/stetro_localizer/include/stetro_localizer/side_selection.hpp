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

#ifndef STETRO_LOCALIZER__SIDE_SELECTION_HPP_
#define STETRO_LOCALIZER__SIDE_SELECTION_HPP_

#include <optional>

namespace stetro_localizer
{

/// y as one side range gives it.
struct SideFix
{
  double range_m = 0.0;      ///< averaged range, as read [m]
  double y_m = 0.0;          ///< distance of `base_link` from the right wall [m]
  double variance_m2 = 0.0;  ///< of y without the part both sides share [m^2]
  double slope_yaw = 0.0;    ///< dy/dpsi [m/rad]
};

/// y as the chosen side ranges give it.
struct LateralFix
{
  double y_m;
  double variance_m2;  ///< of y without the part that comes from the heading [m^2]
  double slope_yaw;    ///< dy/dpsi of the mixture [m/rad]
  bool left;           ///< the left range is in it
  bool right;          ///< the right range is in it
};

/// Limits of the 120 cm rule.
struct SideSelectionParams
{
  double release_m = 1.20;  ///< a range in use is dropped above this [m]
  double engage_m = 1.15;   ///< a range out of use is taken below this [m]
};

/// Chooses between the side ranges: the papers' "120 cm rule", made complete.
/**
 * Algorithm I says "if sensor output < 120" and names no sensor; both may be below, neither may be,
 * and one may be invalid (D1-5). Here: a side is fit while its average is valid and below 1.20 m,
 * and becomes fit again below 1.15 m. Both fit: the mean weighted by inverse variance. One fit: that
 * one. None: nothing, and the caller predicts and says so. An invalid reading has no average; one
 * that slips through as 65535 mm or 8190 mm is far above the limit.
 */
class SideSelection
{
public:
  /// \throws std::invalid_argument unless 0 < engage_m <= release_m
  explicit SideSelection(const SideSelectionParams & params);

  [[nodiscard]] std::optional<LateralFix> choose(
    const std::optional<SideFix> & left, const std::optional<SideFix> & right);

  [[nodiscard]] bool left_fit() const { return left_fit_; }
  [[nodiscard]] bool right_fit() const { return right_fit_; }

private:
  [[nodiscard]] bool is_fit(const std::optional<SideFix> & fix, bool was_fit) const;

  SideSelectionParams params_;
  bool left_fit_ = false;
  bool right_fit_ = false;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__SIDE_SELECTION_HPP_
