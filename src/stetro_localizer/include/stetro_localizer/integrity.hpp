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

#ifndef STETRO_LOCALIZER__INTEGRITY_HPP_
#define STETRO_LOCALIZER__INTEGRITY_HPP_

#include <cstdint>
#include <string>

namespace stetro_localizer
{

/// How far the estimate may be trusted.
enum class Integrity {
  kOk,        ///< measured, and nothing contradicts it
  kDegraded,  ///< going on a prediction or against a contradiction: finish or hold, do not start
  kLost       ///< not to be used
};

/// Why integrity is not OK: bits, with the values they have on the wire.
enum Reason : std::uint32_t {
  kNoSideRange = 1u << 0,          ///< y is predicted by the wheels
  kNoFrontReference = 1u << 1,     ///< the heading and x lack a riser; by itself no doubt
  kStepUncertain = 1u << 2,        ///< the step evidence is missing or contradicts itself
  kNotInitialised = 1u << 3,       ///< nobody has told the step yet
  kInputSilent = 1u << 4,          ///< an input has stopped
  kCalibrationDamaged = 1u << 5,   ///< the state file could not be used
  kClosureViolated = 1u << 6,      ///< left and right range do not add up to the width
  kSensorStuck = 1u << 7,          ///< a sensor repeats itself
  kSensorDead = 1u << 8,           ///< a sensor has stopped to answer
  kProfileDisagrees = 1u << 9,     ///< corrections contradict the pose
  kProtectionExceeded = 1u << 10,  ///< the error may be larger than the task allows
  kContactConflict = 1u << 12,     ///< a switch and a range contradict each other
  kSlip = 1u << 13,                ///< wheels and ranges contradict each other
  kSensorCalibration = 1u << 14,   ///< a range sensor's offset or gain is beyond trust: it is dirty
  kHeadingConflict = 1u << 15,     ///< front pair and gyroscope contradict each other
  kOffTread = 1u << 16,            ///< x is not on the tread that block 2 stands on
  kContactClosure = 1u << 17       ///< y missed the walls by more than it was said to be off
};

/// The integrity that a set of reasons makes.
[[nodiscard]] constexpr Integrity integrity_of(std::uint32_t reasons, bool step_known)
{
  if (!step_known) {
    return Integrity::kLost;
  }
  return reasons == 0 ? Integrity::kOk : Integrity::kDegraded;
}

[[nodiscard]] const char * to_string(Integrity integrity);

/// The reasons by name, separated by commas; empty for none.
[[nodiscard]] std::string reason_names(std::uint32_t reasons);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__INTEGRITY_HPP_
