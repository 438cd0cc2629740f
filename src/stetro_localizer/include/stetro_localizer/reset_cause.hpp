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

#ifndef STETRO_LOCALIZER__RESET_CAUSE_HPP_
#define STETRO_LOCALIZER__RESET_CAUSE_HPP_

#include <cstdint>

namespace stetro_localizer
{

/// Why the estimate jumped: it was set, instead of corrected by a measurement.
enum class ResetCause : std::uint8_t {
  kNone,          ///< it never did
  kRestarted,     ///< begun from what another run stored; what it knew of x and y is gone
  kTold,          ///< a person told the pose
  kLocatedAgain,  ///< the step had been unknown, or was two away: x began anew
  kStepUndone,    ///< a step that had been counted was taken back
  kAcrossAnew,    ///< y had contradicted its ranges for too long, and was measured anew
  kHeadingAnew,   ///< the heading likewise
  kCorrected      ///< two corrections agreed with each other
};

/// In words, for logs and diagnostics.
[[nodiscard]] const char * to_string(ResetCause cause);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__RESET_CAUSE_HPP_
