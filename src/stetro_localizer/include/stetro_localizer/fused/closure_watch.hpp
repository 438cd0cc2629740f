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

#ifndef STETRO_LOCALIZER__FUSED__CLOSURE_WATCH_HPP_
#define STETRO_LOCALIZER__FUSED__CLOSURE_WATCH_HPP_

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "stetro_localizer/samples.hpp"

namespace stetro_localizer
{

/// Compares the contact closure of a tread with what y was said to be off by at most.
/**
 * Eq. (3) of S-B is what y misses the left wall by, before that contact is used, and the right one.
 * Each miss should stay below the protection level across that was in force, and the left one may
 * have the error of the width on top.
 */
class ClosureWatch
{
public:
  /// Takes the switches before they are used.
  /**
   * \param across_m protection level in force [m], NaN: unknown
   * \param width_m bound of the width's error at the same risk [m]
   */
  void note(const ContactSample & sample, double across_m, double width_m)
  {
    for (const bool left : {true, false}) {
      const auto & bumpers = left ? sample.left : sample.right;
      const bool touches = std::any_of(
        bumpers.begin(), bumpers.end(), [](const Switch & one) { return one.is_closed(); });
      OfSide & side = sides_[left ? 0 : 1];
      if (touches && !side.touches && sample.stamp - side.touched_at > kSameTouch) {
        side.allowed_m = across_m + (left ? width_m : 0.0);
      }
      side.touched_at = touches ? sample.stamp : side.touched_at;
      side.touches = touches;
    }
  }

  /// \param closure_m of this tread, once both walls were touched
  [[nodiscard]] bool violated(std::optional<double> closure_m) const
  {
    return closure_m && std::abs(*closure_m) > sides_[0].allowed_m + sides_[1].allowed_m;
  }

private:
  static constexpr Nanoseconds kSameTouch = std::chrono::seconds(1);

  struct OfSide
  {
    bool touches = false;
    Nanoseconds touched_at{0};
    double allowed_m = std::numeric_limits<double>::quiet_NaN();  // compares with nothing
  };
  std::array<OfSide, 2> sides_{};  // left, right
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__CLOSURE_WATCH_HPP_
