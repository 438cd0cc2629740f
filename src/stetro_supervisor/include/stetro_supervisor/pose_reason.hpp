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
#ifndef STETRO_SUPERVISOR__POSE_REASON_HPP_
#define STETRO_SUPERVISOR__POSE_REASON_HPP_

#include <cstdint>
#include <string>

namespace stetro_supervisor
{

/// Why the localizer's integrity is not OK: bits of `StairPose::reasons`, as on the wire.
enum PoseReason : std::uint32_t {
  kNoSideRange = 1u << 0,
  kNoFrontReference = 1u << 1,
  kStepUncertain = 1u << 2,
  kNotInitialised = 1u << 3,
  kInputSilent = 1u << 4,
  kCalibrationDamaged = 1u << 5,
  kClosureViolated = 1u << 6,
  kSensorStuck = 1u << 7,
  kSensorDead = 1u << 8,
  kProfileDisagrees = 1u << 9,
  kProtectionExceeded = 1u << 10,
  kClockJump = 1u << 11,
  kContactConflict = 1u << 12,
  kSlip = 1u << 13,
  kSensorCalibration = 1u << 14,
  kHeadingConflict = 1u << 15,
  kOffTread = 1u << 16,
  kContactClosure = 1u << 17
};

/// Reasons of DEGRADED, as on the wire, that the next wall or riser takes away while standing still
/// never would: no side range, no front reference, sides that do not add up, slip, a doubt about
/// y or heading, a contact that came too early or too late.
constexpr std::uint32_t kBearableReasons = kNoSideRange | kNoFrontReference | kClosureViolated |
                                           kSlip | kProtectionExceeded | kHeadingConflict |
                                           kContactClosure;

/// The reasons in words, separated by commas; bits without a name by their value.
std::string reasons_in_words(std::uint32_t reasons);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__POSE_REASON_HPP_
