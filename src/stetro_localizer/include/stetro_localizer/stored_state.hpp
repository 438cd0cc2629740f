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

#ifndef STETRO_LOCALIZER__STORED_STATE_HPP_
#define STETRO_LOCALIZER__STORED_STATE_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "stetro_localizer/range_offset.hpp"
#include "stetro_localizer/scalar_estimate.hpp"
#include "stetro_localizer/step_counter.hpp"

namespace stetro_localizer
{

/// The constant errors that were learned.
struct Calibration
{
  RangeOffset left;              ///< of `side_left`
  RangeOffset right;             ///< of `side_right`
  RangeOffset front_difference;  ///< of front_left - front_right
  ScalarEstimate gyro_bias;      ///< [rad/s]
};

/// Constant errors that the fused estimator learned, with what it knows of their doubt.
struct FusedCalibration
{
  /// Offset [m] and gain [-] of each `Ranger` in turn; scale of the wheels [-].
  static constexpr std::size_t kSize = 11;
  std::array<double, kSize> value{};
  std::array<std::array<double, kSize>, kSize> covariance{};
};

/// What survives a restart.
struct StoredState
{
  std::string segment_id;         ///< flight that the step belongs to, or floor; empty: unknown
  std::optional<StepState> step;  ///< nothing: unknown, or on a floor
  Calibration calibration;
  std::optional<FusedCalibration> fused;  ///< nothing: another estimator wrote this
  std::uint32_t reset_counter = 0;        ///< jumps of the estimate so far
};

/// The state as text, one `key value` a line; exact for every double.
[[nodiscard]] std::string to_text(const StoredState & state);

/// The inverse. Nothing, and `why` says it, if a line is missing, not ours or not finite.
[[nodiscard]] std::optional<StoredState> parse_stored_state(
  const std::string & text, std::string & why);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__STORED_STATE_HPP_
